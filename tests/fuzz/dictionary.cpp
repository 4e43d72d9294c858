// Prints libFuzzer's dictionary for a target, from the tables that the program itself reads by:
// fuzz_dictionary ini | strings | atlas | spectrum.
#include <iostream>
#include <set>
#include <string>

#include "exhibit/keys.h"
#include "overlay/words.h"
#include "spectra/library.h"

namespace metamer::fuzz {

namespace {

/// libFuzzer takes no longer words.
constexpr std::size_t kLongest = 64;

std::set<std::string> words_of_exhibits() {
    std::set<std::string> words{"yes",
                                "no",
                                "22:00-07:00",
                                "640px",
                                "atlas.png",
                                "map.png",
                                "lamp.csv#thin",
                                "paint.csv",
                                "gauss:530:20",
                                "line:589.3",
                                "planck:2856",
                                "daylight:5000",
                                "rgb:ED0A3F",
                                "absorb:590:50:1",
                                "1e6",
                                "0x10",
                                "-1",
                                "nan"};
    for (const KeyInfo& key : keys()) {
        const std::string section(key.section);
        const std::size_t number = section.find(".N");
        words.insert("[" + (number == std::string::npos ? section : section.substr(0, number) + ".1") +
                     "]\n");
        words.insert(std::string(key.key) + " = ");
        if (key.choices)
            words.merge(std::set<std::string>([&] {
                const auto choices = key.choices();
                return std::set<std::string>(choices.begin(), choices.end());
            }()));
    }
    for (const MaterialSet& set : material_sets()) {
        words.insert(set.name);
        words.insert(set.materials.front());
    }
    for (const std::string& lamp : thesis_lamps())
        words.insert(lamp);
    return words;
}

std::set<std::string> words_of_strings() {
    std::set<std::string> words{
        "[language]\n", "name = ",   "decimal = ", "direction = ", "rtl",      "[few]\n",
        "plain = ",     "filled = ", "{number}",   "{lamp}",       "[lamp]\n", "[material]\n"};
    for (const WordKey& key : word_keys()) {
        const std::size_t dot = key.key.find('.');
        words.insert("[" + key.key.substr(0, dot) + "]\n");
        words.insert(key.key.substr(dot + 1) + " = ");
        const std::size_t open = key.english.find('{');
        if (open != std::string::npos)
            words.insert(key.english.substr(open, key.english.find('}') - open + 1));
    }
    return words;
}

/// The tables of units are csv_units.cpp's own.
std::set<std::string> words_of_spectra() {
    return {"wavelength_nm,",
            "wavelength_um,",
            "wavelength_angstrom,",
            "lambda",
            "cm-1",
            "Hz",
            "# unit: ",
            "# source: ",
            "percent",
            "photons",
            "reflectance",
            "W",
            "\"",
            "nan",
            "inf",
            "1e30",
            "1e-300",
            "380",
            "700.5",
            "\xEF\xBB\xBF",
            "\r\n",
            ";",
            "\t",
            "\xCE\xBBm"};
}

std::set<std::string> words_of_atlases() {
    return {"metamer:lamps",
            "metamer:materials",
            "metamer:quantization",
            "weighted",
            "thesis",
            "\t1e308\t",
            "\t5e-324\t",
            "\t0.5\t",
            "\t63\t",
            "\n2\t",
            "IHDR",
            "PLTE",
            "tRNS",
            "tEXt",
            "zTXt",
            "iTXt",
            "sRGB",
            "gAMA",
            "cHRM",
            "iCCP"};
}

void print(const std::set<std::string>& words) {
    constexpr const char* kDigits = "0123456789abcdef";
    for (const std::string& word : words) {
        if (word.empty() || word.size() > kLongest)
            continue;
        std::cout << '"';
        for (const char letter : word) {
            const auto c = static_cast<unsigned char>(letter);
            if (c < 0x20 || c >= 0x7f || c == '"' || c == '\\')
                std::cout << "\\x" << kDigits[c >> 4] << kDigits[c & 15];
            else
                std::cout << letter;
        }
        std::cout << "\"\n";
    }
}

} // namespace

} // namespace metamer::fuzz

int main(int argc, char** argv) {
    using namespace metamer::fuzz;
    const std::string target = argc == 2 ? argv[1] : "";
    if (target == "ini")
        print(words_of_exhibits());
    else if (target == "strings")
        print(words_of_strings());
    else if (target == "atlas")
        print(words_of_atlases());
    else if (target == "spectrum")
        print(words_of_spectra());
    else {
        std::cerr << "usage: fuzz_dictionary ini|strings|atlas|spectrum\n";
        return 2;
    }
}
