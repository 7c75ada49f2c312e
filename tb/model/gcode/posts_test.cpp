// SPDX-License-Identifier: Apache-2.0
// Programs in the manner of CAM posts, senders and slicers, and small ones of bug reports, read
// unchanged. Their figures are not ours: tb/data/posts/README.md states their origin.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "ref/program/program_reader.hpp"
#include "ref/text/csv_cells.hpp"

namespace curvecore::tb::posts_test {

using ref::Move;
using ref::Program;
using ref::Vec3;

constexpr double kRounded = 1e-6;  // mm: the tables have six decimals
constexpr double kLength = 1e-5;   // mm: of a sum of rounded lengths

/// A row of figures.csv. Lengths are of X Y Z alone, moves those that have a length.
struct Figures {
    std::string folder;
    std::string file;
    double moves, feed, rapid;
    Vec3 end;
    double aux;    // where the auxiliary axis ends
    double dwell;  // s
};

void PrintTo(const Figures& row, std::ostream* out) { *out << row.folder << '/' << row.file; }

std::vector<Figures> figures() {
    std::vector<Figures> rows;
    for (const char* const folder : {"posts", "cases"}) {
        std::ifstream table(std::string(DATA_DIR) + '/' + folder + "/figures.csv");
        std::string line;
        for (std::getline(table, line); std::getline(table, line);) {
            const std::vector<std::string_view> cells = ref::cells_of(line);
            const auto number = [&](int i) { return ref::cell_number(cells.at(i)).value(); };
            rows.push_back({folder, std::string(cells.at(0)), number(1), number(2), number(3),
                            Vec3(number(4), number(5), number(6)), number(7), number(8)});
        }
    }
    return rows;
}

/// Sums of a program's moves, to be compared with its row.
struct Sums {
    double moves = 0, feed = 0, rapid = 0, dwell = 0;
    double room = 0;  // Move::length() is off by this where an arc's radii differ
};

Sums sums_of(const Program& program) {
    Sums sums;
    for (const Move& move : program.moves) {
        sums.dwell += move.dwell;
        if (move.kind == Move::Kind::kLine && move.start == move.end) continue;
        ++sums.moves;
        (move.rapid ? sums.rapid : sums.feed) += move.length();
        if (move.kind != Move::Kind::kArc) continue;
        sums.room += 4 * (move.advance - move.normal.dot(move.advance) * move.normal).norm();
    }
    return sums;
}

class Posts : public testing::TestWithParam<Figures> {};

TEST_P(Posts, IsReadToItsEnd) {
    const Figures& row = GetParam();
    const std::string file = std::string(DATA_DIR) + '/' + row.folder + '/' + row.file;
    const Program program = ref::read_program(file, {});
    const Sums sums = sums_of(program);
    EXPECT_EQ(sums.moves, row.moves);
    EXPECT_NEAR(sums.feed, row.feed, kLength + sums.room);
    EXPECT_NEAR(sums.rapid, row.rapid, kLength);
    EXPECT_NEAR(sums.dwell, row.dwell, 1e-9);
    const Move& last = program.moves.back();
    EXPECT_LE((last.end - row.end).norm(), 2 * kRounded) << last.end.transpose();
    double aux = 0;
    for (const double value : last.aux_end) aux += value;
    EXPECT_NEAR(aux, row.aux, kRounded);
}

INSTANTIATE_TEST_SUITE_P(Program, Posts, testing::ValuesIn(figures()), [](const auto& tested) {
    std::string name = tested.param.folder + '_' + tested.param.file;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
});

TEST(PostsTables, HaveEveryProgram) {
    std::set<std::string> rows, files;
    for (const Figures& row : figures()) rows.insert(row.folder + '/' + row.file);
    for (const std::string folder : {"posts", "cases"}) {
        for (const auto& entry : std::filesystem::directory_iterator(DATA_DIR + ('/' + folder))) {
            const std::string extension = entry.path().extension();
            if (extension != ".md" && extension != ".csv" && extension != ".ini") {
                files.insert(folder + '/' + entry.path().filename().string());
            }
        }
    }
    EXPECT_EQ(rows, files);
}

TEST(PostsTables, PointsWithoutZLieInItsPlane) {
    const Program program = ref::read_program(std::string(DATA_DIR) + "/cases/xy_points.csv", {});
    ASSERT_EQ(program.moves.size(), 3U);
    for (const Move& move : program.moves) EXPECT_EQ(move.end.z(), 0);
    EXPECT_EQ(program.moves.back().end, Vec3(30, 9, 0));
}

}  // namespace curvecore::tb::posts_test
