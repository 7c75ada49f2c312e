// SPDX-License-Identifier: Apache-2.0
// A tool's moves as series of the joints: on the exact joints everywhere, without gaps, with all
// turns; and what no joint reaches.
#include "ref/joints/joint_moves.hpp"

#include <gtest/gtest.h>

#include "ref/bound/table_bound.hpp"
#include "ref/limits/travel.hpp"
#include "ref/moves/move_part.hpp"
#include "ref/numeric/angles.hpp"
#include "ref/segment/series_error.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/segments/joint_machines.hpp"

namespace curvecore::tb::joint_moves_test {

using ref::Move;
using ref::Vec3;

std::vector<Move> pieces_of(const std::vector<Move>& moves, const ref::Machine& machine,
                            const ref::PlanOptions& options) {
    ref::Program program;
    program.moves = moves;
    ref::JointMoves joints(ref::source_of(program), "part.ngc", machine, options);
    std::vector<Move> pieces;
    for (Move piece; joints.next(piece);) pieces.push_back(piece);
    return pieces;
}

/// The joints of a place on a move, from the move alone.
Vec3 exact_joints(const ref::Machine& machine, const Move& move, double s) {
    const Vec3 at = place_on(move, s).position;
    ref::ToolPose<double> pose{{at[0], at[1], at[2]}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        pose.abc[i] = move.aux_start[i] + (move.aux_end[i] - move.aux_start[i]) * s / move.length();
    }
    const ref::Joints<double> joints =
        std::visit([&](const auto& of) { return of.joints(pose); }, machine.kinematics);
    return {joints[0], joints[1], joints[2]};
}

/// The difference of joints without whole turns.
Vec3 apart(const ref::Machine& machine, Vec3 off) {
    const std::array<bool, 3> turns = ref::turning(machine.kinematics);
    for (int i = 0; i < 3; ++i) {
        if (turns[static_cast<std::size_t>(i)]) {
            off[i] = std::remainder(off[i], ref::kTurnDegrees);
        }
    }
    return off;
}

class JointMoves : public testing::TestWithParam<std::string> {};

TEST_P(JointMoves, AreTheExactJointsOfEveryPlace) {
    const ref::Machine machine = joint_machine(GetParam());
    const double stretch = machine.joint_stretch();
    std::mt19937_64 random(3);
    for (const int order : {2, 4, 6}) {
        ref::PlanOptions options = series_options();
        options.format.order = order;
        options.error_limit = order == 2 ? 100 : 0.1;
        const double most = ref::kJointShare * options.error_limit * options.unit_mm;
        double worst = 0;
        for (int n = 0; n < 20; ++n) {
            const Move move = tool_move(GetParam(), random);
            double begin = 0;
            const std::vector<Move> pieces = pieces_of({move}, machine, options);
            for (const Move& piece : pieces) {
                ASSERT_EQ(piece.kind, Move::Kind::kJoints);
                EXPECT_EQ(piece.feed, move.feed * stretch);
                for (int i = 0; i <= 7; ++i) {
                    const double s = piece.joints.length * i / 7;
                    const double of_tool = begin + s / stretch;
                    const Vec3 off = apart(
                        machine, piece.joints.joints.at(s) - exact_joints(machine, move, of_tool));
                    worst = std::max(worst, off.cwiseAbs().maxCoeff());
                    EXPECT_LT((piece.joints.tool.at(s) - place_on(move, of_tool).position).norm(),
                              1e-7);
                }
                for (int k = order + 1; k <= ref::kJointOrders; ++k) {
                    EXPECT_EQ(piece.joints.joints.c.col(k).norm(), 0);
                }
                begin += piece.joints.length / stretch;
            }
            EXPECT_NEAR(begin, move.length(), 1e-9);
            for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
                EXPECT_EQ(pieces[i].end, pieces[i + 1].start);
                EXPECT_EQ(pieces[i].to, pieces[i + 1].from);
                EXPECT_EQ(pieces[i].aux_end, pieces[i + 1].aux_start);
            }
            EXPECT_EQ(pieces.back().to, move.to);
        }
        EXPECT_LT(worst, most * 1.05) << order;
        if (GetParam() != "corexy") EXPECT_GT(worst, most / 10) << order;
    }
}

INSTANTIATE_TEST_SUITE_P(Machines, JointMoves, testing::ValuesIn(joint_machine_names()),
                         [](const auto& of) { return of.param; });

TEST(JointMovesOfATurn, CountTurns) {
    const ref::Machine machine = joint_machine("polar");
    Move circle;
    circle.kind = Move::Kind::kArc;
    circle.start = circle.end = Vec3(40, 0, 0);
    circle.angle = 3 * ref::kTurnRadians;
    circle.to = circle.length();
    const std::vector<Move> pieces = pieces_of({circle, circle}, machine, series_options());
    EXPECT_NEAR(pieces.back().end[2] - pieces.front().start[2], 6 * ref::kTurnDegrees, 1e-6);
    Vec3 last = pieces.front().start;
    for (const Move& piece : pieces) {
        EXPECT_LT((piece.end - last).norm(), ref::kTurnDegrees / 2);
        last = piece.end;
    }
}

