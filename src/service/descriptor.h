// Ownership of one file descriptor.
#pragma once

#include <unistd.h>

namespace metamer {

/// Closes what it was given; -1: none.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0)
            close(number_);
    }

    int get() const { return number_; }

private:
    int number_;
};

} // namespace metamer
