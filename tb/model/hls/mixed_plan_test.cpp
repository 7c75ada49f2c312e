// SPDX-License-Identifier: Apache-2.0
// Whole plans of lines, arcs and splines through the kernel of the core that draws them all.
#include <gtest/gtest.h>

#include "hls/curve_kernel.hpp"
#include "hls/path_kernel.hpp"
#include "hls/quantise.hpp"
#include "ref/feed/planner.hpp"
#include "ref/plan/curve_follower.hpp"
#include "ref/program/program_reader.hpp"
#include "sysc/words/path_cursor.hpp"
#include "tb/support/segments/parameters_of.hpp"
#include "tb/support/segments/random_splines.hpp"

namespace curvecore::tb::mixed_plan_test {
using namespace sysc;

using C = hls::DefaultSplineConfiguration;

ref::PlanOptions options() {
    ref::PlanOptions options;
    options.format = parameters_of<C>();
    return options;
}

struct Drawn {
    double of_bound = 0;  // worst error of an axis, before rounding
    int samples = 0;
    int splines = 0;  // samples on them
    int stops = 0;
    int missed = 0;  // stops whose word is not the commanded one
};

/// Draws every tick of a plan. `spoil` is added to a word of every spline.
Drawn draw(const ref::Program& program, const ref::Plan& plan, std::int64_t spoil = 0) {
    hls::PathKernel path;
    hls::MotionKernel<C> kernel;
    PathCursor cursor(plan);
    ref::CurveFollower curve;
    std::size_t next_piece = 0;
    std::size_t next_segment = 0;
    const auto pieces = [&](hls::ProfileWords& words) {
        if (next_piece == plan.pieces.size()) return false;
        words = hls::to_words(plan.pieces[next_piece++]);
        return true;
    };
    const auto segments = [&] {
        auto words = hls::to_words<C>(plan.segments.at(next_segment++));
        if (words.kind == hls::SegmentKind::kSpline) words.normal[1] += spoil;
        return words;
    };
    Drawn drawn;
    std::size_t last_stop = plan.segments.size();
    do {
        const auto ds = hls::to_int(path.tick(1 << 16, pieces));
        hls::Word<C::kFineBits> fine[C::kAxes];
        kernel.sample(ds, segments, fine);
        cursor.advance(static_cast<std::uint64_t>(ds));
        const ref::Segment& segment = cursor.segment();
        const ref::Vec3 exact = curve.on(segment).position(cursor.local());
        for (int axis = 0; axis < 3; ++axis) {
            const double got = std::ldexp(static_cast<double>(fine[axis]), -C::kGuardBits);
            drawn.of_bound = std::max(drawn.of_bound, std::abs(got - exact[axis]) / segment.bound);
        }
        ++drawn.samples;
        drawn.splines += segment.kind() == ref::CurveKind::kSpline;
        if (!cursor.at_end() || segment.feed_end > 1e-6 || cursor.index() == last_stop) continue;
        last_stop = cursor.index();
        ++drawn.stops;
        const ref::Vec3 end = segment.end;
        const bool move_ends = last_stop + 1 == plan.segments.size() ||
                               plan.segments[last_stop + 1].move != segment.move;
        for (int axis = 0; axis < 3; ++axis) {
            const double commanded =
                move_ends ? program.moves[segment.move].end[axis] / plan.unit_mm : end[axis];
            drawn.missed += fine[axis] != hls::quantise(commanded, C::kGuardBits, C::kFineBits);
        }
    } while (path.active());
    return drawn;
}

int planned_stops(const ref::Plan& plan) {
    int stops = 0;
    for (const ref::Segment& segment : plan.segments) stops += segment.feed_end < 1e-6;
    return stops;
}

void expect_drawn(const ref::Program& program) {
    const ref::Plan plan = make_plan(program, ref::Machine(), options());
    const Drawn drawn = draw(program, plan);
    EXPECT_LE(drawn.of_bound, 1);
    EXPECT_GT(drawn.of_bound, 0.1) << "the bound is idle";
    EXPECT_EQ(drawn.missed, 0);
    EXPECT_EQ(drawn.stops, planned_stops(plan));
    EXPECT_GT(drawn.splines, 100);
}

TEST(MixedPlan, RandomProgramsAreDrawnWithinTheirBounds) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(seed);
        expect_drawn(random_splines(seed, 25));
    }
}

TEST(MixedPlan, SampleProgramsAreDrawnWithinTheirBounds) {
    for (const char* name : {"splines.ngc", "nurbs.ngc", "points.csv"}) {
        SCOPED_TRACE(name);
        expect_drawn(ref::read_program(std::string(DATA_DIR "/") + name, {}));
    }
}

TEST(MixedPlan, AWrongWordOfASplineLeavesTheBound) {
    const ref::Program program = random_splines(2, 25);
    const ref::Plan plan = make_plan(program, ref::Machine(), options());
    EXPECT_GT(draw(program, plan, 4096).of_bound, 1);
}

}  // namespace curvecore::tb::mixed_plan_test
