// SPDX-License-Identifier: Apache-2.0
#include "ref/program/move.hpp"

#include <cmath>

#include "ref/curve/arc_length.hpp"

namespace curvecore::ref {

double Move::length() const {
    if (kind == Kind::kArc) {
        return std::hypot((start - centre).norm() * angle, advance);
    }
    if (kind == Kind::kCubic) {
        return arc_length(cubic, 0, 1);
    }
    const double xyz = (end - start).norm();
    if (xyz > 0) {
        return xyz;
    }
    const auto travel = [this](int first) {
        return std::hypot(aux_end[first] - aux_start[first],
                          aux_end[first + 1] - aux_start[first + 1],
                          aux_end[first + 2] - aux_start[first + 2]);
    };
    const double uvw = travel(3);
    return uvw > 0 ? uvw : travel(0);
}

}  // namespace curvecore::ref
