// SPDX-License-Identifier: Apache-2.0
#include "sysc/home/home_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "ref/gcode/state/coordinates.hpp"
#include "ref/machine/ini_file.hpp"
#include "ref/machine/machine.hpp"
#include "ref/text/input_error.hpp"
#include "ref/text/text_file.hpp"
#include "sysc/home/joints.hpp"

namespace curvecore::sysc {
namespace {

/// Search distance as a multiple of the travel: a switch may be beyond its end.
constexpr double kReach = 1.25;
constexpr double kLastInTurn = 1e9;

class HomeReader {
  public:
    HomeReader(const ref::IniFile& ini, const ref::Machine& machine)
        : ini_(ini), machine_(machine) {}

    std::vector<AxisHome> read() {
        for (const Joint& joint : joints_of(ini_)) read_axis(joint);
        std::sort(found_.begin(), found_.end(),
                  [](const Found& a, const Found& b) { return key(a) < key(b); });
        std::vector<AxisHome> homes;
        for (const Found& one : found_) homes.push_back(one.home);
        return homes;
    }

  private:
    struct Found {
        AxisHome home;
        double sequence;
    };

    static std::tuple<double, bool, int> key(const Found& one) {
        return {one.sequence, one.home.axis != 2, one.home.axis};
    }

    void read_axis(const Joint& joint) {
        const auto& [axis, section, unit] = joint;
        const auto number = [&](const char* name) {
            return ini_.number(joint.section, name).value_or(0);
        };
        const auto refuse = [&](const char* name, const std::string& reason) {
            const auto entry = ini_.find(joint.section, name);
            throw ref::InputError(ini_.file(), entry ? entry->line : 0,
                                  fmt::format("[{}] {}", joint.section, reason));
        };
        AxisHome home;
        home.axis = axis;
        home.search = number("HOME_SEARCH_VEL") * unit;
        if (home.search == 0) return;
        home.latch = number("HOME_LATCH_VEL") * unit;
        home.place = number("HOME_OFFSET") * unit;
        home.home = number("HOME") * unit;
        home.ignore_limits = is_set(section, "HOME_IGNORE_LIMITS");
        const ref::AxisLimits& limits = machine_.axis[axis];
        home.reach = kReach * (limits.max - limits.min);
        if (home.latch == 0) refuse("HOME_SEARCH_VEL", "HOME_LATCH_VEL is missing");
        if (is_set(section, "HOME_USE_INDEX")) {
            refuse("HOME_USE_INDEX", "HOME_USE_INDEX: there is no index input");
        }
        if (!(home.reach < ref::kFarthest)) {
            refuse("HOME_SEARCH_VEL", "MIN_LIMIT and MAX_LIMIT are needed to look for a switch");
        }
        if (home.home < limits.min || home.home > limits.max) {
            refuse("HOME", fmt::format("HOME is beyond the travel {:g} .. {:g} mm", limits.min,
                                       limits.max));
        }
        for (const Found& other : found_) {
            if (other.home.axis == axis) {
                refuse("HOME_SEARCH_VEL", "an axis of two joints cannot be homed");
            }
        }
        const auto sequence = ini_.number(section, "HOME_SEQUENCE");
        found_.push_back({home, sequence ? std::abs(*sequence) : kLastInTurn});
    }

    bool is_set(const std::string& section, const char* name) const {
        const auto entry = ini_.find(section, name);
        if (!entry) return false;
        const char first = entry->value.empty() ? '0' : entry->value[0];
        return std::string_view("1YyTt").find(first) != std::string_view::npos;
    }

    const ref::IniFile& ini_;
    const ref::Machine& machine_;
    std::vector<Found> found_;
};

}  // namespace

std::vector<AxisHome> read_homes(const std::string& machine_file) {
    const ref::IniFile ini(ref::read_text_file(machine_file), machine_file);
    return HomeReader(ini, ref::read_machine(machine_file)).read();
}

}  // namespace curvecore::sysc
