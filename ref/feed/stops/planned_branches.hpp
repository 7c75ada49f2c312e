// SPDX-License-Identifier: Apache-2.0
// Stop branches along a plan, so that a stop never waits long for one.
#pragma once

#include "ref/feed/pieces/profile_words.hpp"
#include "ref/feed/stops/stop_branch.hpp"
#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

/// PlannedBranch::wait of a branch behind which none is near: a hold there takes the bounds.
constexpr std::uint32_t kNoWait = 1;

/// Distance between branches, and so the longest piece of a plan that has them: they stand between
/// pieces.
Reach longest_piece(const PieceGrid& grid);
/// Returns true if the queue lasts for a stop with pieces as short as that.
bool carries_branches(const Machine& machine, const PlanOptions& options, const Plan& plan);

/// Sets plan.branches where the limits leave them and the queue still lasts for a stop; none if one
/// needed more than plan.stop_ticks. The memory is that of the course of one stop.
void set_branches(const Program& program, const Machine& machine, const Geometry& geometry,
                  const PlanOptions& options, Plan& plan);

/// Ticks of the profile that pass during a stop.
double ticks_passed(const StopSteps& steps);

/// Number of words of a branch in the profile queue; with steps that are those of the branch before
/// it has one.
inline std::size_t branch_words(const PlannedBranch& branch,
                                const PlannedBranch* before = nullptr) {
    return 1 + (before != nullptr && before->steps == branch.steps ? 0 : branch.steps.size());
}
/// .. and of a plan's pieces with their branches.
std::size_t profile_words(const Plan& plan);

/// Longest time from a hold at the rate 1 to rest, ticks; 0: the plan has no branches.
std::uint64_t longest_stop(const Plan& plan);

}  // namespace curvecore::ref
