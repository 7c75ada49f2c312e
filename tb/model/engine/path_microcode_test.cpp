// SPDX-License-Identifier: Apache-2.0
// The path's microcode, rtl/engine/programs/path.asm, makes the increments of hls::PathKernel: at
// any rate, held, starved of pieces; an instruction deleted or a field changed is seen.
#include <gtest/gtest.h>

#include "hls/path_kernel.hpp"
#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "tb/support/microcode/microcode_machine.hpp"
#include "tb/support/microcode/microcode_mutants.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/segments/random_pieces.hpp"

namespace curvecore::tb::path_microcode_test {

constexpr int kPiece = 0;
constexpr int kTick = 1;

assembler::Assembly path_microcode() {
    assembler::Assembly assembly;
    MicrocodeMachine::dispatch(assembly, {"piece", "tick"});
    assemble_text("branches",
                  "word passes = 0\nbranch_passes:\npasses = passes + 1\ngo to piece_begins\n",
                  assembly);
    for (const char* file : {"ports", "path"}) {
        assemble_source(std::string(RTL_DIR) + "/engine/programs/" + file + ".asm", assembly);
    }
    assembly.finish();
    return assembly;
}

/// Random pieces, some of them with words that lead back, or beyond the end.
std::vector<hls::ProfileWords> rough_pieces(std::uint32_t seed, int count, int most_ticks) {
    std::mt19937_64 random(seed);
    std::vector<hls::ProfileWords> pieces = random_pieces(seed, count, most_ticks);
    for (hls::ProfileWords& piece : pieces) {
        if (random() % 2 == 0) continue;
        piece.ds = piece.ds >> random() % 3;
        if (random() % 3 == 0) {
            const int most = hls::kMaxTimeExponent + 1 - piece.time_exponent;
            piece.time_exponent += static_cast<int>(random() % static_cast<unsigned>(most));
        }
        for (hls::Word<hls::kProfileBits>& c : piece.c) {
            c = static_cast<std::int64_t>(random() % (std::uint64_t{1} << 34)) -
                (std::int64_t{1} << 33);
        }
    }
    return pieces;
}

/// The kernel and the twin, tick by tick.
class PathComparison {
  public:
    PathComparison(const assembler::Assembly& assembly, MicrocodeMachine& machine)
        : machine_(machine), bound_(worst_case(assembly, "tick")) {
        write_powers(machine_.ports().memory);
        machine_.ports().take = [this](int port, int, std::int16_t value) {
            constexpr int kPathActive = 15;
            if (port == kPathActive) told_ += value;
        };
    }
    PathComparison(const PathComparison&) = delete;

    /// Drives a random program with both; returns the number of words that differ.
    int program(std::uint32_t seed, int pieces, int most_ticks) {
        std::mt19937_64 random(seed);
        const std::vector<hls::ProfileWords> words = rough_pieces(seed, pieces, most_ticks);
        std::size_t told = 0;
        std::size_t taken = 0;
        machine_.set("passes", 0);
        told_ = 0;
        int differ = 0;
        for (int tick = 0; tick < 80 || (taken < words.size() && tick < 4000); ++tick) {
            if (told == taken && told < words.size() && random() % 4 != 0) tell(words[told++]);
            const auto rate = static_cast<std::int32_t>(random() % 3 == 0   ? 65536
                                                        : random() % 9 == 0 ? 0
                                                                            : random() % 65537);
            const bool held = random() % 8 == 0;
            const bool may_begin = random() % 8 != 0;
            const std::int64_t increment = kernel_.tick(
                rate,
                [&](hls::ProfileWords& piece) {
                    if (told == taken) return false;
                    piece = words[taken++];
                    final_ = piece.final;
                    return true;
                },
                held || !may_begin);
            machine_.set("rate", rate);
            machine_.set("target", held ? 0 : 1);
            machine_.set("may_begin", may_begin ? 1 : 0);
            most_clocks_ = std::max(most_clocks_, machine_.run(kTick));
            differ += machine_.get("increment") != increment ? 1 : 0;
            differ += machine_.get("active") != (kernel_.active() ? 1 : 0) ? 1 : 0;
            differ += (machine_.get("idle") == hls::kIdleTicks) != kernel_.idle() ? 1 : 0;
            differ += machine_.get("next") != (told != taken ? 1 : 0) ? 1 : 0;
            const hls::ProfileWords* queued = told != taken ? &words[taken] : nullptr;
            differ += machine_.get("queued_ticks") != (queued ? queued->ticks : 0) ? 1 : 0;
            differ += machine_.get("finals") != (queued && queued->final ? 1 : 0) ? 1 : 0;
            differ += machine_.get("passes") != static_cast<std::int64_t>(taken) ? 1 : 0;
            differ += kernel_.active() && machine_.get("final") != (final_ ? 1 : 0) ? 1 : 0;
            differ += told_ != static_cast<std::int64_t>(taken) ? 1 : 0;
            differ += most_clocks_ > bound_ ? 1 : 0;
            words_ += 9;
            if (differ > 0) return differ;
        }
        return differ;
    }

