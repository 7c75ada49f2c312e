// SPDX-License-Identifier: Apache-2.0
// Arcs with rounded numbers, as programs write them, against the curve that their numbers define.
// CURVECORE_MUTATIONS=100000 is the long form (scripts/campaign.sh).
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "ref/feed/pieces/limit_report.hpp"
#include "ref/feed/planner.hpp"
#include "ref/gcode/interpreter/canonical_moves.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/limits/limits.hpp"
#include "ref/moves/arc_geometry.hpp"
#include "ref/moves/asked_arc.hpp"
#include "ref/moves/move_part.hpp"
#include "ref/path/smooth_path.hpp"
#include "ref/plan/segment_curve.hpp"
#include "ref/program/gcode_reader.hpp"
#include "ref/program/gcode_writer.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/judge/frechet.hpp"
#include "tb/support/programs/mutator.hpp"
#include "tb/support/programs/program_builder.hpp"
#include "tb/support/programs/random_arcs.hpp"

namespace curvecore::tb::asked_arcs_test {

using ref::Move;
using ref::Program;
using ref::Vec3;

constexpr double kSame = 2e-8;  // mm: 0.02 nm, roundings of mm and of path quanta

Program read(const std::string& text) { return ref::read_gcode_text(text, "part.ngc"); }

/// The same arc as LinuxCNC's interpreter passes it on.
Move canonical(const WrittenArc& arc) {
    ref::CanonicalMoves moves("part.ngc", 1e-3);
    const auto point = [](const Vec3& at) { return ref::Point{at.x(), at.y(), at.z()}; };
    const bool clockwise = arc.sweep < 0;
    const double turns = static_cast<double>(std::abs(arc.sweep)) / (2 * M_PI);
    moves.start(point(arc.place(arc.start, arc.low)));
    moves.arc({2, point(arc.place(arc.end, arc.high)), 10, false}, arc.place(arc.centre, 7),
              Vec3::Unit(arc.normal_axis) * (clockwise ? -1 : 1),
              static_cast<int>(std::ceil(turns - 1e-12)));
    return moves.finish().moves.back();
}

/// Greatest distance of the segments' exact curve from the defined one.
double off(const Move& move, const WrittenArc& arc, double* off_circle) {
    Program program;
    program.moves = {move};
    const ref::PlanOptions options;
    const ref::Geometry geometry = make_geometry(program, ref::Machine(), options);
    const ref::Segment& last = geometry.segments.back();
    const auto total = static_cast<double>(last.s_start + last.length);
    double worst = 0;
    for (const ref::Segment& segment : geometry.segments) {
        for (int i = 0; i <= 4; ++i) {
            const double quanta = static_cast<double>(segment.length) * i / 4;
            const Vec3 drawn = exact_position(segment, quanta / 65536) * options.unit_mm;
            const double u = (static_cast<double>(segment.s_start) + quanta) / total;
            worst = std::max(worst, (drawn - arc.at(u)).norm());
            *off_circle = std::max(*off_circle, arc.off_circle(drawn));
        }
    }
    return worst;
}

TEST(AskedArcs, AreDrawnAboutTheirCentreAndEndWhereTheProgramEnds) {
    ArcWriter writer(33);
    int mended = 0;
    for (int i = mutations(2000); i > 0; --i) {
        const WrittenArc arc = writer.next();
        SCOPED_TRACE(arc.modes + arc.block);
        const Program program = read(arc.modes + arc.block);
        const double same = kSame + arc.loose();
        for (const Move& move : {program.moves.back(), canonical(arc)}) {
            double off_circle = 0;
            EXPECT_LT(off(move, arc, &off_circle), same);
            EXPECT_LT(off_circle, static_cast<double>(arc.mismatch()) + same);
            EXPECT_LT((move.end - arc.place(arc.end, arc.high)).norm(), 1e-12);
            EXPECT_EQ(move.deviation, 0);
        }
        mended += arc.mismatch() > 1e-9L ? 1 : 0;
        if (HasFailure()) return;
    }
    EXPECT_GT(mended, mutations(2000) / 2);
}

/// Deviations that are allowed in inches, and not in mm, are among these.
TEST(AskedArcs, AreWrittenAsTheyAreRead) {
    ArcWriter writer(34);
    int divided = 0;
    for (int i = 0; i < 300; ++i) {
        const WrittenArc arc = writer.next();
        SCOPED_TRACE(arc.modes + arc.block);
        const Program program = read(arc.modes + arc.block);
        const Program again =
            read(ref::kWrittenModes + ref::gcode_of("part.ngc", program.moves) + "M2\n");
        const Move& move = program.moves.back();
        const std::size_t first = program.moves.size() - 1;
        const bool whole = again.moves.size() == program.moves.size();
        divided += whole ? 0 : 1;
        const auto parts = static_cast<double>(again.moves.size() - first);
        double angle = 0;
        for (std::size_t k = first; k < again.moves.size(); ++k) {
            const Move& part = again.moves[k];
            angle += part.angle;
            for (const double place : {0.0, 0.3, 0.7, 1.0}) {
                const Vec3 read_back = place_on(part, place * part.length()).position;
                const Vec3 asked = arc.at((static_cast<double>(k - first) + place) / parts);
                ASSERT_LT((read_back - asked).norm(), whole ? 1e-8 : 2e-6);
            }
        }
        EXPECT_NEAR(angle, move.angle, whole ? 1e-8 : 1e-2);
    }
    EXPECT_GT(divided, 0);
}

/// Control: the former curve, the arc about the nearest point equally far from both ends, is
/// reported.
TEST(AskedArcs, ReportSeesAMovedCentre) {
    const Move asked = read("G21 G90 G61\nG0 X10\nG3 X10.001 Y-0.02 I-10 F600\n").moves.back();
    Move moved = asked;
    const Vec3 along = (asked.end - asked.start).normalized();
    moved.centre -= along * along.dot(asked.centre - (asked.start + asked.end) / 2);
    moved.advance = Vec3::Zero();
    const Vec3 a = asked.start - moved.centre;
    const Vec3 b = asked.end - moved.centre;
    moved.angle = 2 * M_PI - std::atan2(b.cross(a).z(), a.dot(b));
    ASSERT_LT((place_on(moved, moved.length()).position - moved.end).norm(), 1e-9);
    const ref::AskedArc numbers{asked.start, asked.end, asked.centre, asked.normal, 1};
    EXPECT_NEAR(distance(numbers, moved), 1.02, 0.01);
    EXPECT_EQ(distance(numbers, asked), 0);
    Move turned = asked;
    turned.angle += 2 * M_PI;
    EXPECT_GT(distance(numbers, turned), 10);
}

TEST(AskedArcs, AreNowhereFasterThanTheirPath) {
    ArcWriter writer(37);
    for (int i = 0; i < 200; ++i) {
        const WrittenArc arc = writer.next();
        const Move move = read(arc.modes + arc.block).moves.back();
        const double length = move.length();
        double fastest = 0;
        for (int k = 0; k <= 1000; ++k) {
            fastest = std::max(fastest, place_on(move, length * k / 1000).tangent.norm());
        }
        EXPECT_LT(fastest, 1 + 1e-13) << arc.modes << arc.block;
        EXPECT_GT(fastest, 1 - 1e-4 * static_cast<double>(arc.mismatch() / arc.radius()) - 1e-13);
        const ref::PathShape shape = path_shape(move);
        const double along = length * shape.drift;
        EXPECT_NEAR(along, static_cast<double>(arc.mismatch()), 1e-8);
    }
}

/// Chords of 1 to 100 mm on circles of up to 100 km: nearly straight.
TEST(AskedArcs, MayHaveAFarCentre) {
    std::mt19937 random(38);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int i = 0; i < 300; ++i) {
        const double radius = std::round(std::exp(uniform(std::log(1e3), std::log(9.9e7))));
        const double chord = std::round(uniform(1, 100) * 1e3) / 1e3;
        const double height = std::sqrt((radius - chord / 2) * (radius + chord / 2));
        WrittenArc arc;
        arc.start = {3, -4};
        arc.end = {3 + Real(chord), -4};
        arc.centre = {3 + Real(chord) / 2, -4 + Real(std::round(height * 1e3) / 1e3)};
        arc.sweep = std::arg((arc.end - arc.centre) / (arc.start - arc.centre));
        const Program program =
            read(fmt::format("G21 G90 F600\nG0 X3 Y-4\nG3 X{:.3f} Y-4 I{:.4f} J{:.3f}\n", 3 + chord,
                             chord / 2, std::round(height * 1e3) / 1e3));
        for (const Move& move : {program.moves.back(), canonical(arc)}) {
            double off_circle = 0;
            EXPECT_LT(off(move, arc, &off_circle), 5e-8) << radius << " " << chord;
            EXPECT_EQ(move.deviation, 0);
        }
    }
}

