#include "report/picture.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <unistd.h>

#include "base/files.h"
#include "image/error_of.h"
#include "image/png.h"
#include "report/geometry.h"
#include "report/samples.h"

namespace metamer {
namespace {

using namespace std::string_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

namespace fs = std::filesystem;

constexpr double kInf = std::numeric_limits<double>::infinity();

class Folder {
public:
    Folder() : path_(fs::temp_directory_path() / ("metamer-report-" + std::to_string(::getpid()))) {
        fs::create_directory(path_);
    }
    ~Folder() {
        std::error_code ec;
        fs::remove_all(path_, ec);
    }
    fs::path operator/(const std::string& name) const { return path_ / name; }
    bool empty() const { return fs::is_empty(path_); }

private:
    fs::path path_;
};

// One plot without words: axes 0..1 with the points given.
Picture bare(std::vector<Series> series) {
    Picture picture{.width_px = 400, .height_px = 300};
    Plot plot;
    plot.x.low = plot.y.low = 0;
    plot.x.high = plot.y.high = 1;
    plot.series = std::move(series);
    picture.plots = {plot};
    return picture;
}

Image image_of(const Picture& picture) {
    return decode_png(picture_png(picture), "p.png").image;
}

// Where pixels are nearly of a series' color: their box, empty (right < left) without any.
Box ink(const Image& image, int color) {
    const Paint paint = series_paint(color);
    Box box{1e9, 1e9, -1, -1};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto* p =
                &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                 static_cast<std::size_t>(x))];
            const auto near = [](std::uint8_t byte, double v) { return std::abs(byte - 255 * v) < 3; };
            if (near(p[0], paint.r) && near(p[1], paint.g) && near(p[2], paint.b))
                box = {std::min<double>(box.left, x), std::min<double>(box.top, y),
                       std::max<double>(box.right, x + 1), std::max<double>(box.bottom, y + 1)};
        }
    return box;
}

constexpr int kVermilion = 2;

Series dots(std::vector<PlotPoint> points) {
    return {.points = std::move(points), .color = kVermilion, .stroke = Stroke::none};
}

TEST(PicturePng, HasInkWhereThePointsLie) {
    // Three corners tell where the axes lie; a fourth point must then be at its place between them.
    const Box corners = ink(image_of(bare({dots({{0, 0}, {1, 1}})})), kVermilion);
    const Px low{corners.left, corners.bottom}, high{corners.right, corners.top};
    const Box spot = ink(image_of(bare({dots({{0.25, 0.75}})})), kVermilion);
    const double radius = spot.width() / 2;
    EXPECT_GT(radius, 1);
    // Both boxes are whole pixels: each side is off by at most one.
    EXPECT_NEAR(spot.center().x, low.x + radius + 0.25 * (high.x - low.x - 2 * radius), 1.5);
    EXPECT_NEAR(spot.center().y, low.y - radius + 0.75 * (high.y - low.y + 2 * radius), 1.5);
}

TEST(PicturePng, IsOfItsSizeWithItsWords) {
    Picture picture = chart_picture(sample_chart(), 640, 480);
    const Png png = decode_png(picture_png(picture), "p.png");
    EXPECT_EQ(png.image.width, 640);
    EXPECT_EQ(png.image.height, 480);
    EXPECT_TRUE(png.color.srgb);
    EXPECT_EQ(png.text.at("Title"), "Speed against accuracy: still life");
    EXPECT_THAT(png.text.at("Description"), HasSubstr("llvmpipe"));
}

TEST(PicturePng, ShowsWhatIsOffTheAxisAtItsEnd) {
    const Box inside = ink(image_of(bare({dots({{0.5, 1}})})), kVermilion);
    for (const double y : {1.5, kInf, std::nan("")}) {
        const Box box = ink(image_of(bare({dots({{0.5, y}})})), kVermilion);
        ASSERT_GT(box.right, box.left) << y;
        EXPECT_NEAR(box.center().x, inside.center().x, 1.5) << y;
        EXPECT_NEAR(box.top, inside.center().y, 3) << y;
        EXPECT_GE(box.top, inside.center().y - 1) << "an arrow ends where a dot would not, " << y;
    }
    Picture log = bare({dots({{0.5, 0}})});
    log.plots[0].y = {.scale = Scale::log10, .low = 0.01, .high = 10};
    const Box zero = ink(image_of(log), kVermilion);
    const Box bottom = ink(image_of(bare({dots({{0.5, 0}})})), kVermilion);
    ASSERT_GT(zero.right, zero.left);
    EXPECT_NEAR(zero.bottom, bottom.center().y, 3);
    EXPECT_LE(zero.bottom, bottom.center().y + 1);
}

