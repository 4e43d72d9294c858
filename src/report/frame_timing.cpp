#include "report/frame_timing.h"

#include <GLES2/gl2.h>
#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>
#include <random>

#include "gles/info.h"
#include "gles/timer_query.h"
#include "render/frame.h"

namespace metamer {

namespace {

double clocked_ms(const std::function<void()>& draw) {
    glFinish();
    const auto begin = std::chrono::steady_clock::now();
    draw();
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

// Mesa's names for them.
bool is_software(const std::string& renderer) {
    return renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos ||
           renderer.find("SwiftShader") != std::string::npos;
}

// std::shuffle is another order with every standard library.
void shuffle(std::vector<std::size_t>& order, std::mt19937& random) {
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random() % i]);
}

} // namespace

FrameClock frame_clock() {
    auto query = is_software(gl_renderer()) ? std::nullopt : TimerQuery::create();
    if (!query)
        return {clocked_ms, "glFinish"};
    const auto timer = std::make_shared<TimerQuery>(std::move(*query));
    return {[timer](const std::function<void()>& draw) {
                const double clock_ms = clocked_ms([&] {
                    timer->begin();
                    draw();
                    timer->end();
                });
                return timer->elapsed_ms().value_or(clock_ms);
            },
            "GL_EXT_disjoint_timer_query"};
}

std::vector<std::vector<double>> time_rounds(std::span<const std::function<void()>> frames, int rounds,
                                             const StopWatch& watch) {
    std::vector<std::vector<double>> ms(frames.size());
    std::vector<std::size_t> order(frames.size());
    std::iota(order.begin(), order.end(), 0u);
    for (const auto& frame : frames)
        watch(frame);
    std::mt19937 random; // the default seed
    for (int round = 0; round < rounds; ++round) {
        shuffle(order, random);
        for (const std::size_t i : order)
            ms[i].push_back(watch(frames[i]));
    }
    return ms;
}

std::vector<double> ratios(std::span<const double> a, std::span<const double> b) {
    std::vector<double> out;
    for (std::size_t i = 0; i < a.size(); ++i)
        out.push_back(a[i] / b[i]);
    return out;
}

TimedFrame::TimedFrame(Exhibit exhibit, DrawStyle style)
    : exhibit_(std::move(exhibit)), renderer_(exhibit_, style), target_(framebuffer_of(exhibit_.display)) {}

void TimedFrame::draw() {
    target_.bind();
    renderer_.draw(target_.width_px(), target_.height_px(), exhibit_.display.supersample);
}

} // namespace metamer