TEST(AskedArcs, EndsInOneDirectionAreATurnAndNearOnesAreNot) {
    const auto angle = [](const std::string& block) {
        return read("G21 G90\nG0 X10\n" + block + " F600\n").moves.back().angle;
    };
    EXPECT_DOUBLE_EQ(angle("G3 X10.001 Y0 I-10"), 2 * M_PI);
    EXPECT_DOUBLE_EQ(angle("G2 X9.999 Y0 I-10 P2"), 4 * M_PI);
    EXPECT_NEAR(angle("G3 X10 Y0.00001 I-10"), 1e-6, 1e-12);
    EXPECT_NEAR(angle("G3 X10 Y-0.00001 I-10"), 2 * M_PI - 1e-6, 1e-12);
}

TEST(AskedArcs, ToleranceIsThatOfTheFilesUnit) {
    const auto taken = [](const std::string& text) {
        try {
            return read(text).moves.size() == 2;
        } catch (const ref::InputError&) {
            return false;
        }
    };
    EXPECT_TRUE(taken("G21\nG0 X1\nG3 X2.0282 Y1 J1 F600\n"));
    EXPECT_FALSE(taken("G21\nG0 X1\nG3 X2.0284 Y1 J1 F600\n"));
    EXPECT_TRUE(taken("G20\nG0 X1\nG3 X1.1028 Y0.1 J0.1 F20\n"));
    EXPECT_FALSE(taken("G20\nG0 X1\nG3 X1.1029 Y0.1 J0.1 F20\n"));
    EXPECT_TRUE(taken("G20\nG0 X1\nG3 X281.28 Y280 J280 F20\n")) << "0.1 %, below 0.28 inch";
    EXPECT_FALSE(taken("G20\nG0 X1\nG3 X291.29 Y290 J290 F20\n"));
    EXPECT_TRUE(taken("G21\nG0 X1\nG2 X3.0049 R1 F600\n")) << "a half circle";
    EXPECT_FALSE(taken("G21\nG0 X1\nG2 X3.0051 R1 F600\n"));
}

