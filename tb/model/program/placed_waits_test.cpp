// SPDX-License-Identifier: Apache-2.0
// Waits for a person: where the plan ends a program for them, and that nothing else of it changes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "hls/word_ledger.hpp"
#include "ref/program/gcode_stream.hpp"
#include "sysc/job/job_stream.hpp"

namespace curvecore::tb::placed_waits_test {

/// A plan as a board takes it: a stream whose program has ended waits for the other.
class Drawn {
  public:
    std::vector<ref::PlannedWait> waits;
    std::vector<std::uint64_t> wait_ticks;  // when they come
    std::vector<ref::PlannedOutput> outputs;
    std::uint64_t ticks = 0;
    std::uint64_t path = 0;
    int programs = 0;

    void take(const ref::Plan& part) {
        std::size_t segment = 0;
        std::size_t wait = 0;
        for (std::size_t n = 0; n < part.pieces.size(); ++n) {
            for (; wait < part.waits.size() && part.waits[wait].pieces == n; ++wait) {
                EXPECT_EQ(part.waits[wait].place, path);
                EXPECT_EQ(part.waits[wait].segments, segment) << "none of another program";
                waits.push_back(part.waits[wait]);
                wait_ticks.push_back(ticks);
            }
            enter(part, segment);
            const ref::ProfilePiece& piece = part.pieces[n];
            path += piece.ds;
            ticks += piece.ticks;
            programs += piece.final ? 1 : 0;
            ledger_.ds(piece.ds);
            ledger_.piece(static_cast<std::int32_t>(piece.ticks), piece.final);
            EXPECT_FALSE(ledger_.apart()) << "piece " << n;
        }
        EXPECT_EQ(wait, part.waits.size());
        enter(part, segment);
        EXPECT_EQ(segment, part.segments.size());
        outputs.insert(outputs.end(), part.outputs.begin(), part.outputs.end());
    }

  private:
    void enter(const ref::Plan& part, std::size_t& segment) {
        while (!ledger_.segments_wait() && segment < part.segments.size()) {
            const ref::Segment& next = part.segments[segment++];
            ledger_.length(next.length);
            ledger_.segment(next.ticks, next.last);
            EXPECT_FALSE(ledger_.apart()) << "segment " << segment;
        }
    }

