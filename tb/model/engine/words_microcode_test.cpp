// SPDX-License-Identifier: Apache-2.0
// Words as microcode, rtl/engine/programs/words.asm with its two streams and ledger.asm, are what
// hls::SegmentEntry, PieceEntry, WordLedger and UnderrunGuard make of them, of streams that are
// damaged, foreign or wrong: every verdict, the queues, the sums, what the guard says; an
// instruction deleted or a field changed is seen.
#include <gtest/gtest.h>

#include "ref/curves/curve_table.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "tb/model/engine/entry_comparison.hpp"
#include "tb/support/microcode/microcode_mutants.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::words_microcode_test {

/// Any configuration.
EntryCase any_case(std::mt19937_64& random) {
    const auto of = [&](int least, int most) {
        return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
    };
    EntryCase any;
    any.core.coef_bits = random() % 4 == 0 ? 36 : of(18, 36);
    any.core.position_bits = of(16, 32);
    any.core.guard_bits = of(2, 12);
    any.core.aux_axes = random() % 2 == 0 ? 0 : of(1, 6);
    any.core.splines = of(0, 1);
    if (of(0, 1) != 0) {
        any.core.table = std::make_shared<ref::CurveTable>();
        any.core.further_words = of(0, 4);
    }
    any.queues = {{64 << of(0, 2), 16 << of(0, 2)}};
    any.most_time = random() % 2 == 0 ? hls::kMaxTimeExponent : of(0, 8);
    return any;
}

/// Most clocks of a word: it comes in, is judged where its stream goes on, and passes.
int bound(const assembler::Assembly& assembly) {
    int most = 0;
    for (const auto& [label, place] : assembly.labels()) {
        const bool of_word = label.size() > 5 && label.substr(label.size() - 5) == "_word";
        if (!of_word || label.substr(0, 6) == "enter_") continue;
        most = std::max(most, worst_case(assembly, label, {"next_segment", "next_piece"}));
    }
    return most +
           std::max(worst_case(assembly, "enter_segment_word"),
                    worst_case(assembly, "enter_piece_word")) +
           worst_case(assembly, "next_piece");
}

TEST(WordsMicrocode, LetsInWhatTheRuleDoes) {
    std::mt19937_64 random(5);
    std::int64_t words = 0;
    int differ = 0;
    int stays = 0;
    int faults[5] = {};
    int holds = 0;
    int begins = 0;
    int short_queues = 0;
    int most = 0;
    int most_guard = 0;
    double mean = 0;
    const int configurations = cases(60, 1000);
    for (int n = 0; n < configurations; ++n) {
        const EntryCase of = any_case(random);
        const assembler::Assembly assembly = words_microcode(of);
        MicrocodeMachine machine(assembly);
        EntryComparison comparison(of, assembly, machine, random());
        for (int run = 0; run < 20; ++run) differ += comparison.programs(1 + run % 4);
        ASSERT_EQ(differ, 0) << n;
        ASSERT_FALSE(machine.hazard());
        ASSERT_LE(comparison.most_clocks(), bound(assembly));
        ASSERT_LE(comparison.most_guard_clocks(), worst_case(assembly, "guard"));
        most = std::max(most, comparison.most_clocks());
        most_guard = std::max(most_guard, comparison.most_guard_clocks());
        mean += comparison.mean_clocks() / configurations;
        words += comparison.words();
        stays += comparison.stays();
        for (int f = 0; f < 5; ++f) faults[f] += comparison.faults()[f];
        holds += comparison.holds();
        begins += comparison.begins();
        short_queues += comparison.short_queues();
    }
    printf("%ld words of %d clocks, %d at most; guard %d\n", static_cast<long>(words),
           static_cast<int>(mean), most, most_guard);
    EXPECT_GT(words, 100'000);
    EXPECT_GT(stays, 1000);
    for (const int fault : faults) EXPECT_GT(fault, 5);
    EXPECT_GT(holds, 500);
    EXPECT_GT(begins, 500);
    EXPECT_GT(short_queues, 500);
    EXPECT_LE(mean, 150);
    EXPECT_LE(most, 500);
    EXPECT_LE(most_guard, 300);
}

TEST(WordsMicrocode, AChangedInstructionIsSeen) {
    EntryCase of;
    of.core.aux_axes = 2;
    of.core.splines = 1;
    of.core.table = std::make_shared<ref::CurveTable>();
    of.core.further_words = 2;
    of.core.coef_bits = 30;
    of.core.position_bits = 28;
    const assembler::Assembly assembly = words_microcode(of);
    const auto differs = [&](const std::vector<std::uint32_t>& program, MicrocodeTrace& trace) {
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            MicrocodeMachine machine(assembly, program, &trace);
            EntryCase some = of;
            some.most_time = seed % 2 == 0 ? 8 : hls::kMaxTimeExponent;
            EntryComparison comparison(some, assembly, machine, seed);
            for (int run = 0; run < 120; ++run) {
                if (comparison.programs(1 + run % 3) > 0) return true;
                if (!machine.starts_hold()) return true;
            }
            if (seed == 2 && comparison.programs(100, true) > 0) return true;
        }
        return false;
    };
    const MutantShare share =
        seen_mutants(assembly, static_cast<std::size_t>(cases(97, 1)), differs,
                     [](const std::string& file) { return !file.empty() && file != "reset"; });
    // Behind no_hold's return stands what finds it once more.
    EXPECT_EQ(share.deleted, "return\n");
    // The rest: a value that is not 0 as another one where that is asked, a way to the same place.
    share.expect(0.98);
}

}  // namespace curvecore::tb::words_microcode_test
