#include "color/transfer.h"

namespace metamer {

double decode(Transfer transfer, double code) {
    if (transfer == Transfer::none)
        return code;
    if (code <= SrgbCurve::kSlope * SrgbCurve::kLinearUpTo)
        return code / SrgbCurve::kSlope;
    return std::pow((code + SrgbCurve::kOffset) / SrgbCurve::kScale, SrgbCurve::kGamma);
}

LinearRgb decode_rgb8(Transfer transfer, const EncodedRgb8& c) {
    return {decode(transfer, c.r / 255.0), decode(transfer, c.g / 255.0), decode(transfer, c.b / 255.0)};
}

} // namespace metamer
