// SPDX-License-Identifier: Apache-2.0
// Curves drawn from rounded numbers of a program or a table, against those numbers
// (ref/gcode/README.md, "Rounded input"); arcs about a centre and by R: asked_arcs_test.cpp.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <sstream>

#include "ref/cam/cam_table.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/path/smooth_path.hpp"
#include "ref/plan/segment_curve.hpp"
#include "ref/program/gcode_reader.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::tb::rounded_input_test {

using ref::Move;
using ref::Program;
using ref::Vec3;

Program read(const std::string& text) { return ref::read_gcode_text(text, "part.ngc"); }

ref::Geometry drawn(const Program& program) {
    return make_geometry(program, ref::Machine(), ref::PlanOptions());
}

/// Least value of a function that falls and then rises.
template <class Function>
double least(const Function& of, double low, double high) {
    for (int i = 0; i < 100; ++i) {
        const double third = (high - low) / 3;
        if (of(low + third) < of(high - third)) {
            high -= third;
        } else {
            low += third;
        }
    }
    return of((low + high) / 2);
}

double to_move(const Vec3& point, const Move& move) {
    const auto far = [&](double u) {
        const Vec3 line = move.start + u * (move.end - move.start);
        return ((move.kind == Move::Kind::kCubic ? move.cubic.position(u) : line) - point).norm();
    };
    return least(far, 0, 1);
}

/// Points of three decimals that are nearly in a row: the segments pass the middle one.
TEST(RoundedInput, ArcsThroughThreePointsPassThem) {
    std::mt19937 random(1);
    const auto number = [&](double most) {
        return std::round(std::uniform_real_distribution<double>(-most, most)(random) * 1e3) / 1e3;
    };
    int bent = 0;
    for (int i = 0; i < 500; ++i) {
        const double size = std::pow(10, i % 4) / 10;
        const double aside = i % 3 == 0 ? 0.002 : size;
        const Vec3 start(number(10), number(10), number(10));
        const Vec3 chord(size, number(size), number(size));
        Vec3 part = 0.5 * chord + Vec3(number(aside), number(aside), number(aside));
        part = (part * 1e3).array().round() / 1e3;
        const auto words = [](const Vec3& p) {
            return fmt::format("X{:.3f} Y{:.3f} Z{:.3f}\n", p.x(), p.y(), p.z());
        };
        const std::string text = "G21 G90 F600\nG0 " + words(start) + "G2.4 " +
                                 words(start + part) + words(start + chord);
        Program program;
        try {
            program.moves = {read(text).moves.back()};
        } catch (const ref::InputError&) {
            continue;  // the same point twice, or in a row
        }
        const double unit = ref::PlanOptions().unit_mm;
        const Vec3 middle = (start + part) / unit;
        double nearest = HUGE_VAL;
        for (const ref::Segment& segment : drawn(program).segments) {
            const auto far = [&](double s) { return (exact_position(segment, s) - middle).norm(); };
            nearest = std::min(nearest, least(far, 0, static_cast<double>(segment.length) / 65536));
        }
        EXPECT_LT(nearest, 0.05) << "units\n" << text;
        bent += 1;
    }
    EXPECT_GT(bent, 400);
}

/// Chords of one direction within 1e-9 rad become one line, at most 1e-9 mm from any vertex.
TEST(RoundedInput, LinesInOneDirectionKeepTheirVertices) {
    for (const double turn : {3e-10, 9e-10, 3e-9}) {
        Program program;
        Vec3 at = Vec3::Zero();
        std::vector<Vec3> vertices{at};
        for (int i = 0; i < 500; ++i) {
            Move move;
            move.line = i + 1;
            move.feed = 10;
            move.tolerance = 1e-5;
            move.start = at;
            at += 0.1 * Vec3(std::cos(turn * i), std::sin(turn * i), 0);
            move.end = at;
            vertices.push_back(at);
            program.moves.push_back(move);
        }
        ref::smooth_path(program, ref::Machine());
        EXPECT_LT(program.moves.size(), 500U);
        std::size_t on = 0;
        for (const Vec3& vertex : vertices) {
            while (on + 1 < program.moves.size() && program.moves[on].end.x() < vertex.x()) ++on;
            const Move& move = program.moves[on];
            EXPECT_LT(to_move(vertex, move), move.deviation + 1e-9);
        }
    }
}

/// Doubled control points, and pieces of them without length.
TEST(RoundedInput, PiecesWithoutLengthLeaveNoGap) {
    const Program program = read(
        "G21 G90 F600\nG5.2 X1 Y1 L3\nX1 Y1\nX1 Y1\nX1.0000000004 Y1\nX1.0000000004 Y1\nX4 Y2\n"
        "X5 Y0\nG5.3\n");
    ASSERT_FALSE(program.warnings.empty());
    const Move* before = nullptr;
    for (const Move& move : program.moves) {
        EXPECT_LT((move.cubic.position(0) - move.start).norm(), 1e-9);
        EXPECT_LT((move.cubic.position(1) - move.end).norm(), 1e-9);
        EXPECT_TRUE(before == nullptr || before->end == move.start);
        before = &move;
    }
    EXPECT_EQ(program.moves.back().end, Vec3(5, 0, 0));
}

/// Moves shorter than half a quantum of path have no segment: the next one jumps by no more.
TEST(RoundedInput, MovesShorterThanAQuantumAreNoJump) {
    const ref::PlanOptions options;
    const double quantum = options.unit_mm / 65536;
    Program program;
    Vec3 at = Vec3::Zero();
    for (int i = 0; i < 400; ++i) {
        Move move;
        move.line = i + 1;
        move.feed = 10;
        move.start = at;
        at.x() += i % 20 == 0 ? 0.1 : 0.49 * quantum;
        move.end = at;
        program.moves.push_back(move);
    }
    const ref::Geometry geometry = drawn(program);
    EXPECT_LT(geometry.segments.size(), 400U);
    Vec3 reached = Vec3::Zero();
    for (const ref::Segment& segment : geometry.segments) {
        EXPECT_LE((segment.start - reached).norm(), 20 * 0.5 / 65536) << "units";
        reached = segment.end;
    }
    EXPECT_LE((at / options.unit_mm - reached).norm(), 20 * 0.5 / 65536);
}

/// Angles and places are evenly spaced up to the last printed digit.
TEST(RoundedInput, CamTablesAreEvenToTheirLastDigit) {
    const auto taken = [](const std::string& header, const std::string& third) {
        std::istringstream in(header + "\n0,9,9,9,9,9,9,9\n5,9,9,9,9,9,9,9\n" + third +
                              ",9,9,9,9,9,9,9\n");
        try {
            ref::CamTable table(in, "cam.csv");
            while (table.next()) continue;
            return true;
        } catch (const ref::InputError&) {
            return false;
        }
    };
    const std::string seven = "x,0,51.429,102.857,154.286,205.714,257.143,308.571";
    EXPECT_TRUE(taken(seven, "10"));
    EXPECT_TRUE(taken("x,0,5.1429e1,102.857,154.286,205.714,257.143,308.571", "1e1"));
    EXPECT_FALSE(taken("x,0,51.4295,102.857,154.286,205.714,257.143,308.571", "10"))
        << "0.0009 degrees off, which is no rounding of four decimals";
    EXPECT_FALSE(taken("x,0,51.4,102.857,154.286,205.714,257.143,308.571", "10"));
    EXPECT_FALSE(taken(seven, "10.0004"));
    EXPECT_TRUE(taken(seven, "10.000"));
}

}  // namespace curvecore::tb::rounded_input_test
