// SPDX-License-Identifier: Apache-2.0
// Prints the worst share of a limit where overrides of 100 to 200 and back to 1 % come at random
// moments of programs that are planned while they are drawn, as JSON too.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <random>
#include <sstream>

#include "ref/program/gcode_stream.hpp"
#include "sysc/job/job_stream.hpp"
#include "tb/bench/claim_table.hpp"
#include "tb/support/judge/hold_run.hpp"
#include "tb/support/programs/live_programs.hpp"

namespace {

using namespace curvecore;

constexpr int kMoments = 2500;  // of each program
constexpr int kTicks = 400;     // between two of them, the mean
constexpr std::int32_t kOne = 1 << 16;

/// Plans a program in parts; the feed that is asked for changes before one of three.
ref::Plan live(const std::string& text, std::mt19937& random) {
    std::istringstream stream(text);
    ref::GcodeStream gcode(stream, "t.ngc", {});
    sysc::Options options;
    options.program = std::make_shared<ref::HeldProgram>(
        ref::HeldProgram{ref::read_all(gcode, "t.ngc"), gcode.events(), {}});
    options.live = true;
    sysc::JobStream job(options, ref::Machine());
    ref::Plan whole;
    for (double most = 100;;) {
        if (random() % 3 == 0) most = 100 + random() % 101;
        job.raise(most);
        const ref::Plan* part = job.next();
        if (part == nullptr) return whole;
        if (whole.pieces.empty()) {
            whole = *part;
            continue;
        }
        for (ref::PlannedBranch branch : part->branches) {
            branch.piece += whole.pieces.size();
            whole.branches.push_back(std::move(branch));
        }
        whole.segments.insert(whole.segments.end(), part->segments.begin(), part->segments.end());
        whole.pieces.insert(whole.pieces.end(), part->pieces.begin(), part->pieces.end());
    }
}

void add_row(tb::Table& table, const char* name, double feed, const std::string& moves) {
    const std::string text = fmt::format("G90 G64 P0.01 F{}\n{}M2\n", feed, moves);
    std::mt19937 random(1);
    double worst = 0;
    int moments = 0;
    while (moments < kMoments) {
        const ref::Plan plan = live(text, random);
        tb::HoldRun run(plan, ref::Machine());
        std::int32_t target = kOne;
        while (run.active()) {
            if (random() % kTicks == 0) {
                target = random() % 2 == 0 ? kOne : static_cast<std::int32_t>(random() % kOne) + 1;
                ++moments;
            }
            run.tick(target);
        }
        worst = std::max(worst, run.finish().most());
    }
    table.rows.push_back({name, std::to_string(moments), fmt::format("{:.3f}", worst)});
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("limits while overrides change");
    std::string output;
    app.add_option("-o", output, "also as JSON")->type_name("FILE");
    CLI11_PARSE(app, argc, argv);
    tb::Table table{"overrides",
                    "The worst share of a limit of the built-in machine over windows of 1 to 150 "
                    "ms, where feeds are raised up to 200 % and time is slowed at random moments",
                    {"program", "moments", "worst share"},
                    {}};
    add_row(table, "line of 400 mm", 3000, "G1 X400\n");
    add_row(table, "surface", 3000, tb::surface());
    add_row(table, "corners and G0", 2000, tb::corners());
    add_row(table, "arcs", 6000, tb::arcs());
    tb::print(table);
    return tb::write_tables({table}, output);
}
