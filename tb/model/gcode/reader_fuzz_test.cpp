// SPDX-License-Identifier: Apache-2.0
// Random mutations of valid programs and machine files: refused, or read as finite numbers.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "ref/machine/machine.hpp"
#include "ref/path/smooth_path.hpp"
#include "ref/program/gcode_reader.hpp"
#include "ref/program/points_reader.hpp"
#include "ref/text/input_error.hpp"
#include "ref/text/text_file.hpp"
#include "tb/support/programs/mutator.hpp"

namespace curvecore::tb::reader_fuzz_test {

using ref::Move;

const std::vector<std::string> kWords{
    "X",    "Y-",     "Z1",     "I",      "J0",    "K5",    "R",      "R-1",  "P2",     "P0",
    "F",    "F0",     "G2",     "G3 ",    "G2.4 ", "G3.4",  "G17",    "G18 ", "G19",    "G20 ",
    "G91 ", "G90 ",   "G90.1",  "G93 ",   "G94 ",  "G92 ",  "G92.2",  "G53 ", "G10 L2", "G55 ",
    "G61 ", "M0",     "M2",     "\n",     "%\n",   "(",     ")",      ";",    ".",      "-",
    "9999", "1e9",    "000001", "A90 ",   "U-3 ",  "#1",    "[1]",    "\r",   "/",      "\t",
    "=",    "[TRAJ]", "nan",    "inf",    "\xFF",  "G4 P1", "G43 H1", "G80 ", "X0 Y0 ", "O1",
    "G5 ",  "G5.1 ",  "G5.2 ",  "G5.3\n", "Q3",    "L4 ",   "P.5 ",   "G28 ", "G30.1",  "G10 L20",
    "R45",  "G43.1",  "G7 ",    "G95 ",   "S99 ",  "M3 ",   "G81 ",   "G83 ", "G87 ",   "G99 ",
    "G76 ", "G33 ",   "M66 ",   "G38.2",  "G52 ",  "G43.2"};

/// Cycles, the language, dialects; separated by bars.
const std::string kLanguage =
    "G28 |G30 |G28.1 |G81 |G83 |G73 |G84 |G98 |G99 |G7 |G8 |G33 |G95 |G96 |G97 |G52 |G43.1 |L0 |"
    "G10 L20 |M70 |M71\n|M72\n|M73 |M98 P1 |M99\n|O2 |O<a> |sub\n|endsub\n|call [1]\n|if [1]\n|"
    "endif\n|while [#1 LT 3]\n|endwhile\n|#2=|#<_b>=|#1=[#1+1]\n|[SIN[|ATAN[1]/[|**| MOD | EQ |"
    "EXISTS[#<b>]|$H\n|M82\n|M83 |E1 |M117 |T1 M6 ";

const std::vector<std::string> kCells{
    "1",   "0",   "-",   ".", ",", "7",  "25",        "3.5",     "1e3", "1e-9", "1e9",
    "nan", "inf", "0x1", "#", " ", "\n", "\n0,0,0\n", "x,y,z\n", "dx",  "\xFF", "\r"};

std::vector<std::string> pieces() {
    std::vector<std::string> all = kWords;
    std::istringstream more(kLanguage);
    for (std::string piece; std::getline(more, piece, '|');) all.push_back(piece);
    return all;
}

bool is_program(const std::filesystem::path& file) {
    const std::string extension = file.extension();
    return extension != ".ini" && extension != ".csv" && extension != ".md";
}

bool is_machine(const std::filesystem::path& file) { return file.extension() == ".ini"; }

std::vector<std::string> samples(bool (*wanted)(const std::filesystem::path&)) {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(DATA_DIR)) {
        if (entry.is_regular_file() && wanted(entry.path())) {
            files.push_back(entry.path().string());
        }
    }
    std::sort(files.begin(), files.end());
    for (std::string& file : files) {
        file = ref::read_text_file(file);
    }
    return files;
}

/// Checks everything that the planner relies on; empty if it holds.
std::string flaw(const Move& move) {
    for (const double number :
         {move.length(), move.feed, move.angle, move.advance.norm(), move.dwell}) {
        if (!std::isfinite(number)) {
            return "a number is not finite";
        }
    }
    const bool rests = move.dwell > 0 && move.kind == Move::Kind::kLine;  // before the first move
    if (!move.start.allFinite() || !move.end.allFinite() || !move.centre.allFinite() ||
        !move.normal.allFinite() || !(move.length() > 0 || rests)) {
        return "a vector is not finite or the length is 0";
    }
    if (move.rapid ? move.feed != 0 : !(move.feed > 0)) {
        return "the feed is wrong";
    }
    if (move.kind == Move::Kind::kCubic && !((move.cubic.position(0) - move.start).norm() <= 1e-8 &&
                                             (move.cubic.position(1) - move.end).norm() <= 1e-8)) {
        return "the cubic misses an end";
    }
    if (move.kind == Move::Kind::kArc) {
        const Eigen::Vector3d radius = move.start - move.centre;
        const Eigen::Vector3d end =
            move.centre + Eigen::AngleAxisd(move.angle, move.normal) * radius + move.advance;
        if (!(move.angle > 0) || std::abs(move.normal.norm() - 1) > 1e-12 ||
            (end - move.end).norm() > 1e-8 + 1e-14 * radius.norm() * (1 + move.angle)) {
            return "the arc misses its end";
        }
    }
    return "";
}

