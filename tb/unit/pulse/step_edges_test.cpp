// SPDX-License-Identifier: Apache-2.0
// Distance of the edges of rtl/pulse/step_generator.sv from the crossings of the unrounded place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "ref/numeric/step_crossings.hpp"
#include "tb/support/pins/step_bench.hpp"

namespace curvecore::tb {
namespace {

/// Scale of 2000 / 3 steps per mm, positions of 2^-10 nm: no word represents it, and places are
/// rounded.
TEST(StepEdges, AreWhereTheUnroundedPlaceCrossesButForWhatTheRoundingTakes) {
    const ref::StepCrossings exact(2000, int64_t{3'000'000} * 1024);
    const double units = 1.5e3 * 1024;  // per step
    const auto scale = std::llround(std::exp2(kFineBits + hls::kStepFraction) / units);
    std::mt19937_64 random(1);
    StepBench bench;
    for (const double rate : {4.0, 1.0, 0.5, 0.25, 0.13, 0.06}) {  // steps per sample
        // Clocks that 2^-16 step takes at this rate.
        const double rounding = static_cast<double>(kPeriod) / 65536 / rate;
        double early = 0;
        double late = 0;
        int steps = 0;
        for (int run = 0; run < 6; ++run) {
            const bool back = run % 2 == 1;
            bench.reset();
            for (int a = 0; a < kStepAxes; ++a) bench.set_scale(a, scale);
            bench.reference();
            std::vector<int64_t> position(kStepAxes);
            std::vector<int64_t> last(kStepAxes);
            for (int64_t& p : position) p = static_cast<int64_t>(random()) >> (66 - kFineBits);
            std::vector<std::deque<double>> due(kStepAxes);
            bench.offer(position);
            bool first = true;
            bool waits = false;
            int64_t high = 0;
            const int samples = static_cast<int>(12 / rate) + 4;
            for (int n = 0; n < samples;) {
                const int64_t ticked = bench.ticked();
                const bool taken = bench.clock();
                if (bench.ticked() != ticked && waits) {
                    waits = false;
                    for (int a = 0; a < kStepAxes; ++a) {
                        const auto start = static_cast<double>(bench.ticked() + kLatency + a);
                        if (!first) {
                            exact.between(last[a], position[a],
                                          [&](const ref::StepCrossing& crossing) {
                                              due[a].push_back(start + crossing.time(kPeriod));
                                          });
                        }
                        last[a] = position[a];
                        const auto moved = static_cast<int64_t>(rate * units);
                        position[a] += back ? -moved : moved;
                    }
                    first = false;
                    bench.offer(position);
                }
                for (int a = 0; a < kStepAxes; ++a) {
                    if (!bench.step(a) || (high >> a & 1) != 0) continue;
                    ASSERT_FALSE(due[a].empty());
                    const double lateness = static_cast<double>(bench.now()) - due[a].front();
                    due[a].pop_front();
                    early = std::min(early, lateness);
                    late = std::max(late, lateness);
                    ++steps;
                }
                high = bench->step_o;
                waits = waits || taken;
                n += taken ? 1 : 0;
            }
        }
        printf("%5.2f steps per sample: 2^-16 step is %.2f clocks; edges at %.2f to %.2f\n", rate,
               rounding, early, late);
        EXPECT_GT(steps, 50);
        // The edge is in the clock after the crossing; places are rounded down, scales to a quarter
        // of that.
        EXPECT_GE(early, -1.25 * rounding);
        EXPECT_LE(late, 1 + 1.25 * rounding);
        EXPECT_GT(late - early, 0.8) << "the bound is idle";
    }
}

}  // namespace
}  // namespace curvecore::tb
