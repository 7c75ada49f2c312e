// SPDX-License-Identifier: Apache-2.0
// Stop branches all along a plan, so that a stop from the rate 1 never waits long for one.
#pragma once

#include "ref/feed/pieces/profile_words.hpp"
#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

/// A piece, at most, in a plan that has some: branches stand between pieces.
Reach longest_piece(const PieceGrid& grid);
/// Whether the queue lasts for a stop where pieces are so short.
bool carries_branches(const Machine& machine, const PlanOptions& options, const Plan& plan);

/// Sets plan.branches where the limits leave them and the queue still lasts for a stop; none if one
/// would need more than plan.stop_ticks. Memory for the course of one stop.
void set_branches(const Program& program, const Machine& machine, const Geometry& geometry,
                  const PlanOptions& options, Plan& plan);

/// Words of a branch, and of a plan's pieces with theirs, in the profile queue.
inline std::size_t branch_words(const PlannedBranch& branch) { return 1 + branch.steps.size(); }
std::size_t profile_words(const Plan& plan);

/// Ticks from a hold at the rate 1 to rest, at most; 0: the plan has no branches.
std::uint64_t longest_stop(const Plan& plan);

}  // namespace curvecore::ref
