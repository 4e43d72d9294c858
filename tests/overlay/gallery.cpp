// overlay_gallery WxH LANGUAGE OUT.png [PX_PER_MM] [booth|panel|expert|caption|hint|notice|focus|lamps=N]...
// Paints a whole screen of the overlay over a gray scene, to be looked at.
#include <cstdio>
#include <string>

#include "base/error.h"
#include "base/files.h"
#include "base/names.h"
#include "base/numbers.h"
#include "image/png.h"
#include "overlay/painter.h"
#include "overlay/sample_screen.h"
#include "overlay/theme.h"

namespace {

using namespace metamer;

bool take_word(const std::string& word, Sample& sample, bool& focus) {
    Contents& contents = sample.contents;
    if (word.starts_with("lamps="))
        contents.lamps = parse_whole(word.substr(6)).value_or(contents.lamps);
    else if (const auto px_per_mm = parse_number(word))
        sample.screen.px_per_mm = *px_per_mm;
    else if (bool* flag = word == "booth"     ? &contents.booth
                          : word == "panel"   ? &contents.panel
                          : word == "expert"  ? &contents.expert
                          : word == "caption" ? &contents.caption
                          : word == "hint"    ? &contents.hint
                          : word == "notice"  ? &contents.notice
                          : word == "focus"   ? &focus
                                              : nullptr)
        *flag = true;
    else
        return false;
    return true;
}

void lay_over(Image& image, const Picture& picture, const PxBox& box) {
    for (int y = 0; y < picture.height_px; ++y)
        for (int x = 0; x < picture.width_px; ++x) {
            const auto* from = &picture.rgba[static_cast<std::size_t>(4 * (y * picture.width_px + x))];
            auto* to =
                &image.rgba[static_cast<std::size_t>(4 * ((box.top + y) * image.width + box.left + x))];
            for (int c = 0; c < 3; ++c)
                to[c] = static_cast<std::uint8_t>(from[c] + to[c] * (255 - from[3]) / 255);
        }
}

/// The backdrop, and a scene of two grays parted by the split.
Image empty_screen(const Sample& sample, const PxBox& scene) {
    Image image{sample.screen.width_px, sample.screen.height_px, {}};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t gray = x < sample.split * image.width ? 0x8C : 0xA4;
            const Srgb color = scene.contains(x, y) ? Srgb{gray, gray, gray} : kBackdrop;
            image.rgba.insert(image.rgba.end(), {color[0], color[1], color[2], 255});
        }
    return image;
}

} // namespace

int main(int argc, char** argv) try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const std::vector<std::string> size = words.empty() ? words : split(words[0], 'x');
    Sample sample;
    sample.screen.px_per_mm = 0;
    sample.contents.lamps = 12;
    bool focus = false, good = words.size() >= 3 && size.size() == 2;
    for (std::size_t i = 3; i < words.size(); ++i)
        good = take_word(words[i], sample, focus) && good;
    if (!good)
        throw bad_input("read", "the arguments", "WxH LANGUAGE OUT.png [PX_PER_MM] [booth] [panel] ...");
    sample.screen.width_px = parse_whole(size[0]).value_or(1280);
    sample.screen.height_px = parse_whole(size[1]).value_or(720);
    sample.language = words[1];
    SampleScreen screen = sample_screen(Words(), sample);
    Png png;
    png.image = empty_screen(sample, screen.layout.scene);
    for (Widget& widget : screen.widgets) {
        widget.focused = focus && widget.part == Part::lamp && widget.index == 1;
        const Picture picture = paint(widget, screen.layout.unit_px);
        if (picture.text_cut)
            std::printf("cut: %s\n", widget.text.c_str());
        lay_over(png.image, picture, widget.box);
    }
    write_file(words[2], encode_png(png, false));
} catch (const Error& error) {
    std::fprintf(stderr, "overlay_gallery: %s\n", error.what());
    return static_cast<int>(error.status());
}
