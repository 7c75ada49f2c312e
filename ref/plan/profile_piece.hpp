// SPDX-License-Identifier: Apache-2.0
// The content of a core's profile queue: motion along the path, and stops.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace curvecore::ref {

/// Constant jerk over a whole number of ticks, in the hardware's own integers
/// (ref/feed/pieces/profile_words.hpp).
///
///     s(t) = s0 + 2^exponent (c1 tau + c2 tau^2 + c3 tau^3),  tau = t / 2^time_exponent
struct ProfilePiece {
    std::uint32_t ticks = 1;
    int time_exponent = 0;            // m, ticks <= 2^m, m <= 19
    int exponent = 0;                 // e, 0..46, in quanta
    std::uint64_t ds = 0;             // quanta, exact
    std::array<std::int64_t, 3> c{};  // c1 c2 c3, 34 fraction bits, |c| < 2
    bool final = false;               // last piece of the program
};

/// Ticks of a dwell.
inline std::uint64_t rest_ticks(double seconds, double tick_s) {
    return static_cast<std::uint64_t>(std::ceil(seconds / tick_s * (1 - 1e-12)));
}

/// A step of `ticks` ticks, in each of which the slope of time's rate changes by `change`, 2^-32
/// per tick, and the rate then by its slope.
struct StopStep {
    std::uint32_t ticks = 1;
    std::int32_t change = 0;

    friend bool operator==(const StopStep& a, const StopStep& b) {
        return a.ticks == b.ticks && a.change == b.change;
    }
};

/// A stop branch: steps from the rate 1 to rest that the core may begin kStopLead ticks after
/// pieces[piece] has begun (ref/format/path_words.hpp).
struct PlannedBranch {
    std::size_t piece = 0;
    std::uint32_t wait = 1;  // ticks of path time until the next one, or the end, at most
    std::vector<StopStep> steps;
};

}  // namespace curvecore::ref
