// SPDX-License-Identifier: Apache-2.0
// The machine's limits in mm, s (degrees for rotary axes), with the names of LinuxCNC's .ini file.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ref/curve/axes.hpp"
#include "ref/machine/kinematics.hpp"
#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {

/// Vibration of what an axis moves, its lowest mode.
struct Vibration {
    double hertz = 0;       // 0: none
    double damping = 0.05;  // ratio
    double advance_s = 0;   // time by which an extruder leads, for the pressure in its nozzle
};

enum class ShaperKind { kNone, kFeedForward, kZv, kEi };
constexpr std::array<std::string_view, 4> kShaperNames{"none", "feed-forward", "zv", "ei"};

struct AxisLimits {
    double velocity = 500;       // mm/s
    double acceleration = 5000;  // mm/s^2
    double jerk = 100000;        // mm/s^3
    double min = -1000;          // mm
    double max = 1000;           // mm
    bool rotary = false;         // turns without end: its words leave whole turns out
};

/// Returns the built-in axes: A B C turn without end.
inline std::array<AxisLimits, kMachineAxes> built_in_axes() {
    std::array<AxisLimits, kMachineAxes> axes;
    for (std::size_t i = 3; i < 6; ++i) {
        axes[i].min = -kUnlimitedTravel;
        axes[i].max = kUnlimitedTravel;
        axes[i].rotary = true;
    }
    return axes;
}

/// Greatest rate of an axis by the path that the core draws, whose words hold less than 2.
constexpr double kMostAxisRate = 1.9;

struct Machine {
    std::string name = "built-in";
    double velocity = 500;       // along the path
    double acceleration = 5000;  // along and across the path
    double jerk = 100000;
    double joint_time = 1e-3;  // s, in which a joint's velocity or acceleration may change
    std::array<AxisLimits, kMachineAxes> axis = built_in_axes();
    ShaperKind shaper = ShaperKind::kNone;  // ref/machine/shaper.hpp
    std::array<Vibration, kMachineAxes> modes;
    Kinematics kinematics;  // unless trivial, `axis` is of joints, velocity .. jerk of the tool
    double joint_ratio = kMostAxisRate;  // mm or degrees that a joint goes for a mm of the tool
    std::optional<Vec3> home;            // joints from which a program begins, where axes are
    std::array<AxisLimits, 3> tool;      // travel of the tool's X Y Z, where the axes are joints
    std::vector<std::string> notes;      // defaults that were used, for the report

    /// Returns the machine that its tool would be with axes of its own.
    Machine of_tool() const {
        Machine own = *this;
        if (is_trivial(kinematics)) return own;
        std::copy(tool.begin(), tool.end(), own.axis.begin());
        own.kinematics = TrivialKinematics();
        if (home) own.home = ref::tool_of(kinematics, *home, Vec3::Zero());
        return own;
    }
    /// Times by which the path that the core draws is longer than the tool's, for its joints.
    double joint_stretch() const {
        return is_trivial(kinematics) ? 1 : std::max(1.0, joint_ratio / kMostAxisRate);
    }
};

/// Reads LinuxCNC's .ini, lengths in its LINEAR_UNITS (mm or inch):
///
/// | section                        | names                                                      |
/// |--------------------------------|------------------------------------------------------------|
/// | [TRAJ]                         | MAX_LINEAR_VELOCITY MAX_LINEAR_ACCELERATION (or             |
/// |                                | MAX_VELOCITY MAX_ACCELERATION), MAX_LINEAR_JERK,           |
/// |                                | LINEAR_UNITS COORDINATES, and curvecore's own JOINT_TIME   |
/// |                                | (s), SHAPER: none, feed-forward, zv, ei                    |
/// | [AXIS_X] .. [AXIS_W] (or       | MAX_VELOCITY MAX_ACCELERATION MAX_JERK MIN_LIMIT           |
/// | [AXIS_0] ..), [JOINT_0] ..     | MAX_LIMIT; where an axis and its joints differ the tighter |
/// |                                | one holds. Curvecore's own: SHAPER_FREQUENCY (Hz),         |
/// |                                | SHAPER_DAMPING (ratio, 0.05 without it), of its first      |
/// |                                | mode; PRESSURE_ADVANCE (s), with SHAPER = feed-forward     |
///
/// An angular axis (TYPE = ANGULAR) without MIN_LIMIT and MAX_LIMIT, or with WRAPPED_ROTARY = 1, is
/// rotary. Without MAX_JERK an axis reaches its acceleration in 0.05 s; without a limit of the path
/// the axes' limits are added as vectors, but the path, too, reaches its acceleration in 0.05 s
/// where no axis has a MAX_JERK; without MIN_LIMIT or MAX_LIMIT travel is unlimited. Missing names
/// are reported in `notes`.
/// @throws InputError with file, line and reason.
Machine read_machine(const std::string& file);

/// @throws InputError, with `file_name` as its file
Machine read_machine_text(std::string_view text, const std::string& file_name);

}  // namespace curvecore::ref
