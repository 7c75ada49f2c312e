// SPDX-License-Identifier: Apache-2.0
#include "ref/machine/machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ref/machine/ini_file.hpp"
#include "ref/machine/kinematics_reader.hpp"
#include "ref/text/input_error.hpp"
#include "ref/text/text_file.hpp"

namespace curvecore::ref {
namespace {

constexpr double kJerkTime = 0.05;  // s in which the acceleration is reached if no jerk is given
constexpr double kSmallestLimit = 1e-6;
constexpr double kLargestLimit = 1e12;

class MachineReader {
  public:
    explicit MachineReader(const IniFile& ini) : ini_(ini) {}

    Machine read() {
        machine_.name = std::filesystem::path(ini_.file()).filename().string();
        read_units();
        read_shaper();
        machine_.kinematics = read_kinematics(ini_, unit_);
        machine_.joint_ratio = read_joint_ratio(ini_, kMostAxisRate);
        const std::string axes = read_axes();
        if (!ini_.has_section("TRAJ") && !any_axis_) {
            throw InputError(ini_.file(), 0,
                             "no [TRAJ], [AXIS_..] or [JOINT_..]: not a machine of LinuxCNC");
        }
        if (joints()) {
            read_tool();
            read_home();
        }
        read_path(axes);
        return machine_;
    }

  private:
    bool joints() const { return !is_trivial(machine_.kinematics); }

    void note(const std::string& text) { machine_.notes.push_back(text); }

    void read_units() {
        unit_ = mm_per_unit(ini_);
        if (!ini_.find("TRAJ", "LINEAR_UNITS")) note("LINEAR_UNITS: mm");
        const std::optional<IniEntry> angles = ini_.find("TRAJ", "ANGULAR_UNITS");
        if (angles && angles->value != "degree" && angles->value != "deg") {
            throw InputError(ini_.file(), angles->line,
                             fmt::format("ANGULAR_UNITS = {}: degree only", angles->value));
        }
    }

    /// Returns a limit above 0 in mm; `section` states its unit.
    std::optional<double> limit(const std::string& section, const std::string& name, double unit) {
        const std::optional<double> value = ini_.number(section, name);
        if (!value) {
            return std::nullopt;
        }
        const int line = ini_.find(section, name)->line;
        if (*value <= 0) {
            throw InputError(ini_.file(), line,
                             fmt::format("{} must be above 0, not {:g}", name, *value));
        }
        if (*value < kSmallestLimit || *value > kLargestLimit) {
            throw InputError(ini_.file(), line,
                             fmt::format("{} = {:g} is out of range ({:g} .. {:g})", name, *value,
                                         kSmallestLimit, kLargestLimit));
        }
        return *value * unit;
    }

    /// Returns the letters of the axes in the order of the joints.
    std::string joint_letters() const {
        std::optional<IniEntry> entry = ini_.find("TRAJ", "COORDINATES");
        std::string letters;
        for (const char c : entry ? entry->value : std::string(kAxisLetters)) {
            const char letter = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
            if (kAxisLetters.find(letter) != std::string_view::npos) {
                letters += letter;
            } else if (letter != ' ' && letter != '\t') {
                throw InputError(
                    ini_.file(), entry->line,
                    fmt::format("COORDINATES = {}: letters of X Y Z A B C U V W", entry->value));
            }
        }
        return letters;
    }

    /// Returns every section that limits the axis: its own, by letter or by number, and its
    /// joints'.
    std::vector<std::string> sections_of(int axis, const std::string& letters) const {
        std::vector<std::string> sections;
        if (!joints() || axis >= 3) sections = tool_sections(axis);
        for (std::size_t joint = 0; joint < letters.size(); ++joint) {
            const bool bent = joints() && joint < 3;  // X Y Z together make the first three
            if (bent ? static_cast<int>(joint) == axis
                     : letters[joint] == kAxisLetters[axis] && !(joints() && axis < 3)) {
                sections.push_back(fmt::format("JOINT_{}", joint));
            }
        }
        return there(std::move(sections));
    }

    /// Returns the sections of an axis of the tool.
    static std::vector<std::string> tool_sections(int axis) {
        return {fmt::format("AXIS_{}", kAxisLetters[axis]), fmt::format("AXIS_{}", axis)};
    }

    std::vector<std::string> there(std::vector<std::string> sections) const {
        sections.erase(std::remove_if(sections.begin(), sections.end(),
                                      [this](const auto& s) { return !ini_.has_section(s); }),
                       sections.end());
        return sections;
    }

