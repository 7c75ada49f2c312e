// SPDX-License-Identifier: Apache-2.0
// Feed profile of a program or of a window of it: limits, stops and look-ahead to pieces, so slow
// that what is queued outlasts a stop.
#pragma once

#include <optional>

#include "ref/feed/window_motion.hpp"

namespace curvecore::ref {

/// Fills in pieces, duration, bounds of holds and the feed at both ends of every segment.
///
/// @param least planned moves that there is memory for, however long they take
/// @returns so many planned moves there is memory for: fewer than all, and nothing is filled in
std::size_t plan_feed(const Program& program, const Machine& machine, const PlanOptions& options,
                      const Geometry& geometry, std::size_t least, Plan& plan);

struct PlannedWindow {
    WindowMotion motion;
    std::size_t cut;     // planned move before which it can be cut, without acceleration there
    std::size_t enough;  // as plan_feed() returns
};

/// A window that begins with what is given, up to a rest at its end, with the bounds of holds that
/// stand in the plan; what is planned is filled in there.
///
/// `more`: it gets a cut, so far from its end that what follows may be faster there than a motion
/// that stops; 0: no place for a cut. `least`: as of plan_feed().
/// @returns nothing where what is given cannot be gone on with
std::optional<PlannedWindow> plan_window(const Program& program, const Machine& machine,
                                         const PlanOptions& options, const Geometry& geometry,
                                         const std::vector<GivenRun>& given, bool more,
                                         std::size_t least, Plan& plan);

/// The last planned move, of those that begin one of the program, from which on a window must be
/// given the motion to see all that counts for what follows `cut`.
std::size_t given_from(const WindowMotion& motion, std::size_t cut, const Machine& machine);

}  // namespace curvecore::ref
