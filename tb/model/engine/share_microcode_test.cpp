// SPDX-License-Identifier: Apache-2.0
// The shares of a tick, rtl/engine/programs/share.asm, are those of hls::SampleShare for every
// number of samples per tick, and the path is their sum.
#include <gtest/gtest.h>

#include "hls/path_kernel.hpp"
#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "tb/model/engine/microcode_machine.hpp"
#include "tb/model/engine/microcode_mutants.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb {
namespace {

constexpr char kOfTest[] = "share_microcode_test";
constexpr int kReset = 0;
constexpr int kTick = 1;
constexpr int kShare = 2;
constexpr int kSamplesPort = 12;

assembler::Assembly share_microcode() {
    assembler::Assembly assembly;
    MicrocodeMachine::dispatch(assembly, {"reset", "share_tick", "share"});
    const std::string programs = std::string(RTL_DIR) + "/engine/programs/";
    assemble_source(programs + "ports.asm", assembly);
    assemble_source(programs + "share.asm", assembly);
    assembly.label("reset");
    assembly.put_starts();
    assemble_text(kOfTest, "return\n", assembly);
    assembly.finish();
    return assembly;
}

/// Draws samples of random increments with both; returns the number of words that differ.
class ShareComparison {
  public:
    ShareComparison(const assembler::Assembly& assembly, MicrocodeMachine& machine)
        : machine_(machine),
          tick_bound_(worst_case(assembly, "share_tick")),
          share_bound_(worst_case(assembly, "share")) {}

    int samples(int n, std::mt19937_64& random, int count) {
        machine_.ports().give = [n](int port, int) {
            return static_cast<std::int16_t>(port == kSamplesPort ? n : 0);
        };
        for (const char* word : {"left", "path_total"}) machine_.set(word, 12345);
        machine_.run(kReset);
        hls::SampleShare kernel(n);
        std::uint64_t path = 0;
        int differ = 0;
        for (int sample = 0; sample < count && differ == 0; ++sample) {
            differ += (machine_.get("left") == 0) == kernel.needs_tick() ? 0 : 1;
            if (kernel.needs_tick()) {
                const std::uint64_t most = (std::uint64_t{1} << 45) - 1;
                const auto ds = static_cast<std::int64_t>(random() % 5 == 0 ? most
                                                          : random() % 5 == 0
                                                              ? 0
                                                              : random() & most >> random() % 46);
                kernel.tick(ds);
                machine_.set("increment", ds);
                most_tick_ = std::max(most_tick_, machine_.run(kTick));
            }
            const std::int64_t ds = kernel.sample();
            most_share_ = std::max(most_share_, machine_.run(kShare));
            path += static_cast<std::uint64_t>(ds);
            differ += machine_.get("path_ds") == ds ? 0 : 1;
            differ += machine_.get_wide("path_total") == path ? 0 : 1;
            words_ += 3;
        }
        return differ + (most_tick_ > tick_bound_) + (most_share_ > share_bound_);
    }

    std::int64_t words() const { return words_; }
    bool near_bounds() const { return most_tick_ == tick_bound_ && most_share_ == share_bound_; }

  private:
    MicrocodeMachine& machine_;
    int tick_bound_;
    int share_bound_;
    int most_tick_ = 0;
    int most_share_ = 0;
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
    EXPECT_TRUE(comparison.near_bounds());
    EXPECT_FALSE(machine.hazard());
    std::printf("share_tick: at most %d clocks, share: %d\n", worst_case(assembly, "share_tick"),
                worst_case(assembly, "share"));
}

TEST(ShareMicrocode, AChangedInstructionIsSeen) {
    const assembler::Assembly assembly = share_microcode();
    const MutantShare share = seen_mutants(
        assembly, static_cast<std::size_t>(cases(3, 1)),
        [&](const std::vector<std::uint32_t>& program) {
            MicrocodeMachine machine(assembly, program);
            ShareComparison comparison(assembly, machine);
            std::mt19937_64 random(1);
            for (const int n : {2, 0, 6, 15, 4}) {
                if (comparison.samples(n, random, 300) > 0) return true;
            }
            return false;
        },
        [](const std::string& file) { return file != kOfTest; });
    EXPECT_EQ(share.deleted, "");
    EXPECT_GE(share.seen, 0.97 * share.mutants) << "of " << share.mutants;
}

}  // namespace
}  // namespace curvecore::tb
