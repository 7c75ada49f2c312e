// SPDX-License-Identifier: Apache-2.0
// Written G-code reads back as the same moves; idle moves as chords keep their tolerance.
#include "ref/program/gcode_writer.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "ref/curve/arc_length.hpp"
#include "ref/join/idle_gcode.hpp"
#include "ref/join/joint.hpp"
#include "ref/program/gcode_reader.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref::gcode_writer_test {

constexpr double kRounded = 3e-9;  // mm: nine decimals, at a few words

void expect_same(const Program& a, const Program& b) {
    ASSERT_EQ(a.moves.size(), b.moves.size());
    for (std::size_t i = 0; i < a.moves.size(); ++i) {
        const Move& x = a.moves[i];
        const Move& y = b.moves[i];
        EXPECT_EQ(x.kind, y.kind) << i;
        EXPECT_EQ(x.rapid, y.rapid);
        EXPECT_EQ(x.exact_stop, y.exact_stop) << i;
        EXPECT_EQ(x.tolerance, y.tolerance) << i;
        EXPECT_NEAR(x.feed, y.feed, 1e-9);
        EXPECT_NEAR(x.dwell, y.dwell, 1e-9);
        const double length = x.length();
        EXPECT_NEAR(length, y.length(), 1e-6);
        for (int k = 0; k < kAuxAxes; ++k) EXPECT_NEAR(x.aux_end[k], y.aux_end[k], kRounded);
        if ((x.end - x.start).isZero(0) && x.kind == Move::Kind::kLine) continue;
        for (const double part : {0.0, 0.2, 0.5, 0.7, 1.0}) {
            const MovePlace p = place_on(x, part * length);
            const MovePlace q = place_on(y, part * y.length());
            EXPECT_LE((p.position - q.position).norm(), 2e-7) << "line " << x.line;
            if (!p.tangent.allFinite()) continue;  // a cusp
            EXPECT_LE((p.tangent - q.tangent).norm(), 1e-6) << "line " << x.line;
        }
    }
}

TEST(GcodeWriter, EveryExampleIsReadBackAsTheSameMoves) {
    for (const char* name : {"arcs", "aux_axes", "demo", "helix", "lines", "splines", "tilted",
                             "stops", "small_radii"}) {
        SCOPED_TRACE(name);
        const Program program = read_gcode(std::string(DATA_DIR) + "/" + name + ".ngc");
        const std::string text = kWrittenModes + gcode_of("part.ngc", program.moves) + "M2\n";
        const Program again = read_gcode_text(text, "part.ngc");
        if (std::string(name) != "demo") {
            expect_same(program, again);
            continue;
        }
        // Two tilted arcs of more than half a turn become two each.
        EXPECT_EQ(again.moves.size(), program.moves.size() + 2);
        const auto length = [](const Program& part) {
            double sum = 0;
            for (const Move& move : part.moves) sum += move.length();
            return sum;
        };
        EXPECT_NEAR(length(program), length(again), 1e-5);
    }
}

TEST(GcodeWriter, WordsHaveNoExponentAndNoTail) {
    EXPECT_EQ(word('X', 1e-12), " X0");
    EXPECT_EQ(word('X', -1e-12), " X0");
    EXPECT_EQ(word('Y', -2.50), " Y-2.5");
    EXPECT_EQ(word('Z', 1e6), " Z1000000");
    EXPECT_EQ(word('F', 1.0 / 3), " F0.333333333");
}

TEST(GcodeWriter, SplineInSpaceIsReadBackAndSaid) {
    const Bezier points{Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(4, 5, -1), Vec3(7, 0, 2)};
    const Program program = read_gcode_text(g5_block(points, true) + " F600\n", "part.ngc");
    const Bezier found = to_bezier(program.moves[0].cubic);
    for (int i = 0; i < 4; ++i) EXPECT_LE((found[i] - points[i]).norm(), 1e-8) << i;
    ASSERT_EQ(program.warnings.size(), 1U);
    EXPECT_EQ(program.warnings[0],
              "part.ngc:1: warning: G5 in space (Z, K, R) is this reader's own: elsewhere it lies "
              "in the XY plane");
    const Program flat = read_gcode_text("G5 X7 Y0 I1 J2 P-3 Q5 F600\n", "part.ngc");
    EXPECT_TRUE(flat.warnings.empty());
}

TEST(GcodeWriter, SplineWithAuxiliaryAxesIsRefused) {
    Move move;
    move.kind = Move::Kind::kCubic;
    move.line = 7;
    move.cubic.c = move.end = Vec3(1, 0, 0);
    move.aux_end[0] = 5;
    EXPECT_THROW(gcode_of("part.csv", {move}), InputError);
}