/// Checks the path that is drawn within the tolerance.
std::string flaw_of_path(ref::Program program) {
    ref::smooth_path(program, ref::Machine());
    const Move* before = nullptr;
    for (const Move& move : program.moves) {
        const std::string found = flaw(move);
        if (!found.empty()) return found;
        if (!(move.deviation <= move.tolerance * (1 + 1e-9))) return "the tolerance is left";
        if (before != nullptr && !((before->end - move.start).norm() <= 1e-9)) return "a gap";
        before = &move;
    }
    return "";
}

/// The campaign runs 100,000, under the sanitizers.
TEST(ReaderFuzz, MutatedProgramsAreRefusedOrSound) {
    const int count = mutations(20000);
    Mutator mutator(samples(is_program), pieces());
    int read = 0;
    for (int i = 0; i < count; ++i) {
        std::string text = mutator.excerpt();
        for (std::size_t n = 1 + mutator.below(4); n > 0; --n) {
            mutator.mutate(text);
        }
        try {
            const ref::Program program = ref::read_gcode_text(text, "part.ngc");
            ++read;
            const Move* before = nullptr;
            for (const Move& move : program.moves) {
                ASSERT_EQ(flaw(move), "") << "line " << move.line << " of case " << i << ":\n"
                                          << text;
                ASSERT_TRUE(before == nullptr ||
                            (before->end == move.start && before->aux_end == move.aux_start))
                    << "line " << move.line << " of case " << i << ":\n"
                    << text;
                before = &move;
            }
            ASSERT_EQ(flaw_of_path(program), "") << "case " << i << ":\n" << text;
        } catch (const ref::InputError&) {
        }
    }
    EXPECT_GT(read, count * 0.15) << "the mutations are too coarse to reach the moves";
    EXPECT_LT(read, count * 0.8) << "the mutations are too fine to be refused";
}

TEST(ReaderFuzz, MutatedPointsAreRefusedOrSound) {
    std::vector<std::string> texts{ref::read_text_file(std::string(DATA_DIR) + "/points.csv")};
    texts.emplace_back(
        "x,y,z,dx,dy,dz\n0,0,0,1,0,0\n5,1,0,0,1,0\n7,9,1,0,0,0\n0,9,1,-1,0,0.5\n3,2,1,0,0,1\n");
    texts.emplace_back(
        "x,y,z,ddx,ddy,ddz\n0,0,0,.1,0,0\n5,1,0,0,.1,0\n7,9,1,0,0,0\n0,9,1,-.1,0,0.5\n");
    texts.emplace_back(
        "x,y,z,dx,dy,dz,ddx,ddy,ddz\n0,0,0,1,0,0,0,.1,0\n5,1,0,0,1,0,0,0,0\n7,9,1,0,0,0,1,0,0\n");
    Mutator mutator(texts, kCells);
    int read = 0;
    for (int i = 0; i < 10000; ++i) {
        std::string text = mutator.excerpt();
        for (std::size_t n = 1 + mutator.below(2); n > 0; --n) {
            mutator.mutate(text);
        }
        ref::PointsOptions options;
        const auto has = [&text](const char* column) { return text.find(column) < text.size(); };
        const int known = has("ddx") ? 2 : has("dx") ? 1 : 0;
        const std::vector<ref::Fit> fits[] = {
            {ref::Fit::kBessel, ref::Fit::kAkima, ref::Fit::kNatural, ref::Fit::kC2,
             ref::Fit::kHermite, ref::Fit::kMoments, ref::Fit::kQuintic},
            {ref::Fit::kHermite, ref::Fit::kClamped},
            {ref::Fit::kMoments, ref::Fit::kQuintic}};
        options.fit = fits[known][mutator.below(fits[known].size())];
        options.ends = static_cast<ref::Ends>(mutator.below(ref::kEndsNames.size()));
        options.parametrisation =
            static_cast<ref::Parametrisation>(mutator.below(ref::kParametrisationNames.size()));
        try {
            const ref::Program program = ref::read_points_text(text, "points.csv", options);
            ++read;
            const Move* before = nullptr;
            for (const Move& move : program.moves) {
                ASSERT_EQ(flaw(move), "") << "line " << move.line << " of case " << i << ":\n"
                                          << text;
                ASSERT_TRUE(before == nullptr ||
                            (before->end == move.start && before->aux_end == move.aux_start))
                    << "case " << i << ":\n"
                    << text;
                before = &move;
            }
        } catch (const ref::InputError&) {
        }
    }
    EXPECT_GT(read, 1000);
    EXPECT_LT(read, 8000);
}

TEST(ReaderFuzz, MutatedMachinesAreRefusedOrSound) {
    Mutator mutator(samples(is_machine), kWords);
    int read = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = mutator.excerpt();
        for (std::size_t n = 1 + mutator.below(4); n > 0; --n) {
            mutator.mutate(text);
        }
        try {
            const ref::Machine machine = ref::read_machine_text(text, "mill.ini");
            ++read;
            ASSERT_TRUE(machine.velocity > 0 && machine.acceleration > 0 && machine.jerk > 0)
                << text;
            for (const ref::AxisLimits& axis : machine.axis) {
                ASSERT_TRUE(axis.velocity > 0 && axis.acceleration > 0 && axis.jerk > 0) << text;
                ASSERT_LT(axis.min, axis.max) << text;
                ASSERT_TRUE(std::isfinite(axis.min) && std::isfinite(axis.max)) << text;
            }
        } catch (const ref::InputError&) {
        }
    }
    EXPECT_GT(read, 2000);
}

}  // namespace curvecore::tb::reader_fuzz_test