    /// Reads the axes that the file describes.
    std::string read_axes() {
        const std::string letters = joint_letters();
        std::string axes;
        for (int axis = 0; axis < kMachineAxes; ++axis) {
            const std::vector<std::string> sections = sections_of(axis, letters);
            if (!sections.empty()) {
                read_axis(axis, sections);
                any_axis_ = true;
                axes += kAxisLetters[axis];
            } else if (axis < 3) {
                note(fmt::format("{}: the built-in machine's limits", kAxisLetters[axis]));
            }
        }
        return axes;
    }

    /// Reads where the joints of X Y Z stand at first, if all say it.
    void read_home() {
        const std::array<bool, 3> angles = turning(machine_.kinematics);
        Vec3 home;
        for (int joint = 0; joint < 3; ++joint) {
            const auto place = ini_.number(fmt::format("JOINT_{}", joint), "HOME");
            if (!place) return note("HOME of the joints: the program begins at X0 Y0 Z0");
            home[joint] = *place * (angles[static_cast<std::size_t>(joint)] ? 1 : unit_);
        }
        machine_.home = home;
    }

    /// Reads the tool's own axes, where X Y Z of the machine are joints: how far they go.
    void read_tool() {
        for (int axis = 0; axis < 3; ++axis) {
            const std::string name = fmt::format("AXIS_{}", kAxisLetters[axis]);
            const std::vector<std::string> sections = there(tool_sections(axis));
            AxisLimits& limits = machine_.tool[static_cast<std::size_t>(axis)];
            read_travel(name, sections, unit_, false, limits);
            const auto of = [&](const char* limit_name, double& field) {
                const std::optional<double> value = tightest(sections, limit_name, unit_);
                field = value.value_or(field);
                if (value)
                    note(fmt::format("{} {}: not held, [TRAJ] limits the tool", name, limit_name));
            };
            of("MAX_VELOCITY", limits.velocity);
            of("MAX_ACCELERATION", limits.acceleration);
        }
    }

    /// Reads an axis.
    void read_axis(int axis, const std::vector<std::string>& sections) {
        const bool angle =
            joints() && axis < 3 ? turning(machine_.kinematics)[axis] : axis >= 3 && axis < 6;
        AxisLimits& limits = machine_.axis[axis];
        read_limits(joints() && axis < 3 ? fmt::format("joint {}", axis)
                                         : std::string(1, kAxisLetters[axis]),
                    sections, angle ? 1 : unit_, axis >= 3 && axis < 6, limits);
        limits.rotary = axis >= 3 && axis < 6 && is_wrapped(sections);
        if (limits.rotary) {
            limits.min = -kUnlimitedTravel;
            limits.max = kUnlimitedTravel;
        }
        limits.rotary =
            limits.rotary || (axis >= 3 && axis < 6 && limits.min == -kUnlimitedTravel &&
                              limits.max == kUnlimitedTravel && is_angular(sections));
        read_mode(axis, sections);
    }

    /// Reads limits of what a name says; where sections differ, the tighter one holds.
    void read_limits(const std::string& of, const std::vector<std::string>& sections, double unit,
                     bool turns, AxisLimits& limits) {
        const auto take = [&](const char* name, double& field, double otherwise) {
            const std::optional<double> value = tightest(sections, name, unit);
            if (!value) {
                note(fmt::format("{} {}: {:g}", of, name, otherwise));
            }
            field = value.value_or(otherwise);
        };
        take("MAX_VELOCITY", limits.velocity, limits.velocity);
        take("MAX_ACCELERATION", limits.acceleration, limits.acceleration);
        take("MAX_JERK", limits.jerk, limits.acceleration / kJerkTime);
        any_jerk_ = any_jerk_ || tightest(sections, "MAX_JERK", unit);
        read_travel(of, sections, unit, turns, limits);
    }

    std::optional<double> tightest(const std::vector<std::string>& sections, const char* name,
                                   double unit) {
        std::optional<double> least;
        for (const std::string& section : sections) {
            if (const std::optional<double> value = limit(section, name, unit)) {
                least = std::min(*value, least.value_or(*value));
            }
        }
        return least;
    }

    void read_mode(int axis, const std::vector<std::string>& sections) {
        Vibration& mode = machine_.modes[axis];
        for (const std::string& section : sections) {
            mode.hertz = limit(section, "SHAPER_FREQUENCY", 1).value_or(mode.hertz);
            mode.advance_s = limit(section, "PRESSURE_ADVANCE", 1).value_or(mode.advance_s);
            if (mode.advance_s > 0 && machine_.shaper != ShaperKind::kFeedForward) {
                throw InputError(ini_.file(), ini_.find(section, "PRESSURE_ADVANCE")->line,
                                 "PRESSURE_ADVANCE needs SHAPER = feed-forward in [TRAJ]");
            }
            const std::optional<double> damping = ini_.number(section, "SHAPER_DAMPING");
            mode.damping = damping.value_or(mode.damping);
            if (mode.damping >= 0 && mode.damping < 1) continue;
            throw InputError(
                ini_.file(), ini_.find(section, "SHAPER_DAMPING")->line,
                fmt::format("SHAPER_DAMPING = {:g}: a ratio from 0 to below 1", mode.damping));
        }
    }

