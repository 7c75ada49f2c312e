// SPDX-License-Identifier: Apache-2.0
// Prints the worst load of an axis' limits where the path's jerk is 10,000 times the axes', as JSON
// too.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "ref/feed/planner.hpp"
#include "tb/bench/claim_table.hpp"
#include "tb/support/judge/drawn_limits.hpp"
#include "tb/support/programs/chopped_curves.hpp"
#include "tb/support/programs/even_paths.hpp"

namespace {

using namespace curvecore;

constexpr double kFeed = 500;  // mm/s
constexpr double kLarger = 1e4;

void add_row(tb::Table& table, const char* name, const ref::Program& program) {
    ref::Machine machine;
    machine.velocity *= 2;
    machine.acceleration *= 2;
    machine.jerk *= kLarger;
    const ref::Plan plan = make_plan(program, machine, {});
    table.rows.push_back({name, fmt::format("{:.3f}", plan.duration_s),
                          fmt::format("{:.3f}", tb::drawn_limits(plan, machine).most())});
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("limits of axes far below the path's");
    std::string output;
    app.add_option("-o", output, "also as JSON")->type_name("FILE");
    CLI11_PARSE(app, argc, argv);
    tb::Table table{"axis_jerk",
                    "The built-in machine, whose path has twice its speed and acceleration and "
                    "10,000 times its jerk: the worst share of a limit over any window",
                    {"path", "plan, s", "worst share"},
                    {}};
    add_row(table, "wave", tb::chopped_wave(0, kFeed));
    add_row(table, "circle", tb::chopped_circle(0, kFeed));
    add_row(table, "turn", tb::chopped_turn(0, kFeed));
    add_row(table, "helix", tb::fast_arc(10, 6 * M_PI, 12));
    tb::print(table);
    return tb::write_tables({table}, output);
}
