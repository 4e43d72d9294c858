#include "soak/world.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <unistd.h>

#include "atlas/atlas_file.h"
#include "base/files.h"
#include "spectra/library.h"

namespace metamer::test {

namespace fs = std::filesystem;

namespace {

/// Rows as the thesis has them take no time: it is not the fit of levels that is tried here.
constexpr std::string_view kAll =
    "[kiosk]\nidle_s = 45\nnight = 22:00-07:00\nstrings = strings\nbooth.left = own-lamp.csv\n"
    "lamps = D65, F11, own-lamp.csv, krypton\n"
    "[atlas]\nquantization = thesis\n"
    "[tour.1]\nlamp = F11\nseconds = 4\ncaption = one\n"
    "[tour.2]\nsplit = 0.25\nmaterials = cc-red, cc-blue\nseconds = 3\ncaption.de = zwei\n"
    "[compare]\nleft.method = tristimulus\n";

constexpr std::array<std::string_view, 3> kScenes{
    "[scene]\nkind = patches\nmaterials = cc-orange, cc-blue, own-paint.csv, crayon-red\n"
    "[lamp.1]\nspectrum = own-lamp.csv\n",
    "[scene]\nkind = loaf\nmaterials = cc-red, cc-cyan, own-paint.csv\n"
    "[lamp.1]\nspectrum = D65\nposition = 1 2 3\nfalloff = 1 0 0.2\nshadow = yes\nstrength = 2\n",
    "[scene]\nkind = still-life\nmaterials = cc-red, cc-green, cc-blue, cc-orange, cc-cyan, cc-magenta\n"
    "[lamp.1]\nspectrum = F11\n[lamp.2]\nspectrum = A2800\nstrength = 0.5\n"
    "[object.ball]\nkey_map = beach-ball.png\n[object.cloth]\nluminance_map = weave.png\n",
};

/// With an atlas file, whose rows are taken where names agree.
std::string exhibit_text(std::size_t scene) {
    std::string text(kAll);
    if (scene % 2 == 0)
        text.replace(text.find("quantization = thesis"), 21, "file = atlas.png");
    return text + std::string(kScenes[scene % kScenes.size()]);
}

std::string atlas_bytes() {
    Atlas atlas = empty_atlas(Quantization::thesis);
    for (const char* lamp : {"D65", "F11"})
        add_lamp(atlas, find_lamp(lamp));
    for (const char* material : {"cc-orange", "cc-blue"})
        add_material(atlas, find_material(material));
    return encode_atlas(atlas);
}

constexpr const char* kLamp = "# A lamp\n# unit: mW\nwavelength_nm,own\n380,0.2\n450,1\n500,0.4\n580,0.9\n"
                              "620,0.5\n700,0.1\n";
constexpr const char* kPaint = "# A paint\nwavelength_nm,own\n380,0.1\n450,0.2\n550,0.8\n600,0.3\n780,0.6\n";

void put(const fs::path& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

std::string mutated(std::string bytes, std::mt19937& rng) {
    const auto up_to = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n)(rng); };
    for (std::size_t i = 1 + up_to(2); i > 0 && !bytes.empty(); --i) {
        const std::size_t at = up_to(bytes.size() - 1);
        constexpr std::string_view known = "[]=:;#,.- \n\t019\"";
        const char letter = up_to(1) == 0 ? known[up_to(known.size() - 1)] : static_cast<char>(up_to(255));
        switch (up_to(4)) {
        case 0:
            bytes[at] = letter;
            break;
        case 1:
            bytes.insert(at, up_to(3), letter);
            break;
        case 2:
            bytes.erase(at, up_to(9));
            break;
        case 3:
            bytes.insert(at, bytes.substr(up_to(bytes.size() - 1), up_to(40)));
            break;
        default:
            bytes.resize(at);
        }
    }
    return bytes;
}

} // namespace

World::World() : folder_(fs::temp_directory_path() / ("metamer-soak-" + std::to_string(getpid()))) {
    const fs::path source = METAMER_SOURCE_DIR;
    fs::create_directories(folder_ / "strings");
    exhibit_ = folder_ / "exhibit.ini";
    add("exhibit.ini", {});
    add("atlas.png", atlas_bytes());
    add("own-lamp.csv", kLamp);
    add("own-paint.csv", kPaint);
    for (const char* map : {"beach-ball.png", "weave.png"})
        add(map, read_file(source / "config" / "maps" / map));
    for (const char* language : {"strings/en.ini", "strings/de.ini", "strings/ar.ini"})
        add(language, read_file(source / "config" / language));
    restore(0);
}

World::~World() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void World::add(const std::string& name, std::string bytes) {
    files_.push_back({folder_ / name, std::move(bytes)});
}

void World::restore(std::size_t scene) {
    scene_ = scene;
    files_.front().good = exhibit_text(scene);
    for (const File& file : files_)
        put(file.path, file.good);
}

void World::befall(std::mt19937& rng) {
    const auto up_to = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n)(rng); };
    // Every second time the INI, which has the most to say.
    const File& file = up_to(1) == 0 ? files_.front() : files_[up_to(files_.size() - 1)];
    if (up_to(49) == 0)
        fs::remove(file.path);
    else
        put(file.path, mutated(file.good, rng));
}

} // namespace metamer::test
