// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/cycles/canned_cycles.hpp"

#include <fmt/format.h>

#include "ref/gcode/state/move_list.hpp"

namespace curvecore::ref {
namespace {

using Kind = CycleStep::Kind;

constexpr double kPeckClearance = 0.254;  // mm, LinuxCNC's
constexpr double kMostPecks = 20000;      // pecks of one block
constexpr std::string_view kOffsets = "IJK";

const char* start_of(Turning turning) { return turning == Turning::kClockwise ? "M3" : "M4"; }

Turning reversed(Turning turning) {
    return turning == Turning::kClockwise ? Turning::kCounterClockwise : Turning::kClockwise;
}

/// @throws InputError if the spindle does not turn as the cycle needs
void check_spindle(int g_code, Turning turning, const Place& place) {
    const bool tapping = g_code == 740 || g_code == 840;
    if (tapping) {
        const Turning wanted = g_code == 840 ? Turning::kClockwise : Turning::kCounterClockwise;
        if (turning != wanted) {
            place.refuse(fmt::format("{} wants the spindle to turn: {} before it", g_name(g_code),
                                     start_of(wanted)));
        }
    } else if (g_code >= 860 && g_code <= 880 && turning == Turning::kNo) {
        place.refuse(
            fmt::format("{} wants the spindle to turn: M3 or M4 before it", g_name(g_code)));
    }
}

}  // namespace

/// A cycle at one place.
struct CannedCycles::Drill {
    const CarryOut& carry_out;
    int normal;
    Turning turning;
    Point at;  // in the plane
    double r;  // heights
    double bottom;
    double clear;

    Point place(double height) const {
        Point point = at;
        point[normal] = height;
        return point;
    }
    void rapid(double height) const { carry_out({Kind::kRapid, place(height), 0, ""}); }
    void feed(double height) const { carry_out({Kind::kFeed, place(height), 0, ""}); }
    void dwell(double seconds) const { carry_out({Kind::kDwell, {}, seconds, ""}); }
    void toggle(const char* code) const { carry_out({Kind::kSwitch, {}, 0, code}); }

    void pecks(double step, double clearance, bool whole_way) const {
        for (int n = 1; r - n * step > bottom; ++n) {
            const double depth = r - n * step;
            feed(depth);
            if (whole_way) rapid(r);
            rapid(depth + clearance);
        }
        feed(bottom);
        rapid(clear);
    }

    void tap(double seconds) const {
        feed(bottom);
        toggle("M5");
        toggle(start_of(reversed(turning)));
        dwell(seconds);
        feed(clear);
        toggle("M5");
        toggle(start_of(turning));
    }

