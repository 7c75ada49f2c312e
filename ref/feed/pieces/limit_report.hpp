// SPDX-License-Identifier: Apache-2.0
// Distance of a plan from the machine's limits, from its pieces and the curvature of its moves.
#pragma once

#include <optional>

#include "ref/limits/limits.hpp"
#include "ref/segment/plan_options.hpp"

namespace curvecore::ref {

/// | field  | remark                                                                             |
/// |--------|------------------------------------------------------------------------------------|
/// | inside | worst ratio to the limits inside pieces and moves, path and every axis; where a     |
/// |        | piece reaches into a move by less than PieceGrid::shortest, that belongs to the     |
/// |        | joint                                                                              |
/// | joints | at joints passed in motion: worst change of velocity over acceleration * JointTime  |
/// |        | (field acceleration) and of v^2 r'' over jerk * JointTime (field jerk)              |
struct LimitReport {
    LimitRatios inside;
    LimitRatios joints;
    int passed = 0;  // joints passed in motion
};

/// The report of a plan that comes in parts, as PlanStream gives them.
class LimitWatch {
  public:
    explicit LimitWatch(Machine machine) : machine_(std::move(machine)) {}

    /// Adds the next part; its segments count their moves within `program`.
    void add(const Program& program, const Plan& part);

    const LimitReport& report() const { return report_; }

  private:
    void pass(const PathShape& before, const PathShape& behind, double speed);

    Machine machine_;
    LimitReport report_;
    std::optional<PathShape> before_;  // the last move
    double speed_ = 0;                 // mm/s, at its end
};

/// Returns the report of a plan that make_plan made from the same arguments.
LimitReport limit_report(const Program& program, const Machine& machine, const Plan& plan);

}  // namespace curvecore::ref
