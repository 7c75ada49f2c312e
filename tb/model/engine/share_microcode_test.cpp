// SPDX-License-Identifier: Apache-2.0
// The shares of a tick, rtl/engine/programs/share.asm, are those of hls::SampleShare for every
// number of samples per tick, and the path is their sum.
#include <gtest/gtest.h>

#include "hls/path_kernel.hpp"
#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "tb/support/microcode/microcode_machine.hpp"
#include "tb/support/microcode/microcode_mutants.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::share_microcode_test {

constexpr char kOfTest[] = "share_microcode_test";
constexpr int kReset = 0;
constexpr int kShare = 1;
constexpr int kPath = 26;
constexpr int kPathIncrement = 28;

assembler::Assembly share_microcode() {
    assembler::Assembly assembly;
    MicrocodeMachine::dispatch(assembly, {"reset", "share"});
    const std::string programs = std::string(RTL_DIR) + "/engine/programs/";
    assemble_source(programs + "ports.asm", assembly);
    assemble_source(programs + "share.asm", assembly);
    assemble_source(programs + "powers.asm", assembly);
    assembly.label("reset");
    assembly.put_starts();
    assemble_text(kOfTest, "go to put_powers\n", assembly);
    assembly.finish();
    return assembly;
}

/// Draws samples of random increments with both; returns the number of words that differ.
class ShareComparison {
  public:
    ShareComparison(const assembler::Assembly& assembly, MicrocodeMachine& machine)
        : machine_(machine), bound_(worst_case(assembly, "share")) {
        machine_.ports().take = [this](int port, int limb, std::int16_t value) {
            if (port != kPath && port != kPathIncrement) return;
            told_[port == kPath ? 0 : 1][limb] = static_cast<std::uint64_t>(value);
        };
    }
    ShareComparison(const ShareComparison&) = delete;

    int samples(int n, std::mt19937_64& random, int count) {
        machine_.set("samples_per_tick", n);
        std::vector<std::int16_t>& memory = machine_.ports().memory;
        memory.assign(240, -1);
        machine_.reset(kReset);
        std::vector<std::int16_t> powers;
        write_powers(powers);
        if (memory != powers) return 1;
        hls::SampleShare kernel(n);
        std::uint64_t path = 0;
        int differ = 0;
        for (int sample = 0; sample < count && differ == 0; ++sample) {
            if (kernel.needs_tick()) {
                const std::uint64_t most = (std::uint64_t{1} << 45) - 1;
                const auto ds = static_cast<std::int64_t>(random() % 5 == 0 ? most
                                                          : random() % 5 == 0
                                                              ? 0
                                                              : random() & most >> random() % 46);
                kernel.tick(ds);
                machine_.set("increment", ds);
            }
            const std::int64_t ds = kernel.sample();
            most_ = std::max(most_, machine_.run(kShare));
            const int left = (1 << n) - 1 - sample % (1 << n);
            differ += machine_.get("share_index") == left ? 0 : 1;
            path += static_cast<std::uint64_t>(ds);
            differ += machine_.get("sigma") == ds ? 0 : 1;
            machine_.set("sigma", 0);
            differ += told(0) == path % kPathEnd ? 0 : 1;
            differ += told(1) == static_cast<std::uint64_t>(ds) ? 0 : 1;
            words_ += 4;
        }
        return differ + (most_ > bound_ ? 1 : 0);
    }

    std::int64_t words() const { return words_; }
    int most_clocks() const { return most_; }

  private:
    static constexpr std::uint64_t kPathEnd = std::uint64_t{1} << 61;

    /// Value that the board was told, of 4 limbs.
    std::uint64_t told(int value) const {
        std::uint64_t sum = 0;
        for (int limb = 4; limb-- > 0;) {
            sum = (sum << engine::kLimbBits) + told_[value][limb];
        }
        return sum % kPathEnd;
    }

    MicrocodeMachine& machine_;
    int bound_;
    int most_ = 0;
    std::uint64_t told_[2][4] = {};
    std::int64_t words_ = 0;
};

TEST(ShareMicrocode, EqualsTheKernel) {
    const assembler::Assembly assembly = share_microcode();
    MicrocodeMachine machine(assembly);
    ShareComparison comparison(assembly, machine);
    std::mt19937_64 random(5);
    int differ = 0;
    for (int n = 0; n <= 15; ++n) {
        const int found = comparison.samples(n, random, std::max(cases(2000, 400000), 5 << n));
        EXPECT_EQ(found, 0) << n;
        differ += found;
    }
    EXPECT_EQ(differ, 0);
    EXPECT_GT(comparison.words(), 500000);
    // The first share of a tick never carries.
    EXPECT_GE(comparison.most_clocks(), worst_case(assembly, "share") - 22);
    std::printf("%lld words, %d clocks\n", static_cast<long long>(comparison.words()),
                worst_case(assembly, "share"));
    EXPECT_FALSE(machine.hazard());
}

TEST(ShareMicrocode, AChangedInstructionIsSeen) {
    const assembler::Assembly assembly = share_microcode();
    const MutantShare share = seen_mutants(
        assembly, static_cast<std::size_t>(cases(3, 1)),
        [&](const std::vector<std::uint32_t>& program, MicrocodeTrace& trace) {
            MicrocodeMachine machine(assembly, program, &trace);
            ShareComparison comparison(assembly, machine);
            std::mt19937_64 random(1);
            for (const int n : {2, 0, 6, 15, 4}) {
                if (comparison.samples(n, random, 300) > 0) return true;
            }
            return !machine.starts_hold();
        },
        [](const std::string& file) { return file != kOfTest; });
    EXPECT_EQ(share.deleted, "");
    share.expect(0.985);
}

}  // namespace curvecore::tb::share_microcode_test