    /// Bores from below: down and up with the spindle `aside` of the hole's axis.
    void bore_back(const Point& aside, double middle) const {
        Drill beside = *this;
        for (int axis = 0; axis < 3; ++axis) beside.at[axis] += axis == normal ? 0 : aside[axis];
        beside.rapid(r);
        toggle("M5");
        toggle("M19");
        beside.rapid(bottom);
        rapid(bottom);
        toggle(start_of(turning));
        feed(middle);
        feed(bottom);
        toggle("M5");
        toggle("M19");
        beside.rapid(bottom);
        beside.rapid(clear);
        rapid(clear);
        toggle(start_of(turning));
    }
};

void CannedCycles::keep_words(int g_code, bool again, Block& block, const Coordinates& coordinates,
                              const Modes& modes, const Place& place) {
    const double unit = coordinates.unit();
    const std::string name = g_name(g_code);
    const auto keep = [&](double& kept, char letter, double scale, bool wanted, const char* what) {
        if (block.has(letter)) {
            kept = block.use(letter) * scale;
        } else if (wanted && !again) {
            place.refuse(fmt::format("{} without {} ({})", name, letter, what));
        }
    };
    if (modes.feed_mode == FeedMode::kInverseTime) {
        place.refuse(fmt::format("{} and G93 exclude each other", name));
    }
    const char axis = kAxisLetters[modes.normal_axis];
    if (block.has(axis)) {
        depth_ = coordinates.number(block, modes.normal_axis);
    } else if (!again) {
        place.refuse(fmt::format("{} without {} (the depth)", name, axis));
    }
    keep(r_, 'R', unit, true, "the height where rapids end");
    const bool pecks = g_code == 730 || g_code == 830;
    if (pecks) {
        keep(q_, 'Q', unit, true, "the depth of a peck");
        if (!(q_ > 0)) place.refuse(fmt::format("Q of {} must be above 0", name));
        clearance_ = block.has('D') ? block.use('D') * unit : kPeckClearance;
    } else if (g_code == 870) {
        for (int i = 0; i < 3; ++i) keep(offset_[i], kOffsets[i], unit, true, "from the hole");
    } else if (g_code != 810 && g_code != 850) {
        const bool tapping = g_code == 740 || g_code == 840;
        keep(p_, 'P', 1, !tapping, "seconds of rest; 0 for none");
        if (!(p_ >= 0 && p_ <= kLongestDwell)) {
            place.refuse(fmt::format("P of {} must be 0 to {:g} seconds, not {:g}", name,
                                     kLongestDwell, p_));
        }
    }
}

void CannedCycles::carry_out(int g_code, bool again, Block& block, const Coordinates& coordinates,
                             const Modes& modes, const Place& place, const CarryOut& carry_out) {
    keep_words(g_code, again, block, coordinates, modes, place);
    check_spindle(g_code, modes.turning, place);
    const int repeats = block.has('L') ? whole_number('L', block.use('L'), 0, 9999, place) : 1;
    const int normal = modes.normal_axis;
    Point at = coordinates.program_position();
    double height = at[normal];
    if (!initial_) initial_ = height;
    if (repeats == 0) return;  // the words are kept for later blocks
    double initial = *initial_;
    Point step{};
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        if (axis == normal || !block.has(kAxisLetters[axis])) continue;
        const double number = coordinates.number(block, axis);
        (coordinates.absolute() ? at : step)[axis] = number;
    }
    const double r = coordinates.absolute() ? r_ : r_ + initial;
    const double bottom = coordinates.absolute() ? depth_ : depth_ + r;
    if (r < bottom) {
        place.refuse(
            fmt::format("{}: R is below the depth {}", g_name(g_code), kAxisLetters[normal]));
    }
    if ((g_code == 730 || g_code == 830) && (r - bottom) / q_ * repeats > kMostPecks) {
        place.refuse(
            fmt::format("{}: more than {:g} pecks in one block", g_name(g_code), kMostPecks));
    }
    if (initial < r) {
        Point raised = coordinates.program_position();
        raised[normal] = initial = height = r;
        carry_out({Kind::kRapid, raised, 0, ""});
    }
    carry_out({Kind::kExactPath, {}, 0, ""});
    Drill drill{carry_out, normal, modes.turning, at, r, bottom, modes.retract_to_r ? r : initial};
    for (int n = 0; n < repeats; ++n) {
        for (int axis = 0; axis < kMachineAxes; ++axis) drill.at[axis] += step[axis];
        const double over = n == 0 && height > r ? height : drill.clear;
        drill.rapid(over);
        if (over > r) drill.rapid(r);
        switch (g_code) {
            case 730:
            case 830:
                drill.pecks(q_, clearance_, g_code == 830);
                break;
            case 740:
            case 840:
                drill.tap(p_);
                break;
            case 870:
                drill.bore_back({offset_[0], offset_[1], offset_[2]},
                                offset_[normal] + (coordinates.absolute() ? 0 : bottom));
                break;
            default:
                drill.feed(bottom);
                if (g_code != 810 && g_code != 850) drill.dwell(p_);
                if (g_code == 860 || g_code == 880) drill.toggle("M5");
                if (g_code == 880) drill.toggle("M0");
                if (g_code == 850) drill.feed(r);
                if (g_code == 890) {
                    drill.feed(drill.clear);
                } else {
                    drill.rapid(drill.clear);
                }
                if (g_code == 860 || g_code == 880) drill.toggle(start_of(modes.turning));
        }
    }
}

}  // namespace curvecore::ref
