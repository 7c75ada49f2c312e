// SPDX-License-Identifier: Apache-2.0
#include "ref/limits/move_parts.hpp"

#include <algorithm>
#include <cmath>

#include "ref/limits/limits.hpp"
#include "ref/moves/move_part.hpp"

namespace curvecore::ref {
namespace {

constexpr double kLongestTurningTime = 10;  // s, of an arc at the machine's speed: bounds knots

int parts_of(const Move& move, const Machine& machine, double longest) {
    double parts = least_time(move, machine.velocity) / longest;
    if (move.kind == Move::Kind::kArc) {
        const PathShape shape = path_shape(move);
        const double time = shape.length / top_speed(shape, machine);
        if (shape.length > 0) parts = std::max(parts, time / kLongestTurningTime);
    }
    return static_cast<int>(std::clamp(std::ceil(parts), 1.0, 1e9));
}

}  // namespace

bool MoveParts::next(Move& move) {
    if (given_ == parts_) {
        if (!source_(whole_)) return false;
        parts_ = parts_of(whole_, machine_, longest_);
        given_ = 0;
    }
    if (parts_ == 1) {
        move = whole_;
    } else {
        const double length = whole_.length();
        move = part_of(whole_, length * given_ / parts_, length * (given_ + 1) / parts_);
    }
    ++given_;
    return true;
}

}  // namespace curvecore::ref
