// No allocation while something moves: frames of fades and of drags, counted by an operator new of our own.
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

#include "kiosk/kiosks.h"
#include "window/sdl_input.h"

namespace {

thread_local long allocations = 0;
thread_local bool counting = false;

void* counted(std::size_t size) {
    if (counting)
        ++allocations;
    if (void* memory = std::malloc(size == 0 ? 1 : size))
        return memory;
    throw std::bad_alloc();
}

} // namespace

void* operator new(std::size_t size) {
    return counted(size);
}
void* operator new[](std::size_t size) {
    return counted(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    allocations += counting;
    return std::malloc(size == 0 ? 1 : size);
}
void* operator new[](std::size_t size, const std::nothrow_t& none) noexcept {
    return operator new(size, none);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace metamer {
namespace {

class Frames : public testing::Test {
protected:
    Frames() : stage_(640, 480), kiosk_(parts()) {}

    KioskParts parts() {
        KioskParts parts;
        parts.stage = &stage_;
        parts.log = &log_;
        parts.load = [] { return std::make_unique<Loaded>(Loaded{kiosk_exhibit(patches()), all_words()}); };
        parts.minute_of_day = [] { return 720; };
        return parts;
    }

    void turn() {
        counting = true;
        kiosk_.turn(0);
        counting = false;
    }
    void tap(Part part, int index) {
        const PxBox box = kiosk_.desk().find(part, index)->box;
        for (const PointerPhase phase : {PointerPhase::down, PointerPhase::up})
            stage_.post(PointerEvent{phase, 0, box.left + 5.0, box.top + 5.0});
        turn();
    }
    void fade() {
        while (kiosk_.show().fading(stage_.now_s())) {
            stage_.advance(0.016);
            turn();
        }
        turn();
    }
    void drag(int steps) {
        const PxBox box = kiosk_.desk().find(Part::split)->box;
        const double x = box.left + box.width / 2.0, y = box.top + box.height / 2.0;
        stage_.post(PointerEvent{PointerPhase::down, 0, x, y});
        turn();
        allocations = 0;
        for (int i = 1; i <= steps; ++i) {
            stage_.post(PointerEvent{PointerPhase::move, 0, x + (i % 2 ? 3 : -3) * i, y});
            turn();
        }
    }

    SurfacelessStage stage_;
    Log log_{[](std::string_view) {}, [] { return std::chrono::steady_clock::time_point(); }, false};
    Kiosk kiosk_;
};

TEST_F(Frames, TheCounterCounts) {
    allocations = 0;
    tap(Part::lamp, 1); // plans, paints, uploads
    EXPECT_GT(allocations, 100);
}

TEST_F(Frames, AFadeAllocatesNothing) {
    tap(Part::lamp, 1); // the driver compiles, tables of names fill
    fade();
    tap(Part::lamp, 0);
    ASSERT_TRUE(kiosk_.show().fading(stage_.now_s()));
    const long frames = stage_.frames_shown();
    allocations = 0;
    fade();
    EXPECT_EQ(allocations, 0);
    EXPECT_GT(stage_.frames_shown(), frames + 10);
}

TEST_F(Frames, ADragOfTheSplitAllocatesNothing) {
    fade();
    drag(4);
    const long frames = stage_.frames_shown();
    drag(60);
    EXPECT_EQ(allocations, 0);
    EXPECT_GE(stage_.frames_shown(), frames + 60);
}

TEST(FramesInput, AFingerThatIsDownAllocatesNothing) {
    SdlInput input(0, {[] { return 1; }, [](SDL_TouchID, SDL_FingerID) { return true; }, [](bool) {}});
    input.set_sizes({640, 480}, {640, 480});
    std::vector<Event> events;
    SDL_Event finger{};
    finger.type = SDL_FINGERDOWN;
    finger.tfinger.touchId = 7;
    input.take(finger, events);
    ASSERT_EQ(events.size(), 1u);
    finger.type = SDL_FINGERMOTION;
    allocations = 0;
    counting = true;
    for (int i = 0; i < 60; ++i) {
        events.clear();
        input.cancel_lost(events);
        input.take(finger, events);
    }
    counting = false;
    EXPECT_EQ(allocations, 0);
    EXPECT_EQ(events.size(), 1u);
}

} // namespace
} // namespace metamer