IdleMove swing(JoinFit fit, bool in_space) {
    const Joint start{{Vec3(1, 2, 3), Vec3(1, 0, 0), Vec3(0, 0.02, 0)}, 30};
    const Joint end{{Vec3(15, -9, in_space ? 8 : 3), Vec3(0, -1, 0), Vec3(0.01, 0, 0)}, 60};
    return default_idle_move(start, end, fit, 3);
}

/// Reads the blocks after a move to the start.
Program read_idle(const std::string& blocks) {
    return read_gcode_text("G1 X1 Y2 Z3 F60\n" + blocks, "idle.ngc");
}

TEST(IdleGcode, ExactBlocksAreTheCurve) {
    for (const bool in_space : {false, true}) {
        for (const JoinFit fit : {JoinFit::kCubic, JoinFit::kC2, JoinFit::kQuintic}) {
            const PathTable path(swing(fit, in_space).pieces());
            EXPECT_EQ(is_plane(path.pieces()), !in_space);
            const SpeedCourse course{SpeedLaw::kSmooth, 30, 60, path.length()};
            const Program program = read_idle(idle_gcode(path, course, {}));
            EXPECT_EQ(program.warnings.empty(), !in_space);
            double s = 0;
            for (std::size_t i = 1; i < program.moves.size(); ++i) {
                const Move& move = program.moves[i];
                EXPECT_EQ(move.kind, Move::Kind::kCubic);
                for (const double u : {0.25, 0.5, 1.0}) {
                    const Joint here = path.at(s + arc_length(move.cubic, 0, u));
                    const Vec3 off = move.cubic.position(u) - here.position;
                    EXPECT_LE(off.norm(), 1e-6);
                    EXPECT_LE((off - here.tangent * here.tangent.dot(off)).norm(), 4e-8);
                }
                s += move.length();
            }
            EXPECT_NEAR(s, path.length(), 1e-6);
            EXPECT_GT(program.moves.back().feed, program.moves[1].feed);
        }
    }
}

TEST(IdleGcode, ChordsKeepTheirTolerance) {
    for (const double tolerance : {0.1, 0.01, 0.001}) {
        for (const JoinFit fit : {JoinFit::kC2, JoinFit::kQuintic}) {
            const PathTable path(swing(fit, true).pieces());
            const SpeedCourse course{SpeedLaw::kEven, 30, 60, path.length()};
            const Program program =
                read_idle(idle_gcode(path, course, {GcodeForm::kTolerance, tolerance}));
            // Distance of the curve from the chain of chords
            double worst = 0;
            for (int i = 0; i < 400; ++i) {
                const PathTable::Place place{static_cast<std::size_t>(i) / 100, i % 100 / 100.0};
                const Vec3 point = path.at(place).position;
                double nearest = 1e9;
                for (std::size_t k = 1; k < program.moves.size(); ++k) {
                    const Vec3 a = program.moves[k].start;
                    const Vec3 way = program.moves[k].end - a;
                    const double part =
                        std::clamp((point - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
                    nearest = std::min(nearest, (a + part * way - point).norm());
                }
                worst = std::max(worst, nearest);
            }
            EXPECT_LE(worst, tolerance + kRounded);
            EXPECT_GE(worst, tolerance / 20) << "far too many chords";
            EXPECT_NEAR(program.moves.back().end.z(), 8, kRounded);
        }
    }
}

TEST(IdleGcode, StepsAreEvenAndNotLonger) {
    const PathTable path(swing(JoinFit::kQuintic, true).pieces());
    const SpeedCourse course{SpeedLaw::kSmooth, 30, 60, path.length()};
    const Program program = read_idle(idle_gcode(path, course, {GcodeForm::kStep, 0.25}));
    const std::size_t count = program.moves.size() - 1;
    EXPECT_EQ(count, static_cast<std::size_t>(std::ceil(path.length() / 0.25)));
    for (std::size_t i = 1; i <= count; ++i) {
        EXPECT_LE(program.moves[i].length(), path.length() / static_cast<double>(count) + 1e-8);
        EXPECT_GE(program.moves[i].length(), 0.23);
        const Vec3 there =
            path.at(path.length() * static_cast<double>(i) / static_cast<double>(count)).position;
        EXPECT_LE((program.moves[i].end - there).norm(), 1e-8);
    }
    EXPECT_THROW(idle_gcode(path, course, {GcodeForm::kStep, 1e-6}), std::invalid_argument);
}

}  // namespace curvecore::ref::gcode_writer_test
