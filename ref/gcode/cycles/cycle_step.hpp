// SPDX-License-Identifier: Apache-2.0
// The steps of a cycle in order; their places are the program's own, in mm and degrees.
#pragma once

#include <functional>
#include <string>

#include "ref/gcode/state/coordinates.hpp"

namespace curvecore::ref {

struct CycleStep {
    enum class Kind {
        kRapid,      // to a place
        kFeed,       // to a place, at the feed in force
        kThread,     // to a place, `value` mm per turn of the spindle
        kDwell,      // `value` s
        kSwitch,     // the machine stands still for `code`, which needs more than motion
        kExactPath,  // from here to the cycle's end
    };

    Kind kind;
    Point to{};
    double value = 0;
    std::string code;
};

using CarryOut = std::function<void(const CycleStep& step)>;

}  // namespace curvecore::ref
