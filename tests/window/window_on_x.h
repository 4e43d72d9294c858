// A test with an X server of its own.
#pragma once

#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "window/event_text.h"
#include "window/stage.h"
#include "window/x_screen.h"

namespace metamer::test {

class WindowOnX : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(missing_for_x(), "");
        screen_.emplace(320, 240);
    }

    /// The window's events until one is `last`; what was read so far where nothing more comes for a long
    /// time.
    static std::vector<std::string> read_until(Stage& stage, const std::string& last) {
        constexpr double kLong_s = 30;
        std::vector<std::string> all;
        for (std::vector<Event> events; !(events = stage.wait(kLong_s)).empty();)
            for (const std::string& text : texts(events)) {
                all.push_back(text);
                if (text == last)
                    return all;
            }
        return all;
    }
    /// The same, of pointer and keys alone: when a window opens, what else comes is the X server's affair.
    static std::vector<std::string> input_until(Stage& stage, const std::string& last) {
        std::vector<std::string> all = read_until(stage, last);
        std::erase_if(all, [](const std::string& text) {
            return text == "expose" || text.starts_with("display") || text.starts_with("resize");
        });
        return all;
    }
    /// A window that is on the screen and takes input: its first frame is shown and seen there.
    std::unique_ptr<Stage> open(const WindowOptions& options = {});

    std::optional<XScreen> screen_;
};

/// One color all over the window, shown.
void show_color(Stage& stage, float red, float green, float blue);

/// The stage's window, as X calls it.
unsigned long x_window();

} // namespace metamer::test
