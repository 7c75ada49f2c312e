// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/cycles/thread_cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/numeric/angles.hpp"

namespace curvecore::ref {
namespace {

using Kind = CycleStep::Kind;

constexpr int kMostPasses = 2000;

/// The words of G76, mm: X and Z of its drive line's start and end; depths along X are from the
/// drive line, to the inside where `inwards` is -1.
struct Thread {
    Point start, end;
    double inwards = -1;
    double peak = 0;            // |I|: height of the thread's peak
    double first_cut = 0;       // J
    double height = 0;          // K
    double pitch = 0;           // P
    double degression = 1;      // R
    double compound_slope = 0;  // tangent of Q, along Z
    double taper = 0;           // E, along Z
    bool entry_taper = false, exit_taper = false;
    int spring_passes = 0;

    double deepest() const { return peak + height; }
};

double word(Block& block, char letter, double otherwise) {
    return block.has(letter) ? block.use(letter) : otherwise;
}

Thread read_thread(Block& block, const Coordinates& coordinates, const Place& place) {
    const double unit = coordinates.unit();
    const double of_x = coordinates.modes().diameter ? unit / 2 : unit;
    if (!block.has('P') || !block.has('I') || !block.has('J') || !block.has('K')) {
        place.refuse("G76 wants P (pitch), I (peak), J (first cut) and K (full depth)");
    }
    Thread thread;
    thread.start = coordinates.program_position();
    const double peak = block.use('I') * of_x;
    thread.inwards = peak > 0 ? 1 : -1;
    thread.peak = std::abs(peak);
    thread.first_cut = block.use('J') * of_x;
    thread.height = block.use('K') * of_x;
    if (peak == 0) place.refuse("I of G76 must not be 0");
    if (!(thread.first_cut > 0)) place.refuse("J of G76 must be above 0");
    if (!(thread.height > thread.first_cut)) place.refuse("K of G76 must be above J");
    thread.pitch = block.use('P') * unit;
    thread.degression = std::max(1.0, word(block, 'R', 1));
    thread.spring_passes = whole_number('H', word(block, 'H', 0), 0, kMostPasses, place);
    const int tapers = whole_number('L', word(block, 'L', 0), 0, 3, place);
    thread.entry_taper = (tapers & 1) != 0;
    thread.exit_taper = (tapers & 2) != 0;
    thread.compound_slope = std::tan(word(block, 'Q', 0) * kRadiansPerDegree);
    thread.taper = std::max(0.0, word(block, 'E', 0)) * unit;
    return thread;
}

class Passes {
  public:
    Passes(const Thread& thread, const CarryOut& carry_out)
        : thread_(thread), carry_out_(carry_out) {
        const double rise = std::hypot(thread.taper, thread.height);
        tapered_pitch_ = thread.taper > 0 ? thread.pitch * rise / thread.taper : thread.pitch;
        along_ = thread.end[2] > thread.start[2] ? -1 : 1;  // direction of taper and compound slope
    }

    /// Cuts a pass at a depth from the drive line.
    void cut(double depth) const {
        const double shift = (depth - thread_.peak) * slope();
        const double from = thread_.start[2] - shift;
        const double to = thread_.end[2] + thread_.height * slope() - shift;
        const double ramp = thread_.taper * along_;
        const double clear = depth - thread_.deepest();
        const double shallow = depth - thread_.height;
        go(Kind::kRapid, clear, from);
        if (ramp != 0 && thread_.entry_taper) {
            go(Kind::kThread, shallow, from, tapered_pitch_);
            go(Kind::kThread, depth, from - ramp, tapered_pitch_);
        } else {
            go(Kind::kRapid, depth, from);
        }
        if (ramp != 0 && thread_.exit_taper) {
            go(Kind::kThread, depth, to + ramp, thread_.pitch);
            go(Kind::kThread, shallow, to, tapered_pitch_);
        } else {
            go(Kind::kThread, depth, to, thread_.pitch);
        }
        go(Kind::kRapid, clear, to);
    }

  private:
    double slope() const { return thread_.compound_slope * along_; }

    void go(Kind kind, double depth, double z, double pitch = 0) const {
        Point point = thread_.start;
        point[0] += thread_.inwards * depth;
        point[2] = z;
        carry_out_({kind, point, pitch, ""});
    }

    const Thread& thread_;
    const CarryOut& carry_out_;
    double tapered_pitch_;
    double along_;
};

/// Depth of the n-th pass.
double depth_of(const Thread& thread, int n) {
    return thread.peak + thread.first_cut * std::pow(n, 1 / thread.degression);
}

void turn_thread(const Thread& thread, const Place& place, const CarryOut& carry_out) {
    if (depth_of(thread, kMostPasses) < thread.deepest()) {
        place.refuse(fmt::format("G76 wants more than {} passes", kMostPasses));
    }
    const Passes passes(thread, carry_out);
    for (int n = 1; depth_of(thread, n) < thread.deepest(); ++n) passes.cut(depth_of(thread, n));
    for (int n = 0; n <= thread.spring_passes; ++n) passes.cut(thread.deepest());
    carry_out({Kind::kRapid, thread.end, 0, ""});
}

}  // namespace

void carry_out_thread(int g_code, Block& block, const Coordinates& coordinates, const Modes& modes,
                      const Place& place, const CarryOut& carry_out) {
    const std::string name = g_name(g_code);
    if (modes.turning == Turning::kNo || modes.speed == 0) {
        place.refuse(fmt::format("{} wants the spindle to turn: S and M3 or M4 before it", name));
    }
    if (g_code != 330 && block.has_any("ABCUVW")) {
        place.refuse(fmt::format("{} takes the axes X, Y and Z only", name));
    }
    const Point start = coordinates.program_position();
    const Point end = coordinates.in_program(coordinates.target(block, false, place));
    if (g_code == 760) {
        Thread thread = read_thread(block, coordinates, place);
        thread.end = end;
        turn_thread(thread, place, carry_out);
        return;
    }
    if (!block.has('K')) place.refuse(fmt::format("{} without K (the way for each turn)", name));
    const double pitch = block.use('K') * coordinates.unit();
    if (!(pitch > 0)) place.refuse(fmt::format("K of {} must be above 0", name));
    carry_out({Kind::kThread, end, pitch, ""});
    if (g_code == 330) return;
    if (block.has('I')) block.use('I');  // factor of the return speed: not used
    carry_out({Kind::kSwitch, {}, 0, ""});
    carry_out({Kind::kThread, start, pitch, ""});
    carry_out({Kind::kSwitch, {}, 0, ""});
}

}  // namespace curvecore::ref
