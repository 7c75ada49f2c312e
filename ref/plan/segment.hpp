// SPDX-License-Identifier: Apache-2.0
// A plan: the content of a core's queues, the planner's output, the quantiser's input.
#pragma once

#include <cstdint>
#include <vector>

#include "ref/curve/axes.hpp"
#include "ref/curve/drawn/drawn_curve.hpp"
#include "ref/plan/planned_output.hpp"
#include "ref/plan/planned_wait.hpp"
#include "ref/plan/profile_piece.hpp"

namespace curvecore::ref {

/// A piece of one curve, drawn from one set of words: X Y Z along the curve, 0 <= s <= length, the
/// auxiliary axes linear in s. All lengths in length units (1 nm by default), as real numbers of
/// the exact curve.
struct Segment {
    std::size_t move = 0;       // index into Program::moves
    int line = 0;               // line in the program's file
    std::uint64_t s_start = 0;  // path quanta (2^-16 unit), program-wide
    std::uint64_t length = 0;   // path quanta
    Vec3 start = Vec3::Zero();  // exact, not rounded
    Vec3 end = Vec3::Zero();
    DrawnCurve curve;
    Aux aux_start{};
    Aux aux_end{};
    Aux aux_advance{};      // per unit of path
    Aux aux_turned{};       // whole turns of a rotary axis that its words leave out, units
    double stretch = 1;     // of joints: by how much the path is longer than the tool's
    int step_exponent = 0;  // k: an integration step is 2^k units
    double bound = 0;       // derived bound of the error per axis, before the final rounding, units
    std::uint32_t ticks = 0;  // profile ticks in which it is drawn; a program's sum is its pieces'
    bool last = false;        // last segment of the program
    double feed_start = 0;    // mm/s along the path, planned
    double feed_end = 0;

    CurveKind kind() const { return static_cast<CurveKind>(curve.index()); }
    /// Returns "line", "arc", "helix", "spline" or a table's name.
    const char* kind_name() const {
        return std::visit([](const auto& piece) { return piece.name(); }, curve);
    }

    /// Return the curve as one of its kind. @throws std::bad_variant_access if it is another
    ArcPiece& arc() { return std::get<ArcPiece>(curve); }
    const ArcPiece& arc() const { return std::get<ArcPiece>(curve); }
    SplinePiece& spline() { return std::get<SplinePiece>(curve); }
    const SplinePiece& spline() const { return std::get<SplinePiece>(curve); }
    TablePiece& table() { return std::get<TablePiece>(curve); }
    const TablePiece& table() const { return std::get<TablePiece>(curve); }
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
    std::vector<PlannedOutput> outputs;   // by their places
    std::vector<PlannedWait> waits;       // by their pieces
    double duration_s = 0;
    std::size_t slowed_moves = 0;  // moves slowed so that queued words outlast a stop
    int slowed_line = 0;           // line of the first of them
    CoreSlowed core_slowed;
};

}  // namespace curvecore::ref
