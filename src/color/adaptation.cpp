#include "color/adaptation.h"

#include "base/error.h"

namespace metamer {

namespace {
constexpr Matrix3 kCone{{{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}}};
constexpr double kLeastResponse = 1e-3;
} // namespace

Matrix3 bradford(const Xyz& from_white, const Xyz& to_white) {
    const auto from = kCone * std::array<double, 3>{from_white.x, from_white.y, from_white.z};
    const auto to = kCone * std::array<double, 3>{to_white.x, to_white.y, to_white.z};
    for (double response : from)
        if (!(response > kLeastResponse * from_white.y))
            throw bad_input("adapt to", "the lamp",
                            "its light does not excite all three cone responses of the Bradford transform");
    const Matrix3 gains = Matrix3::diagonal(to[0] / from[0], to[1] / from[1], to[2] / from[2]);
    return *inverse(kCone) * gains * kCone;
}

} // namespace metamer
