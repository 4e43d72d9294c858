// The files that a kiosk lives on, and what may befall them.
#pragma once

#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace metamer::test {

/// A folder of an exhibit's files, from construction to destruction: the INI, an atlas, spectra, maps,
/// strings.
class World {
public:
    World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;
    ~World();

    const std::filesystem::path& exhibit() const { return exhibit_; }

    /// Every file as it should be. `scene`: which of the exhibits stands there, modulo how many there are.
    void restore(std::size_t scene);

    /// One file cut short, or with some bytes others; now and then gone.
    void befall(std::mt19937& rng);

private:
    struct File {
        std::filesystem::path path;
        std::string good;
    };
    void add(const std::string& name, std::string bytes);

    std::filesystem::path folder_, exhibit_;
    std::vector<File> files_; ///< the INI first
    std::size_t scene_ = 0;
};

} // namespace metamer::test