/// Several arcs in a row, in G64: within P of the defined curve, walked from end to end.
TEST(AskedArcs, AreSmoothedWithinTheirTolerance) {
    ArcWriter writer(35);
    for (int part = 0; part < 12; ++part) {
        std::string text = "G64 P0.01\n";
        std::vector<WrittenArc> arcs;
        for (int i = 0; i < 4; ++i) {
            WrittenArc arc = writer.next();
            while (std::abs(arc.sweep) * arc.radius() > 60) arc = writer.next();
            arcs.push_back(arc);
            const std::size_t rapid = arcs.back().modes.find("G0");
            arcs.back().modes.replace(rapid, 2, "G1");
            text += arcs.back().modes + arcs.back().block;
        }
        SCOPED_TRACE(text);
        Program program = read(text);
        Polyline asked{Vec3::Zero()};
        for (const WrittenArc& arc : arcs) {
            const double bend = static_cast<double>(arc.radius());
            const double error = 5e-4;
            const int count = 2 + static_cast<int>(static_cast<double>(std::abs(arc.sweep)) *
                                                   std::sqrt(bend / error / 8));
            for (int i = 0; i <= count; ++i) asked.push_back(arc.at(Real(i) / count));
        }
        ref::smooth_path(program, ref::Machine());
        EXPECT_TRUE(frechet_within(polyline(program.moves, 5e-4), asked, 0.012));
    }
}

