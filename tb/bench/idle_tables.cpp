// SPDX-License-Identifier: Apache-2.0
// Prints the jumps at the joints of idle moves, [Petrakov]'s claims, and writes them as JSON.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "ref/join/least.hpp"
#include "tb/bench/claim_table.hpp"
#include "tb/support/programs/idle_turns.hpp"

namespace {

using namespace curvecore::ref;
using curvecore::tb::kSlowFeed;
using curvecore::tb::Table;

std::string number(double value) { return fmt::format("{:.3g}", value); }

/// Greater value of both joints.
double at_joints(const JoinJumps& found, double Jump::*what) {
    return std::max(found.start.*what, found.end.*what);
}

Table across_table() {
    Table table{
        "idle_across",
        "Acceleration across the path that jumps at the joints of a U-turn over 5 mm "
        "between straight lines, g: v^2 times the jump of curvature",
        {"move", "end tangents, mm", "jump of curvature, 1/mm", "1.5 m/min", "6 m/min", "60 m/min"},
        {}};
    const auto row = [&table](const char* name, const std::string& tangents, IdleMove move) {
        std::vector<std::string> cells{name, tangents};
        for (const double feed : {kSlowFeed, 100., 1000.}) {
            move.start.feed = move.end.feed = feed;
            const JoinJumps found = jumps(move, SpeedLaw::kSmooth);
            if (cells.size() == 2) cells.push_back(number(at_joints(found, &Jump::curvature)));
            cells.push_back(number(at_joints(found, &Jump::across)));
        }
        table.rows.push_back(cells);
    };
    for (const double k : {3.09, 4.37, 6.91, 9.78}) {
        row("one cubic", number(k), curvecore::tb::u_turn(JoinFit::kCubic, 5, k));
    }
    row("one quintic", "6.91", curvecore::tb::u_turn(JoinFit::kQuintic, 5, 6.91));
    return table;
}

Table along_table() {
    Table table{"idle_along",
                "Acceleration along the path that jumps where a speed of 25 mm/s (1.5 m/min) is "
                "reached from rest, g",
                {"over, mm", "in, ms", "at constant acceleration", "by a law of fifth degree"},
                {}};
    for (const double time : {0.01, 0.064, 0.1, 0.25}) {
        const double way = kSlowFeed * time / 2;
        IdleMove move = curvecore::tb::lane_change(JoinFit::kQuintic, 0, way, 0);
        move.start.feed = 1e-9;
        table.rows.push_back({number(way), number(time * 1e3),
                              number(at_joints(jumps(move, SpeedLaw::kEven), &Jump::along)),
                              number(at_joints(jumps(move, SpeedLaw::kSmooth), &Jump::along))});
    }
    return table;
}

Table fits_table() {
    Table table{
        "idle_fits",
        "What jumps on a U-turn over 5 mm between straight lines through three control "
        "points, at 1.5 m/min",
        {"fit", "slope, degrees", "curvature at the joints, 1/mm", "at the control points, 1/mm",
         "acceleration at worst, g", "greatest curvature, 1/mm"},
        {}};
    const auto row = [&table](const std::string& name, const IdleMove& move) {
        const JoinJumps ends = jumps(move, SpeedLaw::kSmooth);
        const Jump inside = worst_inside(move, SpeedLaw::kSmooth);
        const double slope = std::max(at_joints(ends, &Jump::slope), inside.slope);
        table.rows.push_back({name, number(slope * 180 / M_PI),
                              number(at_joints(ends, &Jump::curvature)), number(inside.curvature),
                              number(std::max(at_joints(ends, &Jump::across), inside.across)),
                              number(curvecore::tb::peak_curvature(move))});
    };
    for (const JoinFit fit :
         {JoinFit::kCubic, JoinFit::kMoments, JoinFit::kC2, JoinFit::kQuintic}) {
        const IdleMove move = curvecore::tb::u_turn_through(fit, 5, 3);
        const std::string name(kJoinFitNames[static_cast<std::size_t>(fit)]);
        row(name, move);
        if (fit == JoinFit::kCubic || fit == JoinFit::kC2) {
            row(name + ", points for least jerk", with_least(move, Least::kJerk));
        }
    }
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Idle moves: jumps of acceleration, fits");
    std::string json_path;
    app.add_option("-o,--json", json_path, "write {tables: {NAME: {claim, header, rows}}}");
    CLI11_PARSE(app, argc, argv);
    std::vector<Table> tables;
    for (const auto make : {across_table, along_table, fits_table}) {
        tables.push_back(make());
        print(tables.back());
    }
    return curvecore::tb::write_tables(tables, json_path);
}