TEST(PictureSvg, TellsZeroAndInfinityFromWhatIsMerelyOffTheAxis) {
    const auto svg = [](double y) {
        Picture picture = bare({dots({{0.5, y}})});
        picture.plots[0].y = {.scale = Scale::log10, .low = 0.01, .high = 10};
        return picture_svg(picture);
    };
    EXPECT_EQ(svg(0.001), svg(0.002));
    EXPECT_NE(svg(0), svg(0.001));
    EXPECT_EQ(svg(11), svg(12));
    EXPECT_NE(svg(kInf), svg(11));
}

TEST(PicturePng, LinesBreakAtNaN) {
    const auto line = [](double middle) {
        return Series{.points = {{0.1, 0.5}, {0.4, 0.5}, {0.5, middle}, {0.6, 0.5}, {0.9, 0.5}},
                      .color = kVermilion,
                      .marker = Marker::none};
    };
    const Image whole = image_of(bare({line(0.5)})), broken = image_of(bare({line(std::nan(""))}));
    const Box box = ink(image_of(bare({dots({{0.5, 0.5}})})), kVermilion);
    const auto middle = static_cast<std::size_t>(
        4 * (static_cast<int>(box.center().y) * 400 + static_cast<int>(box.center().x)));
    EXPECT_LT(whole.rgba[middle + 2], 170);
    EXPECT_GT(broken.rgba[middle + 2], 200);
}

TEST(PicturePng, StepsAreLevelThenUpright) {
    Series steps = dots({{0.2, 0.8}, {0.8, 0.2}});
    steps.stroke = Stroke::steps;
    steps.marker = Marker::none;
    const Image image = image_of(bare({steps}));
    const Box corners = ink(image_of(bare({dots({{0.2, 0.8}, {0.8, 0.2}})})), kVermilion);
    const auto blue = [&](double x, double y) {
        return image
            .rgba[static_cast<std::size_t>(4 * (static_cast<int>(y) * 400 + static_cast<int>(x)) + 2)];
    };
    const double r = 3; // from the box of the signs to their middles
    EXPECT_LT(blue(corners.right - r, corners.top + r + 20), 215) << "upright at the right";
    EXPECT_LT(blue(corners.left + r + 20, corners.top + r), 215) << "level at the top";
    EXPECT_GT(blue(corners.left + r, corners.bottom - r - 20), 215) << "nothing at the lower left";
}

TEST(PictureBytes, AreTheSameTwice) {
    const Picture picture = chart_picture(sample_chart(), 800, 600);
    EXPECT_EQ(picture_svg(picture), picture_svg(picture));
    EXPECT_EQ(picture_png(picture), picture_png(picture));
}

TEST(PictureSvg, IsOutlinesWithItsWordsBeside) {
    Picture picture = bare({});
    picture.title = "a <b> & \"c\"";
    picture.note = "]]>";
    const std::string svg = picture_svg(picture);
    EXPECT_THAT(svg, StartsWith("<?xml"));
    EXPECT_THAT(svg, HasSubstr("width=\"400px\" height=\"300px\""));
    EXPECT_THAT(svg, HasSubstr("<title>a &lt;b&gt; &amp; \"c\"</title>"));
    EXPECT_THAT(svg, HasSubstr("]]&gt;"));
    EXPECT_THAT(svg, Not(HasSubstr("<text")));
    EXPECT_THAT(svg, Not(HasSubstr("<image"))) << "everything is vectors";
}

std::vector<std::string> hostile() {
    return {"<script>&amp;\"'",
            "]]>",
            "\xFF\xC3",
            "a\nb\0c"s,
            "Lumière ナトリウム 💡",
            std::string(20000, 'W'),
            std::string(300, ' '),
            std::string("\xE2\x80\xAE") + "mirror"};
}

