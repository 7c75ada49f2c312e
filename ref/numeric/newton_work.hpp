// SPDX-License-Identifier: Apache-2.0
// What planning costs, whatever else the computer does.
#pragma once

#include <cstdint>

namespace curvecore::ref {

/// Newton steps times the knots that each moves, of every solver, since this thread began: those of
/// the smooth path and those of the fastest motion.
inline std::uint64_t& newton_work() {
    thread_local std::uint64_t work = 0;
    return work;
}

}  // namespace curvecore::ref
