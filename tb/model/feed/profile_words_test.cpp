// SPDX-License-Identifier: Apache-2.0
// Pieces of the profile compared with the motion that they represent.
#include "ref/feed/pieces/profile_words.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace curvecore::ref::profile_words_test {

constexpr double kUnitMm = 1e-6;
constexpr double kTick = 100e-6;
constexpr double kJerk = 1e9;  // mm/s^3: 5 mm/s in a tick

PieceGrid grid() {
    Machine machine;
    machine.jerk = kJerk;
    for (AxisLimits& axis : machine.axis) axis.jerk = kJerk;
    return PieceGrid(machine, kUnitMm, kTick);
}

/// Least way of a tick, by the mean of its piece; negative: backwards.
double slowest(const std::vector<Phase>& phases, const PieceGrid& grid) {
    const Phase& last = phases.back();
    const auto length = static_cast<std::uint64_t>(last.place(last.duration) / grid.quantum);
    std::vector<ProfilePiece> pieces;
    append_run(phases, length, grid, pieces);
    double least = 1;
    for (const ProfilePiece& piece : pieces) {
        const double mean = static_cast<double>(piece.ds) / piece.ticks;  // quanta a tick
        for (std::uint32_t t = 0; t < piece.ticks; ++t) {
            const double way = piece_state(piece, t + 1).s - piece_state(piece, t).s;
            least = std::min(least, (way + 4) / mean);
        }
    }
    return least;
}

/// Phases end between two ticks, so the last tick of a slow phase contains a part of the next, in
/// which the speed may be a hundred times as high: a cubic over all of the slow phase went
/// backwards, and then through the last of its path eight times too fast.
TEST(ProfileWords, NoPieceGoesBackBesideALongSlowPhase) {
    const PieceGrid grid = profile_words_test::grid();
    std::mt19937 random(1);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    for (int round = 0; round < 300; ++round) {
        const double v = std::pow(10.0, uniform(-2, 1));  // mm/s
        const double slow = uniform(20, 200) * kTick;
        const double ramp = uniform(3, 10) * kTick;
        const double fast = v + kJerk / 2 * ramp * ramp;
        const Phase before{slow, 0, v, 0, 0};
        const std::vector<Phase> faster{before, {ramp, before.place(slow), v, 0, kJerk}};
        EXPECT_GT(slowest(faster, grid), -0.02) << round;
        const Phase brakes{ramp, 0, fast, -kJerk * ramp, kJerk};
        const std::vector<Phase> slower{brakes, {slow, brakes.place(ramp), v, 0, 0}};
        EXPECT_GT(slowest(slower, grid), -0.02) << round;
    }
}

}  // namespace curvecore::ref::profile_words_test
