#include "screens/on_screen.h"

#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>
#include <unistd.h>

#include "base/files.h"
#include "screens/scene_twin.h"

namespace metamer::test {

namespace fs = std::filesystem;

namespace {

constexpr int kColumns = 24, kRows = 10, kMostSteps = 2, kFewestPlaces = 6, kPatience = 200;

struct Box {
    double left, top, width, height;
    explicit Box(const Json& box) : left(box[0]), top(box[1]), width(box[2]), height(box[3]) {}
    /// Or near it.
    bool about(double x, double y) const {
        constexpr double kNear = 3;
        return x > left - kNear && x < left + width + kNear && y > top - kNear && y < top + height + kNear;
    }
};

bool covered(const Json& told, double x, double y) {
    for (const Json& one : told.at("widgets"))
        if (Box(one.at("box")).about(x, y))
            return true;
    return false;
}

std::string whole(double px) {
    return std::to_string(std::lround(px));
}

/// What differs between a screen and its twin.
class Comparison {
public:
    Comparison(const Json& told, const Shot& shot, int rotation_deg)
        : told_(told),
          shot_(shot),
          rotation_deg_(rotation_deg),
          scene_(told.at("scene")),
          split_(told.at("split")) {}

    std::string with(const SceneTwin& twin) {
        for (int i = 0; i < kColumns * kRows; ++i)
            look((i % kColumns + 0.5) / kColumns, (i / kColumns + 0.5) / kRows, twin);
        // Without a split one half is all.
        for (const int half : {0, 1})
            if (places_[half] < kFewestPlaces && split_ > 0 && split_ < 1)
                wrong_ << "only " << places_[half] << " places in half " << half << '\n';
        return wrong_.str();
    }

private:
    void look(double x, double y, const SceneTwin& twin) {
        const double px = std::floor(scene_.left + x * scene_.width);
        const double py = std::floor(scene_.top + y * scene_.height);
        if (covered(told_, px, py) || std::abs(x - split_) * scene_.width < 5)
            return;
        const int half = x < split_ ? 0 : 1;
        const auto expected = twin.color(x, y, static_cast<std::size_t>(half), 3 / scene_.height);
        if (!expected)
            return;
        ++places_[half];
        const PxPoint at =
            surface_from_picture({px + 0.5, py + 0.5}, {shot_.width_px, shot_.height_px}, rotation_deg_);
        const auto& seen = shot_.at(static_cast<int>(at.x_px), static_cast<int>(at.y_px));
        if (std::abs(seen[0] - expected->r) > kMostSteps || std::abs(seen[1] - expected->g) > kMostSteps ||
            std::abs(seen[2] - expected->b) > kMostSteps)
            wrong_ << "at " << px << ' ' << py << ": " << seen[0] << ' ' << seen[1] << ' ' << seen[2]
                   << " where " << int{expected->r} << ' ' << int{expected->g} << ' ' << int{expected->b}
                   << " belongs\n";
    }

    const Json& told_;
    const Shot& shot_;
    int rotation_deg_;
    Box scene_;
    double split_;
    int places_[2] = {};
    std::ostringstream wrong_;
};

} // namespace

OnScreen::OnScreen()
    : folder_(fs::canonical(fs::temp_directory_path()) / ("metamer-screens-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
}

OnScreen::~OnScreen() {
    kiosk_.reset(); // before its screen
    fs::remove_all(folder_);
}

void OnScreen::SetUp() {
    ASSERT_EQ(missing_for_x(), "");
}

void OnScreen::start(PxSize screen, const std::string& exhibit, int rotation_deg) {
    open_screen(screen);
    start_kiosk(exhibit, rotation_deg);
}

void OnScreen::open_screen(PxSize screen) {
    size_ = screen;
    screen_.emplace(screen.width_px, screen.height_px);
}

void OnScreen::start_kiosk(const std::string& exhibit, int rotation_deg,
                           const std::map<std::string, std::string>& environment) {
    rotation_deg_ = rotation_deg;
    write_exhibit(exhibit + "[display]\nrotation = " + std::to_string(rotation_deg) + "\n");
    kiosk_.emplace(folder_, std::vector<std::string>{"exhibit.ini"}, environment);
    // Before its picture stands on the screen, its window may not be there for a finger to hit.
    ASSERT_EQ(wrong_colors(), "") << kiosk_->log();
}

void OnScreen::write_exhibit(const std::string& text) const {
    write_file(folder_ / "exhibit.ini", text);
}

void OnScreen::tap(double x_px, double y_px) const {
    const PxPoint at = surface_from_picture({x_px, y_px}, size_, rotation_deg_);
    screen_->act({"mousemove", whole(at.x_px), whole(at.y_px), "click", "1"});
}

void OnScreen::tap(const std::string& part, int index) {
    const Json found = widget(kiosk_->told(), part, index);
    ASSERT_FALSE(found.is_null()) << part << ' ' << index;
    const Box box(found.at("box"));
    tap(box.left + box.width / 2, box.top + box.height / 2);
}

void OnScreen::drag(double x_px, double y_px, double to_x_px, double to_y_px) const {
    const PxPoint from = surface_from_picture({x_px, y_px}, size_, rotation_deg_);
    const PxPoint half =
        surface_from_picture({(x_px + to_x_px) / 2, (y_px + to_y_px) / 2}, size_, rotation_deg_);
    const PxPoint to = surface_from_picture({to_x_px, to_y_px}, size_, rotation_deg_);
    screen_->act({"mousemove", whole(from.x_px), whole(from.y_px), "mousedown", "1", "mousemove",
                  whole(half.x_px), whole(half.y_px), "mousemove", whole(to.x_px), whole(to.y_px), "mouseup",
                  "1"});
}

std::string OnScreen::wrong_colors(const std::vector<std::string>& sets) {
    const SceneTwin twin(read_file(folder_ / "exhibit.ini"), sets);
    std::string wrong;
    for (int i = 0; i < kPatience; ++i) {
        const Json told = kiosk_->told();
        wrong = Comparison(told, screen_->shot(), rotation_deg_).with(twin);
        if (wrong.empty())
            return {};
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return wrong;
}

void OnScreen::expect_all_inside(const Json& told) {
    const double width = told.at("width_px"), height = told.at("height_px");
    for (const Json& one : told.at("widgets")) {
        const Box box(one.at("box"));
        EXPECT_TRUE(box.left >= 0 && box.top >= 0 && box.width > 0 && box.height > 0 &&
                    box.left + box.width <= width && box.top + box.height <= height)
            << one;
        EXPECT_NE(one.at("text"), "") << one;
    }
}

} // namespace metamer::test
