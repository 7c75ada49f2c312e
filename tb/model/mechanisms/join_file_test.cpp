// SPDX-License-Identifier: Apache-2.0
// The file join.json: it reads back as written, flaws are refused with their line, and no mutation
// gets through as a move that cannot be drawn.
#include "sysc/join/join_file.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <random>

#include "ref/join/least.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::sysc::join_file_test {

using ref::Vec3;

JoinFile sample(ref::JoinFit fit = ref::JoinFit::kQuintic) {
    JoinFile file;
    file.a = "a.ngc";
    file.b = "b.ngc";
    file.move =
        ref::default_idle_move({{Vec3(0, 0, 5), Vec3(1, 0, 0), Vec3(0, 0.1, 0)}, 25},
                               {{Vec3(3, 7, 2), Vec3(0, 0.6, 0.8), Vec3::Zero()}, 40}, fit, 3);
    file.law = ref::SpeedLaw::kEven;
    file.gcode = {ref::GcodeForm::kStep, 0.25};
    return file;
}

TEST(JoinFile, IsReadBackAsItWas) {
    for (const ref::JoinFit fit : {ref::JoinFit::kCubic, ref::JoinFit::kQuintic}) {
        const JoinFile file = sample(fit);
        const JoinFile again = read_join_text(file.text(), "join.json");
        EXPECT_EQ(again.a, file.a);
        EXPECT_EQ(again.move.fit, fit);
        EXPECT_EQ(again.move.t, file.move.t);
        EXPECT_EQ(again.move.points, file.move.points);
        EXPECT_EQ(again.move.end.tangent, file.move.end.tangent);
        EXPECT_EQ(again.law, file.law);
        EXPECT_EQ(again.gcode.size, 0.25);
        EXPECT_EQ(again.text(), file.text());
    }
}

std::string refusal(const std::string& text) {
    try {
        read_join_text(text, "join.json");
    } catch (const ref::InputError& error) {
        return error.what();
    }
    return "";
}

/// The file with the first `what` replaced.
std::string with(const std::string& what, const std::string& other) {
    std::string text = sample().text();
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), other);
}

TEST(JoinFile, WhatIsWrongIsSaidWithItsLine) {
    EXPECT_EQ(refusal(sample().text()), "");
    EXPECT_EQ(refusal(with("\"curvecore_join\": 1", "\"curvecore_join\": 2")),
              "join.json:2: error: is of version 2, this program reads version 1");
    EXPECT_EQ(refusal("{}"),
              "join.json:1: error: is no file of curvecore join: 'curvecore_join' is missing");
    EXPECT_EQ(refusal("[1]"),
              "join.json:1: error: is no file of curvecore join: 'curvecore_join' is missing");
    EXPECT_EQ(refusal(with("\"a.ngc\"", "7")), "join.json:3: error: 'a': a file's name is wanted");
    EXPECT_EQ(refusal(with("25.0", "-25.0")),
              "join.json:21: error: 'feed': -25 is not in [1e-06, 1e+08]");
    EXPECT_EQ(refusal(with("25.0", "1e999")),
              "join.json: error: is no JSON: a number is out of range");
    EXPECT_EQ(refusal(with("25.0", "fast")),
              "join.json:21: error: column 15: is no JSON here; curvecore join writes such files");
    EXPECT_EQ(refusal(with("\"quintic\"", "\"septic\"")),
              "join.json:41: error: 'fit' must be one of cubic, moments, c2, quintic");
    EXPECT_EQ(
        refusal(with("\"points\"", "\"dots\"")),
        "join.json:54: error: 'dots': a move has curvecore_join, a, b, start, end, fit, speed, "
        "gcode, t, points, result");
    EXPECT_EQ(refusal(with("\"points\"", "\"result\"")), "join.json:1: error: 'points' is missing");
    JoinFile same = sample();
    same.move.points[1] = same.move.points[0];
    EXPECT_EQ(refusal(same.text()),
              "join.json:54: error: control point 1 and control point 2 coincide");
    same = sample();
    same.move.points[2] = same.move.end.position;
    EXPECT_EQ(refusal(same.text()), "join.json:54: error: control point 3 and the end coincide");
    JoinFile late = sample();
    std::swap(late.move.t[1], late.move.t[2]);
    EXPECT_EQ(refusal(late.text()).substr(0, 48),
              "join.json:47: error: t: must ascend by 1e-06 mm ");
    JoinFile still = sample();
    still.move.start.tangent = Vec3::Zero();
    EXPECT_EQ(refusal(still.text()),
              "join.json:5: error: 'start': the tangent has not the length 1");
    JoinFile lost = sample();
    lost.move.points.pop_back();
    EXPECT_EQ(refusal(lost.text()),
              "join.json:47: error: t: 5 values for 4 points: start, control points and end have "
              "one each");
}

/// Number of mutations, CURVECORE_MUTATIONS; the campaign makes 10^5.
int mutations() {
    const char* const count = std::getenv("CURVECORE_MUTATIONS");
    return count != nullptr ? std::atoi(count) : 4000;
}

TEST(JoinFile, MutatedFilesAreRefusedOrSound) {
    const std::vector<std::string> pieces{
        "1", "-", "0",  ".",   "e9",      "1e400", "null",  "[",    "]",    "{",  "}",
        ",", ":", "\"", "NaN", "[1,2,3]", "true",  "\\u00", "\xFF", "9999", "e-9"};
    const std::string files[] = {sample().text(), sample(ref::JoinFit::kC2).text(),
                                 sample(ref::JoinFit::kMoments).text()};
    std::mt19937_64 random(20240607);
    const auto below = [&random](std::size_t n) { return n == 0 ? 0 : random() % n; };
    int read = 0;
    const int count = mutations();
    for (int i = 0; i < count; ++i) {
        std::string text = files[below(3)];
        for (std::size_t n = 1 + below(3); n > 0; --n) {
            const std::size_t at = below(text.size());
            switch (below(4)) {
                case 0:
                    text.erase(at, 1 + below(below(8) == 0 ? 200 : 3));
                    break;
                case 1:
                    text[at] = static_cast<char>(below(3) == 0 ? below(256) : '0' + below(10));
                    break;
                case 2:
                    text.insert(at, text.substr(below(text.size()), 1 + below(40)));
                    break;
                default:
                    text.insert(at, pieces[below(pieces.size())]);
            }
        }
        try {
            const JoinFile file = read_join_text(text, "join.json");
            ++read;
            const ref::PathTable path(file.move.pieces());
            ASSERT_TRUE(std::isfinite(path.length()) && path.length() > 0) << text;
            for (const ref::BezierPiece& piece : path.pieces()) {
                for (const Vec3& point : piece.points) ASSERT_TRUE(point.allFinite()) << text;
            }
            for (const ref::JoinJumps& row : ref::compare_joins(file.move, file.law)) {
                ASSERT_TRUE(std::isfinite(row.length) && std::isfinite(row.start.across) &&
                            std::isfinite(row.end.along) && std::isfinite(row.end.slope))
                    << text;
            }
            try {
                ref::with_least(file.move, ref::Least::kJerk);
            } catch (const std::invalid_argument&) {
            }
            ASSERT_EQ(read_join_text(file.text(), "again").text(), file.text()) << text;
        } catch (const ref::InputError&) {
        }
    }
    EXPECT_GT(read, count / 20) << "the mutations are too coarse to reach the move";
    EXPECT_LT(read, count * 4 / 5) << "the mutations are too fine to be refused";
}

}  // namespace curvecore::sysc::join_file_test
