// SPDX-License-Identifier: Apache-2.0
// The microcode of time: the rate is that of hls::TimeScaler with any events, and rates, branches
// and path together are those of the kernels, whatever is queued; an instruction deleted or a field
// changed is seen.
#include <gtest/gtest.h>

#include "tb/model/engine/path_time_comparison.hpp"
#include "tb/support/microcode/microcode_mutants.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::rate_microcode_test {

/// Unpacks any piece, anywhere in the queue, with the twin; returns whether a word differs.
bool unpacked_differs(MicrocodeMachine& machine, std::mt19937_64& random) {
    hls::ProfileWords piece;
    const auto any = [&](int bits) { return static_cast<std::int64_t>(random() >> (64 - bits)); };
    piece.time_exponent = static_cast<int>(random() % (hls::kMaxTimeExponent + 1));
    const std::int32_t most = 1 << piece.time_exponent;
    piece.ticks = random() % 4 == 0 ? most : 1 + static_cast<std::int32_t>(random() % most);
    piece.exponent = static_cast<int>(random() % 34);  // of three limbs
    piece.final = random() % 2 == 0;
    piece.ds = random() % 4 == 0 ? (std::int64_t{1} << 44) - 1 : any(44);
    for (auto& c : piece.c) c = any(36) - (std::int64_t{1} << 35);
    std::uint64_t words[hls::kProfileBusWords];
    hls::pack(piece, static_cast<unsigned>(random() % 256), words);
    int place = kProfileBegin + 3 * static_cast<int>(random() % kQueueWords);
    machine.set("piece_take", place);
    for (int n = 0; n < hls::kProfileBusWords; ++n) {
        if (n > 1) words[n] |= hls::put(hls::kCheckField, random() % 256);
        write_word(machine.ports().memory, place, words[n]);
        place += 3;
    }
    machine.set("pieces", 7);
    machine.set("profile_words", 77);
    machine.set("next", 0);
    machine.spoil_locals(random);
    machine.run(kFetch);
    const auto is = [&](const char* word, std::int64_t value) {
        return machine.get(word) == value;
    };
    return !(is("next", 1) && is("next_end", std::int64_t{piece.ticks} << 16) &&
             is("next_ds", piece.ds) && is("next_final", piece.final ? 1 : 0) &&
             is("next_c1", piece.c[0]) && is("next_c2", piece.c[1]) && is("next_c3", piece.c[2]) &&
             is("next_tau", std::int64_t{1} << (28 - piece.time_exponent)) &&
             is("next_scale", std::int64_t{1} << (11 + piece.exponent)) &&
             is("piece_take", place) && is("pieces", 6) && is("profile_words", 72));
}

TEST(RateMicrocode, EqualsTheScalerWithAnyEvents) {
    const TimeMicrocode code = time_microcode();
    MicrocodeMachine machine(code.assembly);
    RateComparison comparison(code, machine);
    std::mt19937_64 random(1);
    for (int n = 0; n < cases(300, 30000); ++n) {
        comparison.ticks(random, n % 4 == 0 ? 500 : n % 4 == 1 ? 3 : 100);
        ASSERT_EQ(comparison.differ(), 0) << n;
    }
    EXPECT_GT(comparison.stop_ticks(), 200);
    EXPECT_GT(comparison.words(), 100000);
    EXPECT_FALSE(machine.hazard());
}

TEST(RateMicrocode, EqualsTheKernelsOfTimeAndPath) {
    const TimeMicrocode code = time_microcode();
    MicrocodeMachine machine(code.assembly);
    PathTimeComparison comparison(code, machine);
    for (int n = 1; n <= cases(130, 13000); ++n) {
        comparison.program(static_cast<std::uint32_t>(n), 12, n % 3 == 0 ? 3 : 100, 800);
        ASSERT_EQ(comparison.differ(), 0) << n;
    }
    EXPECT_GT(comparison.ticks(), 100000);
    EXPECT_GT(comparison.stop_ticks(), 2000);
    EXPECT_FALSE(machine.hazard());
    EXPECT_FALSE(machine.strays());
    EXPECT_LE(comparison.bounds()[kRate], 650);
    EXPECT_LE(comparison.bounds()[kFetch], 360);
    // The longest way of all waits, takes a step and is told a wait: no tick does.
    EXPECT_GE(comparison.most()[kRate], comparison.bounds()[kRate] - 110);
}

TEST(RateMicrocode, AnyPieceIsUnpacked) {
    const TimeMicrocode code = time_microcode();
    MicrocodeMachine machine(code.assembly);
    TimeComparison begun(code, machine);
    std::mt19937_64 random(1);
    for (int n = 0; n < cases(5000, 500000); ++n) ASSERT_FALSE(unpacked_differs(machine, random));
}

TEST(RateMicrocode, AChangedInstructionIsSeen) {
    const TimeMicrocode code = time_microcode();
    const MutantShare share = seen_mutants(
        code.assembly, static_cast<std::size_t>(cases(97, 1)),
        [&](const std::vector<std::uint32_t>& program, MicrocodeTrace& trace) {
            MicrocodeMachine rate_machine(code.assembly, program, &trace);
            RateComparison rate(code, rate_machine);
            MicrocodeMachine path_machine(code.assembly, program, &trace);
            PathTimeComparison path(code, path_machine);
            std::mt19937_64 random(1);
            for (std::uint32_t n = 1; n <= 80; ++n) {
                for (int part = 0; part < 8; ++part) {
                    rate.ticks(random, part % 3 == 0 ? 4 : part % 3 == 1 ? 300 : 80);
                }
                path.program(n, 5, n % 3 == 0 ? 3 : 100, 300);
                if (rate.differ() + path.differ() > 0) return true;
            }
            for (int n = 0; n < 40; ++n) {
                if (unpacked_differs(rate_machine, random)) return true;
            }
            return rate_machine.strays() || path_machine.strays();
        },
        [](const std::string& file) { return file.find("path.asm") == std::string::npos; });
    EXPECT_EQ(share.deleted, "");
    // The rest: truths and small words with fewer limbs, a way to the same place by another one,
    // what is asked for its sign or for 0 alone as another value.
    share.expect(0.983);
}

}  // namespace curvecore::tb::rate_microcode_test