/// Room that the rules leave along the path, at every place and in both directions: r' is not at
/// right angles to r'' where an arc's radii differ.
TEST(AskedArcs, LeaveRoomAlongThePathForTheirDrift) {
    std::mt19937 random(39);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    ref::Machine machine;  // no axis limits the motion
    for (ref::AxisLimits& axis : machine.axis) {
        axis.velocity *= 10;
        axis.acceleration *= 10;
        axis.jerk *= 10;
    }
    for (int i = 0; i < 200; ++i) {
        Move move;
        move.kind = Move::Kind::kArc;
        move.start = Vec3(10, 0, 0);
        move.angle = uniform(0.3, 6.28);
        move.advance = 10 * move.angle * uniform(0, 0.4) * Vec3(uniform(-1, 1), uniform(-1, 1), 0);
        const ref::PathShape shape = path_shape(move);
        const double v = uniform(0.3, 1) * top_speed(shape, machine);
        const ref::PathLimits limits = along_path(shape, machine, v);
        for (int k = 0; k <= 200; ++k) {
            const ref::MovePlace at = place_on(move, move.length() * k / 200);
            const Vec3 third =
                -shape.twist * shape.twist * (at.tangent - move.advance / move.length());
            for (const double sign : {-1.0, 1.0}) {
                const double a = sign * limits.acceleration;
                const Vec3 across = v * v * at.curvature;
                EXPECT_LE((a * at.tangent + across).norm(), machine.acceleration * (1 + 1e-9));
                const Vec3 jerk = sign * limits.jerk * at.tangent + v * v * v * third;
                EXPECT_LE((jerk + 3 * v * a * at.curvature).norm(), machine.jerk * (1 + 1e-9));
                EXPECT_LE((jerk - 3 * v * a * at.curvature).norm(), machine.jerk * (1 + 1e-9));
            }
        }
    }
}

/// Arcs whose radii at the ends differ by as much as allowed, down to some um.
TEST(AskedArcs, KeepTheMachinesLimits) {
    std::mt19937 random(36);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int part = 0; part < 6; ++part) {
        std::string text = "G21 G90 G61\nG0 X0 Y0\nF9000\n";
        Eigen::Vector2d at(0, 0);
        for (int i = 0; i < 30; ++i) {
            const double radius = std::exp(uniform(std::log(0.02), std::log(20)));
            const double towards = uniform(0, 6.28);
            const double to = towards + uniform(0.01, 6.28);
            const double end = radius + uniform(-0.0049, 0.0049);
            const Eigen::Vector2d out(std::cos(towards), std::sin(towards));
            const Eigen::Vector2d centre = at - radius * out;
            at = centre + end * Eigen::Vector2d(std::cos(to), std::sin(to));
            text += fmt::format("G3 X{:.9f} Y{:.9f} I{:.9f} J{:.9f}\n", at.x(), at.y(),
                                -radius * out.x(), -radius * out.y());
        }
        for (const ref::Effort effort : {ref::Effort::kRules, ref::Effort::kOptimum}) {
            ref::PlanOptions options;
            options.effort = effort;
            ref::Machine machine = part % 3 == 0 ? ref::Machine() : unequal_machine(40U + part);
            if (part % 3 == 2) machine.axis[0].velocity = 20;
            const Program program = read(text);
            const ref::Plan plan = make_plan(program, machine, options);
            const ref::LimitReport report = limit_report(program, machine, plan);
            for (const ref::LimitRatios& worst : {report.inside, report.joints}) {
                EXPECT_LE(worst.velocity, 1 + 1e-9) << part;
                EXPECT_LE(worst.acceleration, 1 + 1e-9) << part;
                EXPECT_LE(worst.jerk, 1 + 1e-9) << part;
            }
        }
    }
}

}  // namespace curvecore::tb::asked_arcs_test
