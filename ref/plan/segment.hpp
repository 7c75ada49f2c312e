// SPDX-License-Identifier: Apache-2.0
// The content of a core's queues in real numbers: the planner's output, the quantiser's input.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "ref/curve/axes.hpp"
#include "ref/curve/vec3.hpp"

namespace curvecore::ref {

/// A piece of one curve, at most a quarter turn, drawn from one set of words.
///
/// All lengths in length units (1 nm by default), as real numbers of the exact curve.
///
///     r(s) = centre + radius (n cos(phi s) + t sin(phi s)) + (advance) s     0 <= s <= length
///
/// with unit vectors t (tangent of the circle), n (outward normal) and phi = cos_pitch / radius.
/// A line has radius 0: r(s) = start + advance s.
///
/// A spline is a piece of a cubic in a parameter v of its own, drawn at constant path speed:
///
///     r(v) = start + 2^lambda ((a v + b) v + c) v       0 <= v <= beta,  v(s) by path length
///
/// with 1/2 < |dr/dv| / 2^lambda < 1 (ref/segment/spline_segment.hpp); tangent, normal, cos_pitch,
/// radius and advance are zero.
struct Segment {
    enum class Kind { kArc, kSpline };

    Kind kind = Kind::kArc;
    std::size_t move = 0;       // index into Program::moves
    int line = 0;               // line in the program's file
    std::uint64_t s_start = 0;  // path quanta (2^-16 unit), program-wide
    std::uint64_t length = 0;   // path quanta
    Vec3 start = Vec3::Zero();  // exact, not rounded
    Vec3 end = Vec3::Zero();
    Vec3 tangent = Vec3::Zero();  // unit vectors at the start; zero for lines
    Vec3 normal = Vec3::Zero();
    double cos_pitch = 0;         // 0 for lines
    double radius = 0;            // 0 for lines
    Vec3 advance = Vec3::Zero();  // per unit of path
    Vec3 a = Vec3::Zero();        // splines: a, b, c, lambda, beta
    Vec3 b = Vec3::Zero();
    Vec3 c = Vec3::Zero();
    int lambda = 0;
    double beta = 0;
    Aux aux_start{};
    Aux aux_end{};
    Aux aux_advance{};      // per unit of path
    Aux aux_turned{};       // whole turns of a rotary axis that its words leave out, units
    int step_exponent = 0;  // k: an integration step is 2^k units
    double bound = 0;       // derived bound of the error per axis, before the final rounding, units
    std::uint32_t ticks = 0;  // profile ticks in which it is drawn; a program's sum is its pieces'
    bool last = false;        // last segment of the program
    double feed_start = 0;    // mm/s along the path, planned
    double feed_end = 0;
};

/// "line", "arc", "helix" or "spline".
inline const char* kind_name(const Segment& segment) {
    if (segment.kind == Segment::Kind::kSpline) return "spline";
    if (segment.radius == 0) return "line";
    constexpr double kFlat = 1e-9;  // an arc's advance within its plane makes no helix
    const double rise = segment.normal.cross(segment.tangent).dot(segment.advance);
    return std::abs(rise) < kFlat ? "arc" : "helix";
}

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

/// A step of `ticks` ticks, in each of which the slope of time's rate changes by `change`, 2^-32
/// per tick, and the rate then by its slope.
struct StopStep {
    std::uint32_t ticks = 1;
    std::int32_t change = 0;
};

/// A stop branch: steps from the rate 1 to rest that the core may begin kStopLead ticks after
/// pieces[piece] has begun (ref/format/path_words.hpp).
struct PlannedBranch {
    std::size_t piece = 0;
    std::uint32_t wait = 1;  // ticks at the rate 1 until the next one, or the end, at most
    std::vector<StopStep> steps;
};

/// Properties that all parts of a plan share.
struct PlanFrame {
    double unit_mm = 1e-6;
    double tick_s = 1e-4;
    int aux_axes = 0;
    std::uint32_t hold_acceleration = 1;  // a: second difference of r32 per tick^2
    std::uint32_t hold_slope_steps = 1;   // nmax: largest slope = nmax * a
    std::uint32_t stop_ticks = 0;         // ticks of the profile that a stop needs at most
};

/// Moves that the core cannot make as fast as feed and machine allow (ref/feed/core_slowed.hpp).
///
/// | field         | unit | remark                                |
/// |---------------|------|---------------------------------------|
/// | moves         | 1    |                                       |
/// | lost_s        | s    | by all of them, an estimate           |
/// | line          |      | of the move that loses most           |
/// | most_s        | s    | its loss                              |
/// | speed, asked  | mm/s | its own, and without the core's limit |
struct CoreSlowed {
    std::size_t moves = 0;
    double lost_s = 0;
    int line = 0;
    double most_s = 0;
    double speed = 0;
    double asked = 0;

    void add(const CoreSlowed& more) {
        const std::size_t all = moves + more.moves;
        const double lost = lost_s + more.lost_s;
        if (more.most_s > most_s) *this = more;
        moves = all;
        lost_s = lost;
    }
};

struct Plan : PlanFrame {
    std::vector<Segment> segments;
    std::vector<ProfilePiece> pieces;
    std::vector<PlannedBranch> branches;  // by their pieces, none twice
    double duration_s = 0;
    std::size_t slowed_moves = 0;  // moves slowed so that queued words outlast a stop
    int slowed_line = 0;           // line of the first of them
    CoreSlowed core_slowed;
};

}  // namespace curvecore::ref
