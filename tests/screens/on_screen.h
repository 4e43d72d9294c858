// A kiosk on an X server of its own, with hands and eyes on it.
#pragma once

#include <filesystem>
#include <gmock/gmock.h>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "screens/running_kiosk.h"
#include "window/rotation.h"
#include "window/x_screen.h"

namespace metamer::test {

/// Flat patches, so that colors stand at known places; rows that take no time. Left: three numbers, right: 64
/// wavelengths.
inline constexpr const char* kPatches =
    "[atlas]\nquantization = thesis\n[scene]\nkind = patches\n"
    "materials = cc-orange, cc-blue, crayon-white, crayon-red, cc-cyan, crayon-green\n"
    "[lamp.1]\nspectrum = F11\n"
    "[compare]\nleft.method = tristimulus\nright.method = spectral\n"
    "[kiosk]\nlamps = D65, F11, A2800, krypton\n";

class OnScreen : public testing::Test {
protected:
    OnScreen();
    ~OnScreen() override;
    void SetUp() override;

    /// A screen of this size, and on it the kiosk with this exhibit; waits until it shows it. `rotation_deg`
    /// is also the exhibit's.
    void start(PxSize screen, const std::string& exhibit = kPatches, int rotation_deg = 0);
    /// The same in two steps; the environment is the kiosk's alone.
    void open_screen(PxSize screen);
    void start_kiosk(const std::string& exhibit, int rotation_deg,
                     const std::map<std::string, std::string>& environment = {});

    /// The exhibit's file as a whole, as an editor saves it.
    void write_exhibit(const std::string& text) const;

    /// In the picture as people see it.
    void tap(double x_px, double y_px) const;
    void tap(const std::string& part, int index = 0);
    void drag(double x_px, double y_px, double to_x_px, double to_y_px) const;
    void key(const std::string& name) const { screen_->act({"key", name}); }

    /// A color that the twin knows: at as many places of the scene as lie free of widgets, edges and the
    /// split, on both sides of it. `sets` say what the visitor chose, as `--set` would. Waits for it: a fade
    /// may go on. What remains wrong in the end, as text; empty where nothing does.
    std::string wrong_colors(const std::vector<std::string>& sets = {});

    /// Every widget has a size and lies inside the screen.
    static void expect_all_inside(const Json& told);

    std::filesystem::path folder_;
    std::optional<XScreen> screen_;
    std::optional<RunningKiosk> kiosk_;
    PxSize size_;
    int rotation_deg_ = 0;
};

} // namespace metamer::test
