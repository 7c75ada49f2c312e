// SPDX-License-Identifier: Apache-2.0
// Prints the costs of the same path as splines, as tangent arcs and as chords, and the gain of more
// effort in planning; writes them as JSON.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "ref/feed/planner.hpp"
#include "ref/format/path_words.hpp"
#include "ref/moves/spline_form.hpp"
#include "tb/bench/claim_table.hpp"
#include "tb/support/programs/spline_paths.hpp"

namespace {

using namespace curvecore;
using namespace curvecore::ref;
using curvecore::tb::Table;

constexpr double kFeeds[] = {1.5, 6, 20};  // m/min

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
            PlanOptions options;
            options.aux_axes = program.aux_axes;  // a core with the axes of the program
            const Plan plan = make_plan(program, Machine(), options);
            moves = program.moves.size();
            if (feed == 6) {
                words = std::to_string(segment_bus_words(options.aux_axes) * plan.segments.size() +
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
    add_rows(table, "U-turn", tb::spline_turn());
    add_rows(table, "wave", tb::spline_wave());
    add_rows(table, "gentle", tb::gentle_spline());
    tb::print(table);
    return tb::write_tables({table}, output);
}
