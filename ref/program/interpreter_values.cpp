// SPDX-License-Identifier: Apache-2.0
// What a program may ask the interpreter for: positions and modes, as parameters.
#include <string_view>

#include "ref/program/interpreter.hpp"

namespace curvecore::ref {
namespace {

constexpr int kProgrammedX = 5420;  // .. 5428
constexpr int kMachineX = 5021;     // .. 5029
constexpr std::string_view kNames = "xyzabcuvw";

}  // namespace

void Interpreter::give_values() {
    for (int axis = 0; axis < kAxes; ++axis) {
        const auto programmed = [this, axis] { return coordinates_.programmed(axis); };
        const auto on_machine = [this, axis] { return coordinates_.on_machine(axis); };
        const std::string letter(1, kNames[axis]);
        parameters_.compute(kProgrammedX + axis, programmed);
        parameters_.compute("_" + letter, programmed);
        parameters_.compute(kMachineX + axis, on_machine);
        parameters_.compute("_abs_" + letter, on_machine);
    }
    const auto give = [this](const char* name, std::function<double()> value) {
        parameters_.compute(name, std::move(value));
    };
    give("_motion_mode", [this] { return motion_; });
    give("_plane", [this] { return normal_axis_ == 2 ? 170 : normal_axis_ == 1 ? 180 : 190; });
    give("_ccomp", [] { return 400; });
    give("_metric", [this] { return coordinates_.inches() ? 0 : 1; });
    give("_imperial", [this] { return coordinates_.inches() ? 1 : 0; });
    give("_absolute", [this] { return coordinates_.absolute() ? 1 : 0; });
    give("_incremental", [this] { return coordinates_.absolute() ? 0 : 1; });
    give("_inverse_time", [this] { return inverse_time_ ? 1 : 0; });
    give("_units_per_minute", [this] { return inverse_time_ ? 0 : 1; });
    give("_ijk_absolute_mode", [this] { return absolute_centre_ ? 1 : 0; });
    give("_coord_system", [this] {
        const int system = coordinates_.system();
        return system < 6 ? 540 + 10 * system : 585 + system;
    });
    give("_feed", [this] { return feed_.value_or(0) * feed_unit_ / coordinates_.unit(); });
}

}  // namespace curvecore::ref
