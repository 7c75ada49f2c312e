// SPDX-License-Identifier: Apache-2.0
// Pieces of whole ticks that end exactly, made from a motion in real numbers.
//
// This is the one place of ref/ that rounds to the hardware's integers (with the steps of a stop in
// stop_branch): a piece has to end on its length to a quantum, so its last coefficient takes what
// the others have rounded, and limits, joints and windows are judged by the motion that the
// integers give. The fields' widths and places on the bus are those of hls/words.hpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "ref/feed/ramps/zone_ramps.hpp"
#include "ref/machine/machine.hpp"
#include "ref/plan/segment.hpp"

namespace curvecore::ref {

constexpr std::uint32_t kMaxTicks = 1u << 19;  // longest piece, ticks
/// Largest planned exponent: its rounding, 2^(e-35) quanta, stays below 2^-11 unit.
constexpr int kMaxPlannedExponent = 40;

/// Longest piece: `ticks`, or `slow_ticks` if it covers at most `path` quanta; but parts of a
/// motion are not shorter than `least` ticks for that.
struct Reach {
    std::uint64_t ticks = kMaxTicks;
    std::uint64_t slow_ticks = 0;
    std::uint64_t path = 0;  // quanta
    std::uint64_t least = 1;

    bool holds(std::uint64_t time, std::uint64_t gone) const {
        return time <= ticks || (time <= slow_ticks && gone <= path);
    }
    /// Returns the number of such pieces, alike, that a motion at constant speed takes.
    std::uint64_t parts(std::uint64_t time, std::uint64_t gone) const {
        const auto shares = [](std::uint64_t whole, std::uint64_t most) {
            return most == 0 ? whole : (whole + most - 1) / most;
        };
        const std::uint64_t slow = std::max(shares(time, slow_ticks), shares(gone, path));
        const std::uint64_t parts = std::min(shares(time, ticks), slow);
        return std::max<std::uint64_t>(1, std::min(parts, time / least));
    }
};

/// | field    | unit  | remark                                                           |
/// |----------|-------|------------------------------------------------------------------|
/// | tick     | s     |                                                                  |
/// | quantum  | mm    | of path                                                          |
/// | shortest | ticks | no piece inside a run is shorter: the rounding of its ends would |
/// |          |       | show in the jerk                                                 |
/// | longest  |       | longest piece of a motion                                        |
struct PieceGrid {
    double tick;
    double quantum;
    std::uint64_t shortest;
    Reach longest;

    PieceGrid(const Machine& machine, double unit_mm, double tick_s);
};

/// Appends the pieces of one run of `length` quanta.
///
/// The run is stretched in time to whole ticks; speed, acceleration and jerk only shrink. It keeps
/// its speeds at its ends, where others join it. The boundaries of the phases move to the nearest
/// tick, and a cubic joins path and speed of the motion at both ends of each piece. Its jerk is a
/// mean of the motion's jerk over the piece (with the weight 6 tau (1 - tau)), so the limit holds;
/// path is exact and speed continuous.
void append_run(const std::vector<Phase>& phases, std::uint64_t length, const PieceGrid& grid,
                std::vector<ProfilePiece>& pieces);

/// Appends at least `seconds` of rest.
void append_rest(double seconds, const PieceGrid& grid, std::vector<ProfilePiece>& pieces);

double ticks_of(const std::vector<ProfilePiece>& pieces);

/// Highest speed whose pieces fit their words, mm/s.
double fastest_word(const PieceGrid& grid);

/// Path, speed, acceleration, jerk of a piece after `ticks`, from its words in real numbers; quanta
/// and ticks.
struct PieceState {
    double s, v, a, j;
};
PieceState piece_state(const ProfilePiece& piece, double ticks);

}  // namespace curvecore::ref
