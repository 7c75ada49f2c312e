// SPDX-License-Identifier: Apache-2.0
#include "sysc/widths/segment_words.hpp"

#include "hls/quantise.hpp"

namespace curvecore::sysc {

RunSegment to_run_words(const ref::Segment& segment, const CoreParameters& format, int axes) {
    const int bits = format.coef_bits;
    const int fine_bits = format.position_bits + format.guard_bits;
    const auto coefficient = [bits](double value) { return hls::quantise(value, bits - 2, bits); };
    RunSegment words;
    words.spline = segment.kind == ref::Segment::Kind::kSpline;
    words.length = hls::whole(segment.length, hls::kBusLengthBits);
    words.step_exponent = segment.step_exponent;
    words.lambda = segment.lambda;
    for (int axis = 0; axis < axes; ++axis) {
        const bool aux = axis >= 3;
        const auto a = static_cast<std::size_t>(aux ? axis - 3 : 0);
        const double start = aux ? segment.aux_start[a] : segment.start[axis];
        const double end = aux ? segment.aux_end[a] : segment.end[axis];
        words.start[axis] = hls::quantise(start, format.guard_bits, fine_bits);
        words.end[axis] = hls::quantise(end, format.guard_bits, fine_bits);
        words.advance[axis] = coefficient(aux ? segment.aux_advance[a] : segment.advance[axis]);
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (words.spline) {
            words.tangent[axis] = coefficient(segment.a[axis]);
            words.normal[axis] = coefficient(segment.b[axis]);
            words.advance[axis] = coefficient(segment.c[axis]);
        } else {
            words.tangent[axis] = coefficient(segment.tangent[axis] * segment.cos_pitch);
            words.normal[axis] = coefficient(segment.normal[axis] * segment.cos_pitch);
        }
    }
    if (words.spline) {
        words.theta = coefficient(1 / segment.c.norm());
    } else if (segment.radius > 0) {
        words.theta = hls::quantise(
            std::ldexp(segment.cos_pitch / segment.radius, segment.step_exponent), bits - 1, bits);
    }
    return words;
}

}  // namespace curvecore::sysc
