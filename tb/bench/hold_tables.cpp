// SPDX-License-Identifier: Apache-2.0
// Prints the durations of holds, from ticks all along plans with stop branches, and of resumes, as
// JSON too.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "ref/feed/pieces/piece_walk.hpp"
#include "ref/feed/planner.hpp"
#include "ref/moves/move_part.hpp"
#include "ref/path/smooth_path.hpp"
#include "tb/bench/claim_table.hpp"
#include "tb/support/judge/hold_run.hpp"
#include "tb/support/programs/chopped_curves.hpp"
#include "tb/support/programs/even_paths.hpp"
#include "tb/support/programs/random_lines.hpp"
#include "tb/support/segments/random_splines.hpp"

namespace {

using namespace curvecore;
using curvecore::tb::HoldRun;
using curvecore::tb::Table;

constexpr std::int32_t kOne = 1 << 16;
constexpr std::uint64_t kSettled = 2;    // ticks at the rate 1 until it counts as constant
constexpr std::uint64_t kFlights = 400;  // approximate number of ticks in flight
constexpr std::uint64_t kResumes = 12;   // approximate number of holds that are followed by others
constexpr std::uint64_t kWhile = 50;     // ticks from one of those to the next

constexpr double kSlower[] = {0.8, 0.6};  // overrides
constexpr double kRates[] = {1, 0.99, 0.9, 0.8, 0.6};
constexpr std::uint64_t kHolds = 150;  // approximate number of holds at each of these
constexpr int kStarts = 6;             // places from which a program is planned anew

/// The longest of some holds.
class Longest {
  public:
    /// Holds from the present state of the run.
    void see(HoldRun run) {
        if (run.active()) ticks_ = std::max(ticks_, run.stop());
    }
    void see(std::uint64_t ticks) { ticks_ = std::max(ticks_, ticks); }
    std::string text(const ref::Plan& plan) const {
        return ticks_ == 0 ? "-" : fmt::format("{:.3f}", static_cast<double>(ticks_) * plan.tick_s);
    }

