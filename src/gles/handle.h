// Ownership of one GL object name.
#pragma once

#include <GLES2/gl2.h>
#include <utility>

namespace metamer {

/// Owns a GL name, 0 for none; move-only. Delete must accept a name whose context is gone by doing nothing,
/// which GL's own functions do (GLVND and Mesa drop calls without a context).
template <void (*Delete)(GLuint)>
class Handle {
public:
    Handle() = default;
    explicit Handle(GLuint name) : name_(name) {}
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        if (this != &other) {
            reset();
            name_ = std::exchange(other.name_, 0);
        }
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { reset(); }

    GLuint get() const { return name_; }

private:
    void reset() {
        if (name_ != 0)
            Delete(name_);
        name_ = 0;
    }

    GLuint name_ = 0;
};

} // namespace metamer
