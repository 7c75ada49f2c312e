// SPDX-License-Identifier: Apache-2.0
// The cost of planning, counted so that it does not depend on the computer's load.
#pragma once

#include <cstdint>

namespace curvecore::ref {

/// Number of Newton steps times the knots that each moves, of every solver, since this thread
/// began: those of the smooth path and those of the fastest motion.
inline std::uint64_t& newton_work() {
    thread_local std::uint64_t work = 0;
    return work;
}

}  // namespace curvecore::ref
