// SPDX-License-Identifier: Apache-2.0
// The answer of choose, drawn by the bit-true kernel: the error meets the requirement on hard
// curves; with a bit less it does not.
#include <gtest/gtest.h>

#include <algorithm>

#include "sysc/choose/chooser.hpp"
#include "sysc/choose/relaxation.hpp"
#include "sysc/compare/comparison.hpp"
#include "sysc/curves/arc_families.hpp"
#include "sysc/curves/built_in_curves.hpp"
#include "sysc/curves/spline_families.hpp"

namespace curvecore::tb::choose_test {
using namespace sysc;

const Device& device(std::string_view name) {
    return *std::find_if(kDevices.begin(), kDevices.end(),
                         [&](const Device& one) { return one.name == name; });
}

struct NamedRequirement {
    const char* name;
    double error_mm, radius_mm, length_mm, feed;
    const char* device;

    Requirement requirement() const {
        Requirement requirement;
        requirement.error_mm = error_mm;
        requirement.radius_mm = radius_mm;
        requirement.length_mm = length_mm;
        requirement.feed = feed;
        requirement.travel_mm = 1500;
        requirement.device = &choose_test::device(device);
        return requirement;
    }
};

void PrintTo(const NamedRequirement& requirement, std::ostream* out) { *out << requirement.name; }

/// Seeded arcs in any plane, helices, lines and cubics up to the requirement's sizes.
ref::Program hard_curves(const Requirement& requirement) {
    ref::Program program;
    program.file = "hard curves";
    ArcMaker arcs(7);
    SplineMaker splines(7);
    for (double size = 1; size > 1e-3; size /= 4) {
        if (requirement.arcs()) {
            const double radius =
                std::max(size * requirement.radius_mm, requirement.least_radius_mm);
            for (const bool helix : {false, false, true}) {
                program.moves.push_back(arcs.next({"", radius, helix}));
            }
        }
        if (!requirement.splines()) continue;
        for (const SplineShape shape : {SplineShape::kRandom, SplineShape::kHairpin}) {
            ref::Cubic cubic = splines.next({"", shape, 1e6});
            const double scale = size * requirement.length_mm / cubic.c.norm();
            ref::Move move;
            move.kind = ref::Move::Kind::kCubic;
            move.feed = 10;
            move.cubic = {cubic.a * scale, cubic.b * scale, cubic.c * scale, ref::Vec3::Zero()};
            move.start = move.cubic.position(0);
            move.end = move.cubic.position(1);
            program.moves.push_back(move);
        }
    }
    if (requirement.arcs()) program.moves.push_back(arcs.next({"", 0, false}));
    int line = 0;
    for (ref::Move& move : program.moves) move.line = ++line;
    return program;
}

/// The candidate's plan, drawn with `fewer` coefficient bits less than planned for.
Row draw(const Requirement& requirement, const Candidate& candidate, int fewer) {
    const ref::Program program = hard_curves(requirement);
    const ref::Machine machine = unlimited_machine();
    const Segmenter segmenter(program, machine, candidate.unit_mm, candidate.limit, 100000);
    CoreParameters setting = candidate.parameters;
    const SegmentedProgram segmented = segmenter.segment(setting);
    EXPECT_EQ(segmented.refused, "");
    const Subject subject{program, candidate.unit_mm, requirement.arcs(), requirement.splines(),
                          exact_samples(program, candidate.unit_mm, 30000, [](std::int64_t) {})};
    setting.coef_bits -= fewer;
    return compare_setting(subject, setting, segmented, [](std::int64_t) {});
}

class Choose : public testing::TestWithParam<NamedRequirement> {};

TEST_P(Choose, TheKernelKeepsTheProvenError) {
    const Requirement requirement = GetParam().requirement();
    const std::vector<Choice> choices = Chooser(requirement).smallest(2);
    ASSERT_FALSE(choices.empty());
    for (const Choice& choice : choices) {
        const Candidate& candidate = choice.candidate;
        const Row row = draw(requirement, candidate, 0);
        EXPECT_LE(row.output.worst() * candidate.unit_mm, requirement.error_mm);
        EXPECT_LE(row.of_bound.value_or(2), 1);
        EXPECT_EQ(row.missing_bits, 0);
        EXPECT_LE(choice.demand.bound(), candidate.limit);
    }
}

TEST_P(Choose, ABitLessThanTheAnswerIsRuledOut) {
    const Requirement requirement = GetParam().requirement();
    Chooser chooser(requirement);
    const std::vector<Choice> choices = chooser.smallest(1);
    ASSERT_FALSE(choices.empty());
    for (const auto& [name, reason] : choices.front().binds)
        EXPECT_NE(reason, Reason::kNone) << name;
    Candidate narrow = choices.front().candidate;
    narrow.parameters.coef_bits = 18;
    Choice unused;
    if (choices.front().candidate.parameters.coef_bits > 18) {
        EXPECT_EQ(chooser.judge(narrow, unused), Reason::kDataRate);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Model, Choose,
    testing::Values(NamedRequirement{"Micrometre", 1e-3, 300, 0, 10e3 / 60, "up5k"},
                    NamedRequirement{"Nanometre", 1e-6, 1000, 0, 1000, "ecp5-25"},
                    NamedRequirement{"Half", 0.6e-6, 100, 0, 100, "ecp5-25"},
                    NamedRequirement{"Splines", 1e-3, 0, 100, 100, "up5k"},
                    NamedRequirement{"Both", 2e-5, 50, 50, 50, "ecp5-45"}),
    [](const auto& test) { return test.param.name; });

TEST(ChooseSampleAClock, IsDrawnWithinTheError) {
    Requirement requirement =
        NamedRequirement{"Nanometre", 1e-6, 1000, 0, 1000, "ecp5-25"}.requirement();
    requirement.sample_period_s = 10e-9;
    const std::vector<Choice> choices = Chooser(requirement).smallest(1);
    ASSERT_FALSE(choices.empty());
    const Candidate& candidate = choices.front().candidate;
    EXPECT_EQ(candidate.parameters.sample_interval, 1);
    const Row row = draw(requirement, candidate, 0);
    EXPECT_LE(row.output.worst() * candidate.unit_mm, requirement.error_mm);
    EXPECT_LE(row.of_bound.value_or(2), 1);
    EXPECT_EQ(row.missing_bits, 0);
}

/// Control: words planned for the answer but drawn with two bits less exceed the bound.
TEST(ChooseControl, NarrowerWordsBreakTheProof) {
    const Requirement requirement =
        NamedRequirement{"Nanometre", 1e-6, 1000, 0, 1000, "ecp5-25"}.requirement();
    const Candidate answer = Chooser(requirement).smallest(1).at(0).candidate;
    const Row row = draw(requirement, answer, 2);
    EXPECT_GT(row.of_bound.value_or(0), 1);
}

TEST(ChooseControl, RelaxationsArePossibleAndNeeded) {
    Requirement requirement = NamedRequirement{"", 1e-3, 300, 0, 10e3 / 60, "up5k"}.requirement();
    requirement.unit_mm = 1e-3;
    requirement.error_mm = 0.4e-3;  // below the rounding to the unit
    EXPECT_TRUE(Chooser(requirement).smallest(1).empty());
    const std::vector<Relaxation> found = relaxations(requirement, [](int) {});
    ASSERT_GE(found.size(), 2U);
    EXPECT_EQ(found[0].name, "error");
    EXPECT_GT(found[0].possible, 0.5e-3);
    EXPECT_LT(found[0].possible, 1e-3);
    requirement.error_mm = found[0].possible;
    EXPECT_FALSE(Chooser(requirement).smallest(1).empty());
    requirement.error_mm = found[0].possible / 1.1;
    EXPECT_TRUE(Chooser(requirement).smallest(1).empty());
    EXPECT_EQ(found[1].name, "unit");
}

}  // namespace curvecore::tb::choose_test
