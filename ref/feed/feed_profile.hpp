// SPDX-License-Identifier: Apache-2.0
// Feed profile of a window of a program, or of all of it: limits, stops and look-ahead become
// pieces, slow enough that what is queued outlasts a stop.
#pragma once

#include <optional>

#include "ref/feed/window_motion.hpp"

namespace curvecore::ref {

/// | field  | remark                                                                          |
/// |--------|---------------------------------------------------------------------------------|
/// | plan   | pieces and duration, of a whole program also branches; segments are left out    |
/// | cut    | planned move before which the motion may be cut, without acceleration; 0: none  |
/// | enough | number of planned moves for which there is memory, or within the horizon: if not |
/// |        | all, plan is empty                                                              |
struct WindowProfile {
    WindowMotion motion;
    Plan plan;
    std::size_t cut;
    std::size_t enough;
};

/// Makes the profile of a window from its geometry, by rules or, where it is asked for and faster,
/// by the optimum. A cut is far enough from the end that what follows may be faster there than a
/// motion that stops.
/// @returns none if the given motion cannot be continued
/// @throws InputError: what the queues hold outlasts a stop at no speed
std::optional<WindowProfile> profile_window(FeedTask task);

/// Returns the time of motion that a window has behind what is given, s.
double horizon(const Machine& machine, const PlanOptions& options);

/// Returns the last planned move, of those that begin a move of the program, from which on a window
/// must be given the motion to see all that affects what follows `cut`.
std::size_t given_from(const WindowMotion& motion, std::size_t cut, const Machine& machine);

}  // namespace curvecore::ref