    hls::WordLedger ledger_;
};

ref::HeldProgram read(const std::string& text, bool waits) {
    std::istringstream stream(text);
    ref::GcodeStream gcode(stream, "t.ngc", {});
    gcode.obey({true, waits});
    ref::Program program = ref::read_all(gcode, "t.ngc");
    return {std::move(program), gcode.events(), {}};
}

Drawn plan(const std::string& text, bool waits, double from_mm = 0) {
    sysc::Options options;
    options.program = std::make_shared<ref::HeldProgram>(read(text, waits));
    options.outputs = 4096;
    options.from_mm = from_mm;
    sysc::JobStream job(options);
    Drawn drawn;
    while (const ref::Plan* part = job.next()) drawn.take(*part);
    return drawn;
}

/// Plans the exact path in small windows.
Drawn plan_in_windows(const std::string& text, bool waits, std::size_t window) {
    const ref::HeldProgram program = read(text, waits);
    ref::PlacedWaits placed;
    ref::MoveSource source = [&, next = std::size_t(0)](ref::Move& move) mutable {
        if (next == program.moves.size()) return false;
        move = program.moves[next++];
        placed.add(move, program.events);
        return true;
    };
    ref::PlanOptions options;
    options.aux_axes = 0;
    options.window = window;
    ref::PlanStream stream(std::move(source), {"t.ngc", 0, 1e9}, ref::Machine{}, options);
    Drawn drawn;
    while (std::optional<ref::Plan> part = stream.next()) {
        placed.place(*part);
        drawn.take(*part);
    }
    return drawn;
}

std::vector<std::string> said(const Drawn& drawn) {
    std::vector<std::string> all;
    for (const ref::PlannedWait& wait : drawn.waits) {
        all.push_back(fmt::format("{} {} {:.3f}", wait.line, wait.what,
                                  static_cast<double>(wait.place) / 65536e6));
    }
    return all;
}

TEST(PlacedWaits, ComeWhereTheProgramAsksForThem) {
    const std::string text =
        "T3 M6\nG1 X10 F600\nM0\nG1 X20\nM1\nT4\nG1 X30\nM6\nM60 G4 P1\nG1 X40\nM0\nM2\n";
    const Drawn drawn = plan(text, true);
    EXPECT_EQ(said(drawn), (std::vector<std::string>{"1 M6 T3 0.000", "3 M0 10.000",
                                                     "8 M6 T4 30.000", "9 M60 30.000"}));
    EXPECT_EQ(drawn.programs, 3);
    EXPECT_TRUE(plan(text, false).waits.empty());
    EXPECT_EQ(said(plan(text, true, 15)),
              (std::vector<std::string>{"8 M6 T4 15.000", "9 M60 15.000"}));
    EXPECT_EQ(said(plan(text, true, 30)),
              (std::vector<std::string>{"8 M6 T4 0.000", "9 M60 0.000"}));
}

TEST(PlacedWaits, InABlockWithAMoveComeBehindIt) {
    const Drawn drawn = plan("G61\nG1 X10 F600\nG1 X20 M0\nG1 X30\nG0 Z5 M60\nG1 X40\nM2\n", true);
    EXPECT_EQ(said(drawn), (std::vector<std::string>{"3 M0 20.000", "5 M60 35.000"}));
    EXPECT_EQ(drawn.programs, 3);
}

TEST(PlacedWaits, DwellsBeforeAWaitAreBeforeItAndOthersBehind) {
    for (const double before : {0.0, 0.2}) {
        for (const double behind : {0.0, 0.3}) {
            const std::string move = fmt::format("G1 X10 F600\nG4 P{}\n", before);
            const std::string rest = fmt::format("G4 P{}\nG1 X20\nM2\n", behind);
            const Drawn drawn = plan(move + "M0\n" + rest, true);
            ASSERT_EQ(drawn.waits.size(), 1);
            EXPECT_EQ(drawn.wait_ticks[0], plan(move + "M2\n", true).ticks);
            EXPECT_EQ(drawn.ticks, plan(move + rest, true).ticks);
        }
    }
}

TEST(PlacedWaits, OutputsBehindAWaitBelongToTheNextProgram) {
    const Drawn drawn =
        plan("M3\nG1 X10 F600\nM5 G4 P1\nT1 M6\nM3\nG4 P1\nM0\nM8\nG1 X20\nM2\n", true);
    std::vector<std::pair<double, int>> seen;
    for (const ref::PlannedOutput& output : drawn.outputs) {
        if (output.kind != ref::OutputKind::kBits) continue;
        seen.emplace_back(output.value, output.waits);
        EXPECT_EQ(output.place % 65536, 0U);
    }
    EXPECT_EQ(seen, (std::vector<std::pair<double, int>>{{1, 0}, {0, 0}, {1, 1}, {9, 2}, {0, 2}}));
}

TEST(PlacedWaits, ADwellBeforeTheFirstMoveIsBehindAWaitAtTheStart) {
    const Drawn plain = plan("G64 P0.01\nG1 X10 F600\nG1 X10 Y5\nM2\n", true);
    const Drawn drawn = plan("G64 P0.01\nT1 M6\nM3\nG4 P2\nG1 X10 F600\nG1 X10 Y5\nM2\n", true);
    EXPECT_EQ(drawn.path, plain.path);
    EXPECT_EQ(drawn.ticks, plain.ticks + 20000);
    EXPECT_EQ(said(drawn), (std::vector<std::string>{"2 M6 T1 0.000"}));
    ASSERT_FALSE(drawn.outputs.empty());
    EXPECT_EQ(drawn.outputs.front().place, 0U);
    EXPECT_EQ(drawn.outputs.front().waits, 1);
}

/// Curves of all kinds, smooth between, and an axis alone.
TEST(PlacedWaits, ComeBehindAnyMove) {
    const std::string moves[] = {
        "G2 X10 Y0 I5 J0\n", "G3 X20 Y0 Z3 I5 P2\n", "G5 X30 Y8 I3 J0 P-2 Q0\n",
        "G1 A40\n",          "G1 X34 Y9 A50\n",      "G0 X40 Y0\n",
        "G1 X41\n"};
    std::string with = "G64 P0.02 F900\n";
    std::string without = with;
    for (const std::string& move : moves) {
        with += move + "G4 P0.1\nM0\nG4 P0.2\n";
        without += move + "G4 P0.1\nG4 P0.2\n";
    }
    const Drawn drawn = plan(with + "G1 X50\nM2\n", true);
    const Drawn plain = plan(without + "G1 X50\nM2\n", true);
    EXPECT_EQ(drawn.waits.size(), std::size(moves));
    EXPECT_EQ(drawn.programs, static_cast<int>(std::size(moves)) + 1);
    EXPECT_EQ(drawn.path, plain.path);
    EXPECT_EQ(drawn.ticks, plain.ticks);
}

/// Random programs: waits at the ends of parts, at dwells, at both.
TEST(PlacedWaits, EndProgramsInAnyParts) {
    std::mt19937 random(1);
    std::size_t waits = 0;
    for (int n = 0; n < 15; ++n) {
        std::string text = "F3000\n";
        std::size_t asked = 0;
        const auto dwell = [&](unsigned chance) {
            if (random() % chance == 0) text += fmt::format("G4 P0.{:03}\n", random() % 100);
        };
        for (int move = 0; move < 150; ++move) {
            dwell(6);
            const std::size_t here = random() % 8 == 0 ? 1 + random() % 2 : 0;
            for (std::size_t i = 0; i < here; ++i) text += i == 0 ? "M0\n" : "M6\n";
            if (here > 0) dwell(2);
            text += fmt::format("G1 X{} Y{}\n", move * 0.25, random() % 40 * 0.25);
            asked += here;
        }
        const std::size_t window = 4 + random() % 60;
        const Drawn drawn = plan_in_windows(text + "M0\nM2\n", true, window);
        const Drawn plain = plan_in_windows(text + "M2\n", false, window);
        EXPECT_EQ(drawn.waits.size(), asked);
        EXPECT_EQ(drawn.ticks, plain.ticks);
        EXPECT_EQ(drawn.path, plain.path);
        waits += asked;
    }
    EXPECT_GT(waits, 300U);
}

}  // namespace curvecore::tb::placed_waits_test
