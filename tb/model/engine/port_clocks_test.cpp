// SPDX-License-Identifier: Apache-2.0
// The board knows an answer some clocks after it was told what is asked, where the twin's ports
// answer at once: no way through the programs is shorter. The clocks are those of
// rtl/engine/engine_entry.sv, engine_words.sv and engine_motion.sv.
#include <gtest/gtest.h>

#include <queue>
#include <set>

#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/compiler/motion_program.hpp"

namespace curvecore::tb::port_clocks_test {

using engine::Instruction;
using engine::Op;

/// A number of ports.asm, told by OUT, and one that IN or BR asks then, at least so many clocks
/// behind the term of OUT's last limb.
struct Answer {
    int told;
    Op by;
    int asked;
    int clocks;
};
constexpr int kTake = 5, kCheck = 6, kSelect = 7, kTakeRequest = 8;                 // OUT
constexpr int kPath = 26, kPathRate = 29;                                           // OUT
constexpr int kWordIn = 4, kCheckIn = 5, kOverride = 9, kRegister = 32;             // IN
constexpr int kSegmentWaits = 4, kPieceWaits = 5, kHolds = 6, kHeld = 8, kTag = 9;  // BR
constexpr Answer kAnswers[] = {
    {kSelect, Op::kBr, kTag, 5},
    {kSelect, Op::kIn, kWordIn, 3},
    {kSelect, Op::kIn, kCheckIn, 3},
    {kSelect, Op::kBr, kHolds, 6},
    {kTake, Op::kBr, kSegmentWaits, 3},
    {kTake, Op::kBr, kPieceWaits, 3},
    {kTake, Op::kBr, kTag, 5},
    {kTake, Op::kIn, kWordIn, 3},
    {kTake, Op::kIn, kCheckIn, 3},
    {kTake, Op::kBr, kHolds, 6},
    {kCheck, Op::kBr, kHolds, 5},
    {kCheck, Op::kIn, kCheckIn, 2},
    {kTakeRequest, Op::kBr, kHeld, 3},
    {kTakeRequest, Op::kIn, kOverride, 2},
    // A request between them has its two clocks: rtl/bus/register_file.sv.
    {kPath, Op::kIn, kRegister, 4},
    {kPathRate, Op::kIn, kRegister, 4},
};

class ShortWays {
  public:
    explicit ShortWays(const assembler::Assembly& assembly) : assembly_(assembly) {
        for (std::size_t at = 0; at < size(); ++at) {
            if (is_branch(at) && (here(at).f0 & engine::kCall) != 0) returns_.insert(at + 1);
        }
        std::set<std::string> known;
        for (const auto& [place, datum] : assembly.data()) known.insert(datum.name);
        for (const assembler::Start& start : assembly.starts()) {
            known.insert("place of " + start.label);
        }
        for (const auto& [label, place] : assembly.labels()) {
            if (known.count("place of " + label) > 0) returns_.insert(place);
        }
    }

    /// Returns "told, asked: clocks" of every answer that is asked for too early.
    std::string early() const {
        std::string text;
        for (std::size_t at = 0; at < size(); ++at) {
            if (here(at).op != Op::kOut) continue;
            const std::vector<int> clocks = from(at);
            for (const Answer& answer : kAnswers) {
                if ((here(at).f1 & 31) != answer.told) continue;
                for (std::size_t to = 0; to < size(); ++to) {
                    if (!asks(here(to), answer) || clocks[to] >= answer.clocks) continue;
                    text += assembly_.placed()[at].source.text + ", " +
                            assembly_.placed()[to].source.text + ": " + std::to_string(clocks[to]) +
                            "\n";
                }
            }
        }
        return text;
    }

  private:
    static constexpr int kFar = 100;

    std::size_t size() const { return assembly_.placed().size(); }
    const Instruction& here(std::size_t at) const { return assembly_.placed()[at].instruction; }
    bool is_branch(std::size_t at) const { return engine::is_branch(here(at).op); }
    static bool asks(const Instruction& i, const Answer& answer) {
        if (i.op != answer.by) return false;
        const int asked = i.op == Op::kIn ? i.f0 & 31 : i.f0 & 15;
        return answer.asked == kRegister ? asked >= 8 && asked < 26 : asked == answer.asked;
    }

    /// Least clocks from the last limb of an OUT to the first term of each instruction.
    std::vector<int> from(std::size_t out) const {
        std::vector<int> least(size(), kFar);
        using Way = std::pair<int, std::size_t>;
        std::priority_queue<Way, std::vector<Way>, std::greater<>> ways;
        ways.push({2, out + 1});
        while (!ways.empty()) {
            const auto [clocks, at] = ways.top();
            ways.pop();
            if (at >= size() || clocks >= least[at]) continue;
            least[at] = clocks;
            const int next = clocks + engine::clocks(here(at));
            const int f0 = here(at).f0;
            const bool always = is_branch(at) && (f0 & 0x1f) == engine::kNot;
            if (!always) ways.push({next, at + 1});
            if (!is_branch(at)) continue;
            if ((f0 & engine::kReturn) == 0) {
                ways.push({next, static_cast<std::size_t>(here(at).f1 << 8 | here(at).f2)});
                continue;
            }
            for (const std::size_t place : returns_) ways.push({next, place});
        }
        return least;
    }

    const assembler::Assembly& assembly_;
    std::set<std::size_t> returns_;  // wherever a link may lead
};

TEST(PortClocks, NoAnswerIsAskedForBeforeItIsKnown) {
    for (const int rate_bits : {0, 29}) {
        for (const int splines : {0, 1}) {
            ref::CoreParameters core;
            core.splines = splines;
            const assembler::Assembly made =
                assembler::motion_program(core, {1024, 1024}, RTL_DIR "/..", rate_bits);
            EXPECT_EQ(ShortWays(made).early(), "");
        }
    }
}

TEST(PortClocks, OneThatIsAskedForTooEarlyIsFound) {
    const auto early = [](const std::string& between) {
        assembler::Assembly assembly;
        assemble_source(RTL_DIR "/engine/programs/ports.asm", assembly);
        assemble_text("test",
                      "word a\nport select = a, 1 limb\n" + between +
                          "if port tag_is go to there\nthere:\nreturn\n",
                      assembly);
        assembly.finish();
        return ShortWays(assembly).early();
    };
    EXPECT_EQ(early(""), "port select = a, 1 limb, if port tag_is go to there: 2\n");
    EXPECT_EQ(early("a = a + 1, 1 limb\n"), "");
    EXPECT_EQ(early("port check = a, 1 limb\n"),
              "port select = a, 1 limb, if port tag_is go to there: 4\n");
}

}  // namespace curvecore::tb::port_clocks_test
