// SPDX-License-Identifier: Apache-2.0
#include "sysc/system/pin_gtkw.hpp"

#include <fmt/format.h>

#include "sysc/cores/gtkw_writer.hpp"

namespace curvecore::sysc {

std::string pin_gtkw(const std::string& folder, const std::vector<std::string>& axes,
                     double duration_s) {
    std::string text = gtkw_head(folder, "system.vcd", "system.gtkw", 0, duration_s * 1e12, 0);
    for (const std::string& axis : axes) {
        text += fmt::format("@800200\n-{0}\n@28\nSystemC.{0}.step\nSystemC.{0}.direction\n", axis);
        for (const char* curve : {"command", "place", "following_error"}) {
            // Drawn as steps, three rows high.
            text += fmt::format("@8420\nSystemC.{}.{}\n@20000\n-\n-\n", axis, curve);
        }
        text += fmt::format("@1000200\n-{}\n", axis);
    }
    return text;
}

}  // namespace curvecore::sysc
