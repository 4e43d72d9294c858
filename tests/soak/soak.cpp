// soak: the kiosk without a screen, through as many frames as it is told, touched at random, its files
// mutated, its context lost. Says what it held at each check; ends with 1 where that grew.
#include <algorithm>
#include <charconv>
#include <cstring>
#include <iostream>
#include <span>

#include "base/printed.h"
#include "soak/run.h"

namespace {

using metamer::test::Plight;
using metamer::test::Run;
using metamer::test::Vitals;

/// Caches of fonts and shaders fill in the first part of a run, and the driver drops programs when it likes:
/// what counts is the least that is held, which a leak lifts. Few checks may miss the least: they have as
/// much room as what is held wavers by, and LeakSanitizer watches short runs.
constexpr std::size_t kMostGrowth = 4 << 20, kMostResidentGrowth = 16 << 20, kWavering = 48 << 20;
constexpr std::size_t kManyChecks = 24;

template <class T>
bool take(std::string_view argument, std::string_view name, T& value) {
    if (!argument.starts_with(name))
        return false;
    const std::string_view number = argument.substr(name.size());
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    return error == std::errc() && end == number.data() + number.size() && value > 0;
}

/// From the warm third on: the least of the end against the least before.
bool flat(const std::vector<Vitals>& checks) {
    const auto third = static_cast<std::ptrdiff_t>(checks.size() / 3);
    const std::span<const Vitals> middle(checks.begin() + third, checks.begin() + 2 * third);
    const std::span<const Vitals> end(checks.begin() + 2 * third, checks.end());
    const auto least = [](std::span<const Vitals> some, auto value) {
        return std::ranges::min(some, {}, value).*value;
    };
    bool held = true;
    const auto hold = [&](const char* what, auto value, std::size_t growth) {
        const auto before = static_cast<std::size_t>(least(middle, value));
        const auto after = static_cast<std::size_t>(least(end, value));
        if (after > before + growth) {
            std::cerr << "soak: " << what << " grew from " << before << " to " << after << '\n';
            held = false;
        }
    };
    hold("what is allocated", &Vitals::allocated, checks.size() < kManyChecks ? kWavering : kMostGrowth);
#if !defined(__SANITIZE_ADDRESS__) // which keeps what was freed
    hold("what is resident", &Vitals::resident, kMostResidentGrowth);
#endif
    hold("the number of descriptors", &Vitals::descriptors, 0);
    hold("the number of threads", &Vitals::threads, 0);
    hold("the number of GL objects", &Vitals::gl_objects, 0);
    return held;
}

} // namespace

int main(int argc, char** argv) {
    Plight plight;
    for (const char* word : std::span(argv, static_cast<std::size_t>(argc)).subspan(1)) {
        const std::string_view argument(word);
        if (!take(argument, "--frames=", plight.frames) &&
            !take(argument, "--mutations=", plight.mutations) &&
            !take(argument, "--losses=", plight.losses) && !take(argument, "--checks=", plight.checks) &&
            !take(argument, "--seed=", plight.seed)) {
            std::cerr << "usage: soak [--frames=N] [--mutations=N] [--losses=N] [--checks=N] [--seed=N]\n";
            return 2;
        }
    }
    if (plight.checks < 6) {
        std::cerr << "soak: cannot tell growth from less than 6 checks\n";
        return 2;
    }
    try {
        Run run(plight);
        run.live();
        std::cout << metamer::printed("%.1f days\n", run.simulated_s() / 86400);
        for (const auto& [kind, count] : run.events())
            std::cout << kind << ": " << count << '\n';
        std::cout << "changes of files noticed: " << run.noticed_changes() << '\n';
        return flat(run.checks()) ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << "soak: " << error.what() << '\n';
        return 1;
    }
}