TEST(Pictures, TakeAnyName) {
    for (const std::string& name : hostile()) {
        Picture picture =
            bare({{.label = name, .second_line = name, .points = {{.x = 0.5, .y = 0.5, .label = name}}}});
        picture.title = picture.subtitle = picture.note = name;
        picture.key = {{.text = name}};
        Plot& plot = picture.plots[0];
        plot.title = plot.caption = plot.x.title = plot.y.title = name;
        plot.marks = {{0.2, 0.2, name}};
        plot.lines = {{ReferenceLine::At::y, 0.3, name}};
        plot.regions = {{.x_low = 0.7, .label = name}};
        EXPECT_EQ(error_of([&] { picture_svg(picture); }), "no error") << name.substr(0, 20);
        EXPECT_EQ(image_of(picture).width, 400) << name.substr(0, 20);
    }
}

TEST(Pictures, TakeNothing) {
    EXPECT_EQ(error_of([] { picture_svg({}); }), "no error");
    EXPECT_EQ(error_of([] { picture_png(bare({Series{}})); }), "no error");
    Picture picture;
    picture.plots.resize(3);
    picture.plots[1].x.scale = picture.plots[1].y.scale = Scale::log10;
    EXPECT_EQ(error_of([&] { picture_png(picture); }), "no error");
}

TEST(Pictures, TakeAnyNumbers) {
    const double values[] = {0, -1, 1, 5e-324, 1e300, kInf, -kInf, std::nan("")};
    for (const Scale scale : {Scale::linear, Scale::log10}) {
        Series series{.label = "s"};
        for (const double x : values)
            for (const double y : values)
                if (!std::isnan(x))
                    series.points.push_back({x, y, Spread{y, x, y}, Spread{x, y, x}});
        Picture picture{.plots = {{.x = {.scale = scale}, .y = {.scale = scale}, .series = {series}}}};
        EXPECT_EQ(error_of([&] { picture_svg(picture); }), "no error");
        EXPECT_THAT(picture_svg(picture), Not(HasSubstr("nan")));
    }
}

TEST(Pictures, RefuseWhatNoOneCouldRead) {
    Picture picture{.title = "t", .width_px = 100};
    EXPECT_EQ(error_of([&] { picture_svg(picture); }),
              "2: cannot draw t: its size is 100x800, outside 320x240 .. 4096x4096");
    picture = {.title = "t", .columns = 0};
    EXPECT_EQ(error_of([&] { picture_png(picture); }), "2: cannot draw t: it has 0 columns");
    picture = {.width_px = 320, .height_px = 240, .plots = std::vector<Plot>(12, Plot{.title = "p"})};
    EXPECT_EQ(error_of([&] { picture_svg(picture); }),
              "2: cannot draw the plot p: there is no room for it; draw a larger picture");
    picture = bare({{.label = "s", .points = {{std::nan(""), 0}}}});
    EXPECT_EQ(error_of([&] { picture_svg(picture); }), "2: cannot draw s: a point has no x");
}

TEST(WritePicture, WritesWhatTheEndingSays) {
    const Folder folder;
    const Picture picture = bare({});
    write_picture(folder / "p.svg", picture);
    write_picture(folder / "p.PNG", picture);
    EXPECT_EQ(read_file(folder / "p.svg"), picture_svg(picture));
    EXPECT_EQ(read_file(folder / "p.PNG"), picture_png(picture));
}

TEST(WritePicture, LeavesNothingBehindWhenItCannot) {
    const Folder folder;
    EXPECT_EQ(error_of([&] { write_picture(folder / "p.gif", bare({})); }),
              "2: cannot write " + (folder / "p.gif").string() + ": a picture ends in .svg or .png");
    EXPECT_THAT(error_of([&] { write_picture(folder / "no" / "p.svg", bare({})); }),
                HasSubstr(": there is no folder "));
    EXPECT_THAT(error_of([&] { write_picture(folder / "p.svg", {.width_px = 1}); }),
                HasSubstr("its size is 1x800"));
    EXPECT_TRUE(folder.empty());
    fs::create_symlink("/dev/full", folder / "full.svg");
    EXPECT_EQ(error_of([&] { write_picture(folder / "full.svg", bare({})); }),
              "1: cannot write " + (folder / "full.svg").string() + ": No space left on device");
}

} // namespace
} // namespace metamer
