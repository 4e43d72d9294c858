#include "render/supersample.h"

#include <array>

namespace metamer {

namespace {

// 14 bits of light are enough to find every 8-bit code again: the steepest step of the sRGB curve is 1/3294.
constexpr int kSteps = 1 << 14;

std::array<float, 256> light_by_code(Transfer transfer) {
    std::array<float, 256> out{};
    for (std::size_t code = 0; code < out.size(); ++code)
        out[code] = static_cast<float>(decode(transfer, static_cast<double>(code) / 255));
    return out;
}

std::vector<std::uint8_t> code_by_light(Transfer transfer) {
    std::vector<std::uint8_t> out(kSteps + 1);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = encode_rgb8(transfer, LinearRgb{static_cast<double>(i) / kSteps, 0, 0}).r;
    return out;
}

} // namespace

Image averaged(const Image& image, int factor, Transfer transfer) {
    if (factor == 1)
        return image;
    const auto light = light_by_code(transfer);
    const auto code = code_by_light(transfer);
    Image out{image.width / factor, image.height / factor, {}};
    out.rgba.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 4);
    const auto at = [&](int x, int y, int c) {
        return light[image.rgba[static_cast<std::size_t>(4 * (y * image.width + x) + c)]];
    };
    const float share = 1.0f / static_cast<float>(factor * factor);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                float sum = 0;
                for (int j = 0; j < factor; ++j)
                    for (int i = 0; i < factor; ++i)
                        sum += at(x * factor + i, y * factor + j, c);
                out.rgba.push_back(code[static_cast<std::size_t>(sum * share * kSteps + 0.5f)]);
            }
            out.rgba.push_back(255);
        }
    return out;
}

} // namespace metamer
