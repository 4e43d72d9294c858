// Averaging of supersampled frames.
#pragma once

#include "color/transfer.h"
#include "image/png.h"

namespace metamer {

/// Each pixel of the result is the mean of `factor` x `factor` pixels, taken in light: codes are decoded,
/// averaged and encoded again. The image's sides must be multiples of `factor`.
Image averaged(const Image& image, int factor, Transfer transfer);

} // namespace metamer
