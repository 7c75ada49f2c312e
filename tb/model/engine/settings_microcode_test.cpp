// SPDX-License-Identifier: Apache-2.0
// Settings, rtl/engine/programs/settings.asm, are taken and judged as by hls::MotionSettings,
// whatever is asked for, under way or queued; an instruction deleted or a field changed is seen.
#include <gtest/gtest.h>

#include "hls/motion_settings.hpp"
#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "tb/support/microcode/microcode_machine.hpp"
#include "tb/support/microcode/microcode_mutants.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::settings_microcode_test {

constexpr char kOfTest[] = "settings_microcode_test";
constexpr int kReset = 0;
constexpr int kSettings = 1;

assembler::Assembly settings_microcode() {
    assembler::Assembly assembly;
    MicrocodeMachine::dispatch(assembly, {"reset", "look"});
    assemble_text(kOfTest,
                  "word begun others back\n"
                  "time_begins:\n"
                  "begun = begun + 1\n"
                  "return\n"
                  "look:\n"
                  "back = port 2, 1 limb\n"
                  "call settings\n"
                  "port 2 = back, 1 limb\n"
                  "if not negative return\n"
                  "others = others + 1\n"
                  "go to take_settings\n",
                  assembly);
    const std::string programs = std::string(RTL_DIR) + "/engine/programs/";
    assemble_source(programs + "ports.asm", assembly);
    assemble_source(programs + "settings.asm", assembly);
    assembly.label("reset");
    assembly.put_starts();
    assemble_text(kOfTest, "return\n", assembly);
    assembly.finish();
    return assembly;
}

/// The class and the twin, look by look.
class SettingsComparison {
  public:
    SettingsComparison(const assembler::Assembly& assembly, MicrocodeMachine& machine)
        : machine_(machine), bound_(worst_case(assembly, "look")) {
        machine_.ports().give = [this](int port, int limb) {
            const std::int64_t value = port == 11   ? asked_.samples_per_tick_log2
                                       : port == 12 ? asked_.hold_acceleration
                                       : port == 13 ? asked_.hold_slope
                                       : port == 14 ? asked_.stop_ticks
                                                    : 0;
            return static_cast<std::int16_t>(value >> (15 * limb) & 0x7fff);
        };
        machine_.ports().take = [this](int port, int, std::int16_t) {
            reported_ = reported_ || port == 11;  // it stays up
        };
    }
    SettingsComparison(const SettingsComparison&) = delete;

    /// Looks, from a reset on; returns the number of words that differ.
    int looks(std::mt19937_64& random, int count) {
        machine_.reset(kReset);
        reported_ = false;
        hls::MotionSettings settings;
        int differ = 0;
        for (int n = 0; n < count && differ == 0; ++n) {
            if (n == 0 || random() % 3 == 0) change(random);
            const bool active = n > 0 && random() % 4 == 0;
            const bool next = random() % 4 == 0;
            const auto pieces = static_cast<std::int64_t>(random() % 3 == 0 ? random() % 1000 : 0);
            machine_.set("active", active ? 1 : 0);
            machine_.set("next", next ? 1 : 0);
            machine_.set("pieces", pieces);
            machine_.set("begun", 0);
            machine_.set("others", 0);
            machine_.spoil_locals(random);
            most_ = std::max(most_, machine_.run(kSettings));
            const bool taken = settings.look(asked_, active, next || pieces > 0);
            differ += machine_.get("begun") != (taken ? 1 : 0) ? 1 : 0;
            differ += machine_.get("others") != (taken ? 1 : 0) ? 1 : 0;
            differ += machine_.get("good") != (settings.good() ? 1 : 0) ? 1 : 0;
            differ += reported_ != settings.fault() ? 1 : 0;
            const hls::TimeSettings& now = settings.taken();
            differ += machine_.get("samples_per_tick") != now.samples_per_tick_log2 ? 1 : 0;
            differ += machine_.get("hold_acceleration") != now.hold_acceleration ? 1 : 0;
            differ += machine_.get("hold_slope") != now.hold_slope ? 1 : 0;
            differ += machine_.get("stop_ticks") != now.stop_ticks ? 1 : 0;
            differ += machine_.get("twice_stop") != 2 * now.stop_ticks ? 1 : 0;
            words_ += 9;
            good_ += settings.good() ? 1 : 0;
            faults_ += settings.fault() ? 1 : 0;
        }
        return differ + (most_ > bound_ ? 1 : 0);
    }

