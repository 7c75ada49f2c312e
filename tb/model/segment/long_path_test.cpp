// SPDX-License-Identifier: Apache-2.0
// Paths at the ends of their words: a long line is cut into segments, a long program is refused.
#include <gtest/gtest.h>

#include "ref/format/path_words.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb::long_path_test {

ref::Machine wide() {
    ref::Machine machine;
    for (ref::AxisLimits& axis : machine.axis) {
        axis.min = -2141;
        axis.max = 2141;
    }
    return machine;
}

TEST(LongPath, ALineLongerThanItsWordIsCut) {
    ProgramBuilder builder;
    builder.line({-2100, -2100, -2100}, 1000);
    builder.line({2100, 2100, 2100}, 1000);  // 7.27 m
    ref::PlanOptions options;
    options.error_limit = 0.25;
    const ref::Geometry geometry = make_geometry(builder.program(), wide(), options);
    std::uint64_t s = 0;
    for (const ref::Segment& segment : geometry.segments) {
        EXPECT_EQ(segment.s_start, s);
        EXPECT_LT(segment.length, std::uint64_t{1} << ref::kBusLengthBits);
        const double length = std::ldexp(static_cast<double>(segment.length), -ref::kPathFrac);
        EXPECT_NEAR((segment.end - segment.start).norm(), length, 1e-4);
        s += segment.length;
    }
    const double whole = 1.5 * std::sqrt(3) * 4200e6;
    EXPECT_NEAR(std::ldexp(static_cast<double>(s), -ref::kPathFrac), whole, 1e-3);
}

TEST(LongPath, AProgramLongerThanItsWordIsRefusedAtItsLine) {
    ProgramBuilder builder;
    for (int n = 0; n < 33500; ++n) builder.line({n % 2 == 0 ? 2140.0 : -2140.0, 0, 0}, 1000);
    try {
        make_geometry(builder.program(), wide(), {});
        FAIL() << "accepted";
    } catch (const ref::InputError& error) {
        EXPECT_STREQ(
            error.what(),
            "test.ngc:32884: error: the program's path is 140741 m here; a program of this "
            "unit is shorter than 140737 m");
    }
    builder.program().moves.resize(32883);
    EXPECT_NO_THROW(make_geometry(builder.program(), wide(), {}));
}

}  // namespace curvecore::tb::long_path_test