TEST(JointMovesOfAStop, StandWhereTheJointsAre) {
    Move line;
    line.start = Vec3(20, 0, 0);
    line.end = Vec3(30, 0, 0);
    Move stop;
    stop.start = stop.end = line.end;
    stop.exact_stop = true;
    const std::vector<Move> pieces =
        pieces_of({line, stop}, joint_machine("delta"), series_options());
    EXPECT_EQ(pieces.back().start, pieces[pieces.size() - 2].end);
    EXPECT_TRUE(pieces.back().exact_stop);
    EXPECT_EQ(pieces.back().length(), 0);
}

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string refusal(const ref::Machine& machine, const Move& move) {
    try {
        pieces_of({move}, machine, series_options());
    } catch (const ref::InputError& error) {
        return error.what();
    }
    return "";
}

std::string refusal(const std::string& name, const Vec3& from, const Vec3& to) {
    Move move;
    move.line = 7;
    move.start = from;
    move.end = to;
    return refusal(joint_machine(name), move);
}

TEST(JointMovesFromHome, BeginWithItsTurns) {
    ref::Machine machine = joint_machine("polar");
    machine.home = Vec3(60, 5, 690);
    Move line;
    line.start = *machine.of_tool().home;
    line.end = Vec3(40, -30, 5);
    const std::vector<Move> pieces = pieces_of({line}, machine, series_options());
    EXPECT_LT((pieces.front().start - *machine.home).norm(), 1e-9);
    EXPECT_GT(pieces.back().end[2], 600);
    machine.home = Vec3(-60, 5, 690);  // no radius of the kinematics
    line.start = *machine.of_tool().home;
    EXPECT_PRED2(says, refusal(machine, line), "HOME of the joints is -60 5 690");
}

TEST(JointMovesOfALetter, WithoutAJointAreRefused) {
    Move turn;
    turn.start = turn.end = Vec3(250, 0, 0);
    turn.aux_end[2] = 20;
    EXPECT_PRED2(says, refusal(joint_machine("scara"), turn), "C: scarakins has no joint for it");
}

TEST(JointMovesOfACubic, ThatStandsStillAreRefused) {
    Move cusp;
    cusp.kind = Move::Kind::kCubic;
    cusp.cubic.b = Vec3(10, 0, 0);
    cusp.cubic.a = Vec3(0, 5, 0);
    cusp.end = Vec3(10, 5, 0);
    EXPECT_PRED2(says, refusal(joint_machine("delta"), cusp), "stands still within this curve");
}

TEST(JointMovesOfATravel, ReachTheirLimit) {
    ref::Machine machine = joint_machine("delta");
    Move line;
    line.start = Vec3(0, 0, 10);
    line.end = Vec3(40, 5, -5);
    const std::vector<Move> pieces = pieces_of({line}, machine, series_options());
    machine.axis[0].max = pieces.front().start[0];  // it goes down from there
    EXPECT_EQ(beyond_travel(travel(pieces.front()), pieces.front(), machine), "");
    machine.axis[0].max -= 0.01;
    EXPECT_PRED2(says, beyond_travel(travel(pieces.front()), pieces.front(), machine),
                 "joint 0 = ");
}

TEST(JointMovesOfAPlace, ThatIsSingularOrOutOfReachAreRefused) {
    EXPECT_PRED2(says, refusal("polar", {40, -20, 0}, {-40, 20, 0}), "part.ngc:7: error: ");
    EXPECT_PRED2(says, refusal("polar", {40, -20, 0}, {-40, 20.5, 0}), "JOINT_RATIO");
    EXPECT_EQ(refusal("polar", {40, -20, 0}, {-40, -20, 0}), "");
    EXPECT_PRED2(says, refusal("scara", {300, 0, 0}, {480, 0, 0}), "part.ngc:7: error: ");
    EXPECT_PRED2(says, refusal("scara", {500, 0, 0}, {300, 0, 0}),
                 "the joints of scara.ini (scarakins) do not reach X500.0000 Y0.0000");
    EXPECT_PRED2(says, refusal("delta", {50, 0, 0}, {101, 0, 0}),
                 "X = 101 mm is beyond the machine's travel -100 .. 100 mm");
}

/// The bound that one step's table error is for the steepest line is that of any series.
TEST(SeriesError, IsThatOfEveryValue) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> value(-1, 1);
    ref::CoreParameters core = series_options().format;
    double closest = 0;
    for (const int bits : {28, 36}) {
        core.coef_bits = bits;
        for (int k = 8; k <= 26; k += 3) {
            const double bound = ref::series_error(core, k);
            EXPECT_GE(bound, ref::series_error(core, k - 1));
            for (int n = 0; n < 10; ++n) {
                ref::TableSegment segment;
                double share = 1.9;
                for (const auto& [place, row] : core.table->bus) {
                    for (double& axis : segment.values[row]) axis = value(random) * share / 20;
                }
                for (double& axis : segment.values["c1"]) axis = value(random) * 1.5;
                segment.k = segment.lambda = k;
                const ref::TableError error = table_error(*core.table, core, segment);
                ASSERT_TRUE(error.beyond.empty());
                EXPECT_LE(error.worst(), bound * (1 + 1e-9)) << k;
                closest = std::max(closest, error.worst() / bound);
            }
        }
    }
    EXPECT_GT(closest, 0.8);
    EXPECT_GT(ref::longest_series_step(core, 0.04), 20);
    EXPECT_EQ(ref::longest_series_step(core, 1e-9), -1);
}

}  // namespace curvecore::tb::joint_moves_test
