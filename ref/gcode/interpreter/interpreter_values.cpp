// SPDX-License-Identifier: Apache-2.0
// The interpreter's positions and modes as parameters that a program can read.
#include <string_view>
#include <utility>

#include "ref/gcode/interpreter/interpreter.hpp"

namespace curvecore::ref {
namespace {

constexpr int kProgrammedX = 5420;  // .. 5428
constexpr int kMachineX = 5021;     // .. 5029
constexpr int kToolInSpindle = 5400;

}  // namespace

void Interpreter::give_values() {
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        const auto programmed = [this, axis] { return coordinates_.programmed(axis); };
        const auto on_machine = [this, axis] { return coordinates_.on_machine(axis); };
        const std::string letter(1, kAxisNames[axis]);
        parameters_.compute(kProgrammedX + axis, programmed);
        parameters_.compute("_" + letter, programmed);
        parameters_.compute(kMachineX + axis, on_machine);
        parameters_.compute("_abs_" + letter, on_machine);
    }
    const auto give = [this](const char* name, std::function<double()> value) {
        parameters_.compute(name, std::move(value));
    };
    give("_motion_mode", [this] { return motion_; });
    give("_plane", [this] {
        const int axis = modes_.normal_axis;
        return axis == 2 ? 170 : axis == 1 ? 180 : 190;
    });
    give("_ccomp", [this] { return compensation_; });
    give("_metric", [this] { return coordinates_.inches() ? 0 : 1; });
    give("_imperial", [this] { return coordinates_.inches() ? 1 : 0; });
    give("_absolute", [this] { return coordinates_.absolute() ? 1 : 0; });
    give("_incremental", [this] { return coordinates_.absolute() ? 0 : 1; });
    const auto give_mode = [this, &give](const char* name, FeedMode mode) {
        give(name, [this, mode] { return modes_.feed_mode == mode ? 1 : 0; });
    };
    give_mode("_inverse_time", FeedMode::kInverseTime);
    give_mode("_units_per_minute", FeedMode::kPerMinute);
    give_mode("_units_per_rev", FeedMode::kPerTurn);
    give("_ijk_absolute_mode", [this] { return modes_.absolute_centre ? 1 : 0; });
    give("_coord_system", [this] {
        const int system = coordinates_.modes().system;
        return system < 6 ? 540 + 10 * system : 585 + system;
    });
    give("_feed",
         [this] { return modes_.feed.value_or(0) * modes_.feed_unit / coordinates_.unit(); });
    parameters_.compute(kToolInSpindle, [this] { return tool_; });
    give("_current_tool", [this] { return tool_; });
    give("_selected_tool", [this] { return selected_tool_; });
    give("_rpm", [this] { return modes_.speed; });
    give("_spindle_on", [this] { return modes_.turning == Turning::kNo ? 0 : 1; });
    give("_spindle_cw", [this] { return modes_.turning == Turning::kClockwise ? 1 : 0; });
    give("_lathe_diameter_mode", [this] { return coordinates_.modes().diameter ? 1 : 0; });
    give("_lathe_radius_mode", [this] { return coordinates_.modes().diameter ? 0 : 1; });
    give("_retract_r_plane", [this] { return modes_.retract_to_r ? 1 : 0; });
    give("_retract_old_z", [this] { return modes_.retract_to_r ? 0 : 1; });
    give("_metric_machine", [this] { return parameter_unit_ > 1 ? 0 : 1; });
    const std::pair<const char*, double> constants[] = {
        {"_vmajor", 2.9},      {"_vminor", 0},         {"_task", 0},          {"_remap_level", 0},
        {"_feed_override", 1}, {"_speed_override", 1}, {"_adaptive_feed", 0}, {"_feed_hold", 1}};
    for (const auto& [name, value] : constants) {
        give(name, [value = value] { return value; });
    }
}

}  // namespace curvecore::ref