    void read_shaper() {
        const std::optional<IniEntry> entry = ini_.find("TRAJ", "SHAPER");
        if (!entry) return;
        const auto known = std::find(kShaperNames.begin(), kShaperNames.end(), entry->value);
        if (known == kShaperNames.end()) {
            throw InputError(
                ini_.file(), entry->line,
                fmt::format("SHAPER = {}: none, feed-forward, zv or ei", entry->value));
        }
        machine_.shaper = static_cast<ShaperKind>(known - kShaperNames.begin());
    }

    void read_travel(const std::string& of, const std::vector<std::string>& sections, double unit,
                     bool turns, AxisLimits& limits) {
        limits.min = -kUnlimitedTravel;
        limits.max = kUnlimitedTravel;
        if (turns && is_wrapped(sections)) return;
        for (const std::string& section : sections) {
            const std::optional<double> min = ini_.number(section, "MIN_LIMIT");
            const std::optional<double> max = ini_.number(section, "MAX_LIMIT");
            limits.min = std::max(limits.min, min.value_or(-kUnlimitedTravel) * unit);
            limits.max = std::min(limits.max, max.value_or(kUnlimitedTravel) * unit);
            if (limits.min >= limits.max) {
                const char* name = max ? "MAX_LIMIT" : "MIN_LIMIT";
                throw InputError(
                    ini_.file(), ini_.find(section, name)->line,
                    fmt::format("{} has no travel: MIN_LIMIT {:g} mm, MAX_LIMIT {:g} mm", of,
                                limits.min, limits.max));
            }
        }
    }

    bool is_wrapped(const std::vector<std::string>& sections) const {
        return std::any_of(sections.begin(), sections.end(), [this](const std::string& section) {
            return ini_.number(section, "WRAPPED_ROTARY").value_or(0) != 0;
        });
    }

    bool is_angular(const std::vector<std::string>& sections) const {
        return std::any_of(sections.begin(), sections.end(), [this](const std::string& section) {
            const std::optional<IniEntry> type = ini_.find(section, "TYPE");
            return type && type->value == "ANGULAR";
        });
    }

    /// Returns the limits of an axis of the path.
    const AxisLimits& of_path(int axis) const {
        return joints() ? machine_.tool[static_cast<std::size_t>(axis)] : machine_.axis[axis];
    }

    /// Reads the limits along the path; by default those that the axes together allow.
    void read_path(const std::string& axes) {
        const auto together = [&](double AxisLimits::*limit) {
            double sum = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const bool counts =
                    axes.empty() || axes.find(kAxisLetters[axis]) != std::string::npos;
                sum = std::hypot(sum, counts ? of_path(axis).*limit : 0);
            }
            return sum > 0 ? sum : of_path(0).*limit;
        };
        const auto take = [&](const char* name, const char* old_name, double AxisLimits::*limit_of,
                              double& field) {
            std::optional<double> value = limit("TRAJ", name, unit_);
            if (!value) value = limit("TRAJ", old_name, unit_);
            if (!value) {
                note(fmt::format("{}: {:g}, from the axes", name, together(limit_of)));
            }
            field = value.value_or(together(limit_of));
        };
        take("MAX_LINEAR_VELOCITY", "MAX_VELOCITY", &AxisLimits::velocity, machine_.velocity);
        take("MAX_LINEAR_ACCELERATION", "MAX_ACCELERATION", &AxisLimits::acceleration,
             machine_.acceleration);
        const std::optional<double> jerk = limit("TRAJ", "MAX_LINEAR_JERK", unit_);
        const bool of_axes = any_jerk_ && !joints();
        machine_.jerk = jerk.value_or(of_axes ? together(&AxisLimits::jerk)
                                              : machine_.acceleration / kJerkTime);
        if (!jerk) {
            note(fmt::format("MAX_LINEAR_JERK: {:g}, {}", machine_.jerk,
                             of_axes ? "from the axes" : "from the acceleration"));
        }
        machine_.joint_time = limit("TRAJ", "JOINT_TIME", 1).value_or(machine_.joint_time);
    }

    const IniFile& ini_;
    Machine machine_;
    double unit_ = 1;  // mm
    bool any_axis_ = false;
    bool any_jerk_ = false;  // MAX_JERK of an axis
};

}  // namespace

Machine read_machine(const std::string& file) {
    return read_machine_text(read_text_file(file), file);
}

Machine read_machine_text(std::string_view text, const std::string& file_name) {
    const IniFile ini(text, file_name);
    return MachineReader(ini).read();
}

}  // namespace curvecore::ref
