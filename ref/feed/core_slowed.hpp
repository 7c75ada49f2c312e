// SPDX-License-Identifier: Apache-2.0
// Time that a plan loses because the core cannot make steps as fast as feed and machine allow: the
// warning to users.
#pragma once

#include "ref/feed/window_motion.hpp"

namespace curvecore::ref {

/// Reports on the planned moves from `first` up to `end` (not included), given the motion of all.
/// The lost time is an estimate: at the lower speed itself, and to slow down to it and back once.
/// @param dropped moves at the program's start that it no longer holds but planned moves count
CoreSlowed core_slowed(const FeedTask& task, const WindowMotion& motion, std::size_t first,
                       std::size_t end, std::size_t dropped = 0);

}  // namespace curvecore::ref
