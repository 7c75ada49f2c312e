// SPDX-License-Identifier: Apache-2.0
// Feed profile of a program or of a window of it: limits, stops and look-ahead become pieces, slow
// enough that what is queued outlasts a stop.
#pragma once

#include <optional>

#include "ref/feed/window_motion.hpp"

namespace curvecore::ref {

/// Fills in pieces, duration, bounds of holds and the feed at both ends of every segment.
///
/// @param least number of planned moves for which there is memory in any case
/// @returns the number of planned moves for which there is memory: if not all, nothing is filled in
std::size_t plan_feed(const Program& program, const Machine& machine, const PlanOptions& options,
                      const Geometry& geometry, std::size_t least, Plan& plan);

struct PlannedWindow {
    WindowMotion motion;
    std::size_t cut;     // planned move before which it can be cut, without acceleration there
    std::size_t enough;  // result of plan_feed()
};

/// Plans a window that begins with the given motion and ends at rest, with the plan's bounds of
/// holds, and fills in what it plans.
///
/// `more`: makes a cut, far enough from the end that what follows may be faster there than a motion
/// that stops; cut 0: there is no place for one. `least`: as in plan_feed().
/// @returns none if the given motion cannot be continued
std::optional<PlannedWindow> plan_window(const Program& program, const Machine& machine,
                                         const PlanOptions& options, const Geometry& geometry,
                                         const std::vector<GivenRun>& given, bool more,
                                         std::size_t least, Plan& plan);

/// Returns the last planned move, of those that begin a move of the program, from which on a window
/// must be given the motion to see all that affects what follows `cut`.
std::size_t given_from(const WindowMotion& motion, std::size_t cut, const Machine& machine);

}  // namespace curvecore::ref