  private:
    std::uint64_t ticks_ = 0;
};

struct Holds {
    Longest first;      // in the first ticks of a program
    Longest in_flight;  // at full rate since the start
    Longest resumed;    // at full rate again
    Longest back;       // while time accelerates
    Longest slower[2];  // at kSlower since the start
    Longest resumes;    // time that a resume costs by the bounds of holds
};

/// Makes holds from a run that has just stopped and resumes.
void resume(HoldRun run, Holds& holds) {
    std::uint64_t full = 0;  // ticks
    double lost = 0;         // ticks
    for (std::uint64_t n = 0; run.active(); ++n) {
        const std::int32_t rate = run.tick(kOne);
        full = rate == kOne ? full + 1 : 0;
        lost += 1 - static_cast<double>(rate) / kOne;
        if (full == 1) holds.resumes.see(static_cast<std::uint64_t>(lost));
        if (full < kSettled) {
            if (n % kWhile == 0) holds.back.see(run);
        } else if ((full - kSettled) % kWhile == 0) {
            holds.resumed.see(run);
        }
    }
}

Holds hold(const ref::Plan& plan) {
    const auto ticks = static_cast<std::uint64_t>(plan.duration_s / plan.tick_s);
    Holds holds;
    HoldRun run(plan, ref::Machine());
    for (std::uint64_t tick = 1; run.active(); ++tick) {
        run.tick(kOne);
        if (tick >= kSettled && tick <= ref::kStopLead) holds.first.see(run);
        if (tick > ref::kStopLead && tick % (ticks / kFlights + 1) == 0) holds.in_flight.see(run);
        if (tick % (ticks / kResumes + 1) == ticks / kResumes / 2) {
            HoldRun held = run;
            held.stop();
            resume(held, holds);
        }
    }
    for (int n = 0; n < 2; ++n) {
        HoldRun slower(plan, ref::Machine());
        const auto rate = static_cast<std::int32_t>(kSlower[n] * kOne);
        for (std::uint64_t tick = 1; slower.active(); ++tick) {
            slower.tick(rate);
            if (tick > 2 * ref::kStopLead && tick % (ticks / kFlights + 1) == 0) {
                holds.slower[n].see(slower);
            }
        }
    }
    return holds;
}

/// The rest of a program behind a place of its path, mm.
ref::Program rest_of(const ref::Program& program, double from) {
    ref::Program rest = program;
    rest.moves.clear();
    for (const ref::Move& move : program.moves) {
        const double length = move.length();
        if (length > from) rest.moves.push_back(ref::part_of(move, std::max(from, 0.), length));
        from -= length;
    }
    return rest;
}

/// Time of a plan up to a place of its path, ticks.
double ticks_to(const ref::Plan& plan, double from) {
    double left = from / (plan.unit_mm * ref::kQuantum);
    double ticks = 0;
    for (const ref::ProfilePiece& piece : plan.pieces) {
        const auto length = static_cast<double>(piece.ds);
        if (left < length) return ticks + ref::ticks_at(piece, left);
        left -= length;
        ticks += piece.ticks;
    }
    return ticks;
}

/// The longest time that a start from rest costs at places all along the program, ticks.
Longest starts(const ref::Program& program, const ref::Plan& plan) {
    double length = 0;
    for (const ref::Move& move : program.moves) length += move.length();
    const auto whole = static_cast<double>(ref::ticks_of(plan.pieces));
    Longest longest;
    for (int n = 1; n < 2 * kStarts; n += 2) {
        const double from = length * n / (2 * kStarts);
        const ref::Plan rest = make_plan(rest_of(program, from), ref::Machine(), {});
        const double lost = ref::ticks_of(rest.pieces) - (whole - ticks_to(plan, from));
        longest.see(static_cast<std::uint64_t>(std::max(lost, 0.)));
    }
    return longest;
}

/// Rows of chords of 0.2 mm over a surface.
ref::Program surface() {
    tb::ProgramBuilder builder;
    for (int n = 1; n <= 1500; ++n) {
        const int row = (n - 1) / 250;
        const double x = 0.2 * (row % 2 == 0 ? n - 250 * row : 250 * (row + 1) - n);
        const double y = 0.5 * row;
        builder.line({x, y, 2 * std::sin(x / 5) * std::cos(y / 4) + 0.6 * std::sin(1.3 * x)}, 100);
    }
    ref::Program program = tb::with_tolerance(std::move(builder.program()), 0.01);
    smooth_path(program, ref::Machine());
    return program;
}

ref::Program with_rapids() {
    tb::ProgramBuilder builder;
    builder.line({100, 0, 0}, 0);
    builder.line({100, 60, 0}, 10);
    builder.line({0, 0, 0}, 0);
    return builder.program();
}

/// The longest hold, and the longest way of one, at each of these overrides; and the cost of a
/// resume.
void add_rates(Table& table, const char* name, const ref::Program& program) {
    const ref::Plan plan = make_plan(program, ref::Machine(), {});
    const auto every = static_cast<std::uint64_t>(plan.duration_s / plan.tick_s) / kHolds + 1;
    std::vector<std::string> row{name};
    double most_mm = 0;
    for (const double rate : kRates) {
        HoldRun run(plan, ref::Machine());
        Longest longest;
        for (std::uint64_t tick = 1; run.active(); ++tick) {
            run.tick(static_cast<std::int32_t>(std::lround(rate * kOne)));
            if (tick <= 2 * ref::kStopLead || tick % every != 0 || !run.active()) continue;
            HoldRun held = run;
            longest.see(held.stop());
            const auto way = static_cast<double>(held.s() - run.s());
            most_mm = std::max(most_mm, way * ref::kQuantum * plan.unit_mm);
        }
        row.push_back(longest.text(plan));
    }
    row.push_back(fmt::format("{:.1f}", most_mm));
    row.push_back(starts(program, plan).text(plan));
    table.rows.push_back(row);
}

void add_row(Table& table, const std::string& name, const ref::Program& program) {
    const ref::Plan plan = make_plan(program, ref::Machine(), {});
    const Holds holds = hold(plan);
    table.rows.push_back(
        {name, fmt::format("{:.3f}", plan.duration_s), std::to_string(plan.branches.size()),
         holds.first.text(plan), holds.in_flight.text(plan), holds.resumed.text(plan),
         holds.back.text(plan), holds.slower[0].text(plan), holds.slower[1].text(plan),
         holds.resumes.text(plan), starts(program, plan).text(plan)});
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("how long holds take");
    std::string output;
    app.add_option("-o", output, "also as JSON")->type_name("FILE");
    CLI11_PARSE(app, argc, argv);
    Table table{
        "holds",
        "The longest hold to rest on the built-in machine, s, from sampled ticks: in a "
        "program's first 32 ticks, at full rate from there on, at full rate after a "
        "resume, while time comes back to it, and at overrides of 80 and 60 %; and the "
        "longest time that a resume costs: by the bounds of holds, and by a plan from where "
        "the axes stand, as `stream` makes",
        {"path", "plan, s", "branches", "first ticks", "in flight", "after a resume",
         "while time comes back", "at 80 %", "at 60 %", "resume by bounds", "resume anew"},
        {}};
    add_row(table, "line of 950 mm", tb::fast_line(950));
    add_row(table, "line of 100 mm", tb::fast_line(100));
    add_row(table, "circles of 50 mm", tb::fast_arc(25, 8 * M_PI, 0));
    add_row(table, "circles of 4 mm", tb::fast_arc(2, 20 * M_PI, 0));
    add_row(table, "helix", tb::fast_arc(10, 6 * M_PI, 12));
    add_row(table, "wave", tb::chopped_wave(0, 500));
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        add_row(table, fmt::format("random curves {}", seed), tb::random_splines(seed, 30));
    }
    Table rates{"hold_rates",
                "The longest hold to rest, s, at overrides of 100 to 60 % on the built-in machine; "
                "the longest way of one; and what a resume costs by a plan from where the axes "
                "stand, s",
                {"program", "100 %", "99 %", "90 %", "80 %", "60 %", "way, mm", "resume"},
                {}};
    add_rates(rates, "line of 950 mm", tb::fast_line(950));
    add_rates(rates, "random curves 1", tb::random_splines(1, 30));
    add_rates(rates, "surface", surface());
    add_rates(rates, "with G0", with_rapids());
    tb::print(table);
    tb::print(rates);
    return tb::write_tables({table, rates}, output);
}
