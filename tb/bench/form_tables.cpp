// SPDX-License-Identifier: Apache-2.0
// Prints the costs of the same path as splines, as tangent arcs and as chords, and the gain of more
// effort in planning; writes them as JSON.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "ref/curve/fit/hermite.hpp"
#include "ref/feed/planner.hpp"
#include "ref/format/path_words.hpp"
#include "ref/moves/spline_form.hpp"
#include "tb/bench/claim_table.hpp"

namespace {

using namespace curvecore;
using namespace curvecore::ref;
using curvecore::tb::Table;

constexpr double kFeeds[] = {1.5, 6, 20};  // m/min

void line_to(Program& program, const Vec3& end) {
    Move move;
    move.start = program.moves.empty() ? Vec3(Vec3::Zero()) : program.moves.back().end;
    move.end = end;
    program.moves.push_back(move);
}

void spline_to(Program& program, const Vec3& end, const Vec3& out, const Vec3& in) {
    Move move;
    move.kind = Move::Kind::kCubic;
    move.start = program.moves.empty() ? Vec3(Vec3::Zero()) : program.moves.back().end;
    move.end = end;
    HermitePiece piece;
    piece.start = move.start;
    piece.end = end;
    piece.start_d1 = out;
    piece.end_d1 = in;
    move.cubic = cubic_of_slopes(piece);
    program.moves.push_back(move);
}

/// A turn back between two lines of 40 mm.
Program u_turn() {
    Program program;
    line_to(program, Vec3(40, 0, 0));
    spline_to(program, Vec3(40, 5, 0), Vec3(6.914, 0, 0), Vec3(-6.914, 0, 0));
    line_to(program, Vec3(0, 5, 0));
    return program;
}

/// The wave y = 3 sin x over 60 mm, with its slopes every quarter of a wave.
Program wave() {
    Program program;
    const double step = M_PI / 4;
    for (double x = step; x < 60; x += step) {
        spline_to(program, Vec3(x, 3 * std::sin(x), 0), step * Vec3(1, 3 * std::cos(x - step), 0),
                  step * Vec3(1, 3 * std::cos(x), 0));
    }
    return program;
}

/// A long curve in space that turns little.
Program gentle() {
    Program program;
    spline_to(program, Vec3(100, 30, 20), Vec3(120, 0, 0), Vec3(90, 60, 30));
    spline_to(program, Vec3(200, 20, 0), Vec3(90, 60, 30), Vec3(120, -40, -20));
    return program;
}

struct Form {
    const char* name;
    SplineForm form;
    double tolerance;
};
constexpr Form kForms[] = {{"splines", SplineForm::kSpline, 0},
                           {"arcs within 1 um", SplineForm::kArcs, 1e-3},
                           {"arcs within 10 um", SplineForm::kArcs, 1e-2},
                           {"chords within 1 um", SplineForm::kChords, 1e-3},
                           {"chords within 10 um", SplineForm::kChords, 1e-2},
                           {"chords within 0.1 mm", SplineForm::kChords, 0.1}};

void add_rows(Table& table, const char* name, const Program& path) {
    for (const Form& form : kForms) {
        std::vector<std::string> times;
        std::string words;
        std::size_t moves = 0;
        for (const double feed : kFeeds) {
            Program program = path;
            for (Move& move : program.moves) move.feed = feed * 1000 / 60;
            program.moves.back().exact_stop = true;
            replace_splines(program, form.form, form.tolerance);
            const Plan plan = make_plan(program, Machine(), PlanOptions());
            moves = program.moves.size();
            if (feed == 6) {
                words = std::to_string(segment_bus_words(0) * plan.segments.size() +
                                       kProfileBusWords * plan.pieces.size());
            }
            times.push_back(fmt::format("{:.3f}", plan.duration_s));
        }
        table.rows.push_back({fmt::format("{}, {}", name, form.name), std::to_string(moves), words,
                              times[0], times[1], times[2]});
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("one path as splines, as tangent arcs, as chords");
    std::string output;
    app.add_option("-o", output, "also as JSON")->type_name("FILE");
    CLI11_PARSE(app, argc, argv);
    Table table{"forms",
                "The same path as splines, as tangent arcs and as chords, on the built-in machine: "
                "moves, words that the host sends (at 6 m/min), seconds by feed",
                {"path", "moves", "words", "1.5 m/min", "6 m/min", "20 m/min"},
                {}};
    add_rows(table, "U-turn", u_turn());
    add_rows(table, "wave", wave());
    add_rows(table, "gentle", gentle());
    tb::print(table);
    return tb::write_tables({table}, output);
}