    std::int64_t words() const { return words_; }
    int most_clocks() const { return most_clocks_; }

  private:
    void tell(const hls::ProfileWords& piece) {
        machine_.set("ticks", piece.ticks);
        machine_.set("m", piece.time_exponent);
        machine_.set("e", piece.exponent);
        machine_.set("next_ds", piece.ds);
        machine_.set("next_final", piece.final ? 1 : 0);
        machine_.set("next_c1", piece.c[0]);
        machine_.set("next_c2", piece.c[1]);
        machine_.set("next_c3", piece.c[2]);
        machine_.set("queued_ticks", piece.ticks);
        machine_.set("finals", piece.final ? 1 : 0);
        machine_.run(kPiece);
    }

    MicrocodeMachine& machine_;
    hls::PathKernel kernel_;
    bool final_ = false;  // of the present piece
    std::int64_t words_ = 0;
    std::int64_t told_ = 0;  // pieces with which the path is active
    int bound_;
    int most_clocks_ = 0;
};

TEST(PathMicrocode, EqualsTheKernelAtAnyRate) {
    const assembler::Assembly assembly = path_microcode();
    MicrocodeMachine machine(assembly);
    machine.set("idle", hls::kIdleTicks);
    PathComparison comparison(assembly, machine);
    int differ = 0;
    for (int n = 1; n <= cases(40, 1000); ++n) {
        differ += comparison.program(static_cast<std::uint32_t>(n), 12, n % 2 == 0 ? 3 : 100);
    }
    EXPECT_EQ(differ, 0);
    EXPECT_GT(comparison.words(), 40000);
    EXPECT_FALSE(machine.hazard());
    // The longest way of all goes back and beyond the end in one tick: no piece does.
    EXPECT_GE(comparison.most_clocks(), worst_case(assembly, "tick") - 40);
}

TEST(PathMicrocode, AChangedInstructionIsSeen) {
    const assembler::Assembly assembly = path_microcode();
    const MutantShare share =
        seen_mutants(assembly, static_cast<std::size_t>(cases(11, 1)),
                     [&](const std::vector<std::uint32_t>& program, MicrocodeTrace& trace) {
                         MicrocodeMachine machine(assembly, program, &trace);
                         machine.set("idle", hls::kIdleTicks);
                         PathComparison comparison(assembly, machine);
                         for (std::uint32_t seed = 1; seed <= 60; ++seed) {
                             if (comparison.program(seed, 8, seed % 2 == 0 ? 3 : 60) > 0)
                                 return true;
                         }
                         return false;
                     });
    EXPECT_EQ(share.deleted, "");
    // The rest: a way to the same place by another one, a power as a sum with small ones.
    share.expect(0.99);
}

}  // namespace curvecore::tb::path_microcode_test
