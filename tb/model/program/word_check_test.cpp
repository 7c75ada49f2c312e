// SPDX-License-Identifier: Apache-2.0
// A part whose words would overflow is refused with its line, independently of the planner's
// checks.
#include "sysc/curves/word_check.hpp"

#include <gtest/gtest.h>

#include "ref/feed/planner.hpp"
#include "ref/segment/spline_segment.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb::word_check_test {

/// A line, then a spline whose speed has its minimum, half its maximum, on the way.
ref::Program program() {
    ProgramBuilder builder;
    builder.line({1, 0, 0}, 20);
    builder.cubic({1.625151909490, 0, 0}, {1.877775853916, 0, 0}, {2.202284592285, 0, 0}, 20);
    return builder.program();
}

sysc::Job job() {
    sysc::Job job;
    job.options.core.splines = 1;
    job.program.file = program().file;
    return job;
}

ref::Plan plan() { return make_plan(program(), ref::Machine(), job().options.plan_options()); }

std::string refusal(const ref::Plan& plan) {
    try {
        check_words(job(), plan);
    } catch (const ref::InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(WordCheck, AcceptsWhatThePlannerMade) { EXPECT_EQ(refusal(plan()), "accepted"); }

TEST(WordCheck, RefusesAnOverflowAtItsLine) {
    ref::Plan whole = plan();
    const ref::Cubic cubic = program().moves[1].cubic;
    ref::Segment segment =
        ref::spline_segment({1e6 * cubic.a, 1e6 * cubic.b, 1e6 * cubic.c, 1e6 * cubic.d}, {});
    segment.line = 2;
    segment.step_exponent = segment.spline().lambda - 5;
    whole.segments = {segment};
    EXPECT_EQ(refusal(whole),
              "test.ngc:2: error: a word of the core's network would need 1 more bits for this "
              "spline");
}

TEST(WordCheck, RefusesALengthBeyondItsWord) {
    ref::Plan longer = plan();
    longer.segments[0].length = std::uint64_t{1} << 44;
    EXPECT_EQ(refusal(longer), "test.ngc:1: error: a planned length does not fit its word");
}

}  // namespace curvecore::tb::word_check_test
