// SPDX-License-Identifier: Apache-2.0
// What a plan loses since the core cannot make steps as fast as feed and machine would have the
// path: what users are warned of.
#pragma once

#include "ref/feed/window_motion.hpp"

namespace curvecore::ref {

/// Of the planned moves from `first` up to `end` (not included), with the motion of all. The time
/// that is lost is an estimate: at the lower speed itself, and to slow down to it and back once.
/// @param dropped moves that the program has no more of those that planned moves count from
CoreSlowed core_slowed(const FeedTask& task, const WindowMotion& motion, std::size_t first,
                       std::size_t end, std::size_t dropped = 0);

}  // namespace curvecore::ref
