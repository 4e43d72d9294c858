// The GPU's own clock (GL_EXT_disjoint_timer_query), where the driver has one.
#pragma once

#include <GLES2/gl2.h>
#include <optional>

namespace metamer {

/// Times what the GL does between begin() and end(). Needs a current context, made before and destroyed
/// after it. Move-only.
class TimerQuery {
public:
    /// None where use_gl_extension() refuses the extension, or where its counter for elapsed time has no bits
    /// (the extension's section 6.1.12: such a counter counts nothing).
    static std::optional<TimerQuery> create();

    TimerQuery(TimerQuery&& other) noexcept;
    TimerQuery& operator=(TimerQuery&& other) noexcept;
    TimerQuery(const TimerQuery&) = delete;
    TimerQuery& operator=(const TimerQuery&) = delete;
    ~TimerQuery();

    /// In pairs, not nested.
    void begin();
    void end();

    /// Milliseconds between the last begin() and end(); waits until they are known. None where the GPU was
    /// disturbed meanwhile (GL_GPU_DISJOINT_EXT: another clock rate, sleep).
    std::optional<double> elapsed_ms();

private:
    explicit TimerQuery(GLuint query) : query_(query) {}

    GLuint query_ = 0;
};

} // namespace metamer