    std::int64_t words() const { return words_; }
    int good() const { return good_; }
    int faults() const { return faults_; }
    int most() const { return most_; }
    int bound() const { return bound_; }

  private:
    /// Asks for others, near the ends of their ranges at times.
    void change(std::mt19937_64& random) {
        const auto any = [&](int bits) {
            return static_cast<std::int64_t>(random() >> (64 - bits) >> random() % bits);
        };
        const auto near = [&](std::int64_t end, int bits) {
            const std::int64_t value =
                random() % 3 != 0 ? any(bits) : end - 2 + static_cast<std::int64_t>(random() % 5);
            return std::max<std::int64_t>(value, 0);
        };
        if (random() % 4 == 0) {  // a bit alone
            (random() % 3 == 0   ? asked_.hold_acceleration
             : random() % 2 == 0 ? asked_.hold_slope
                                 : asked_.stop_ticks) ^= std::int64_t{1} << random() % 32;
            return;
        }
        const bool all = random() % 2 == 0;
        if (all || random() % 4 == 0)
            asked_.samples_per_tick_log2 = static_cast<int>(random() % 16);
        if (all || random() % 4 == 0) {
            asked_.hold_acceleration = near(random() % 2 == 0 ? 8 : std::int64_t{1} << 31, 32);
        }
        if (all || random() % 4 == 0) {
            asked_.hold_slope =
                near(random() % 2 == 0 ? asked_.hold_acceleration : std::int64_t{1} << 32, 33);
        }
        if (all || random() % 4 == 0) {
            asked_.stop_ticks = near(random() % 2 == 0 ? 0 : std::int64_t{1} << 29, 32);
        }
    }

    MicrocodeMachine& machine_;
    hls::TimeSettings asked_;
    std::int64_t words_ = 0;
    bool reported_ = false;
    int bound_;
    int most_ = 0;
    int good_ = 0;
    int faults_ = 0;
};

TEST(SettingsMicrocode, AreTakenAndJudgedAsByTheKernel) {
    const assembler::Assembly assembly = settings_microcode();
    MicrocodeMachine machine(assembly);
    SettingsComparison comparison(assembly, machine);
    std::mt19937_64 random(1);
    for (int n = 0; n < cases(1000, 100000); ++n) ASSERT_EQ(comparison.looks(random, 20), 0) << n;
    EXPECT_GT(comparison.words(), 100000);
    EXPECT_GT(comparison.good(), 2000);
    EXPECT_GT(comparison.faults(), 2000);
    EXPECT_GE(comparison.most(), comparison.bound() - 9);  // others are asked for, or nothing is
    EXPECT_LE(comparison.bound(), 300);
    EXPECT_FALSE(machine.hazard());
    EXPECT_FALSE(machine.strays());
}

TEST(SettingsMicrocode, AChangedInstructionIsSeen) {
    const assembler::Assembly assembly = settings_microcode();
    const MutantShare share = seen_mutants(
        assembly, static_cast<std::size_t>(cases(7, 1)),
        [&](const std::vector<std::uint32_t>& program, MicrocodeTrace& trace) {
            MicrocodeMachine machine(assembly, program, &trace);
            SettingsComparison comparison(assembly, machine);
            std::mt19937_64 random(1);
            int differ = 0;
            for (int n = 0; n < 200 && differ == 0; ++n) differ = comparison.looks(random, 20);
            return differ > 0 || machine.strays() || !machine.starts_hold();
        },
        [](const std::string& file) { return file != kOfTest; });
    EXPECT_EQ(share.deleted, "");
    share.expect(0.99);
}

}  // namespace curvecore::tb::settings_microcode_test
