// SPDX-License-Identifier: Apache-2.0
// Rates of samples, rtl/engine/programs/places.asm, are those of hls::PlaceScaler: of programs and
// of a host, over resets, for every width.
#include <gtest/gtest.h>

#include <cmath>

#include "hls/place_scaler.hpp"
#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "rtl/engine/compiler/places_assembler.hpp"
#include "tb/support/microcode/microcode_machine.hpp"
#include "tb/support/microcode/microcode_mutants.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::places_microcode_test {

constexpr char kOfTest[] = "places_microcode_test";
constexpr int kReset = 0;
constexpr int kPutSample = 1;
constexpr int kPutPosition = 2;

// Ports, rtl/engine/programs/ports.asm
constexpr int kScaleLow = 24;
constexpr int kScaleHigh = 25;
constexpr int kPositionIn = 26;
constexpr int kReferences = 27;
constexpr int kPlacing = 17;
constexpr int kRate = 19;
constexpr int kUnmoved = 20;
constexpr int kMovedOn = 21;
constexpr int kStandsAt = 22;
constexpr int kRefused = 23;
constexpr int kRefusedMove = 24;
constexpr int kSampleWhole = 25;

struct PlaceCase {
    int position_bits = 32;
    int guard_bits = 10;
    int aux_axes = 0;
    int period_log2 = 13;
    int scale_bits = 44;
};

ref::CoreParameters core_of(const PlaceCase& of) {
    ref::CoreParameters core;
    core.position_bits = of.position_bits;
    core.guard_bits = of.guard_bits;
    core.aux_axes = of.aux_axes;
    return core;
}

assembler::Assembly places_microcode(const PlaceCase& of) {
    assembler::StoreSize size;
    if (of.aux_axes > 0) size.data = 512;
    assembler::Assembly assembly(size);
    MicrocodeMachine::dispatch(assembly, {"reset", "put_sample", "put_position"});
    const std::string programs = std::string(RTL_DIR) + "/engine/programs";
    assemble_source(programs + "/ports.asm", assembly);
    assemble_places(programs, core_of(of), hls::kStepFraction + of.period_log2, assembly);
    assemble_text(kOfTest, "reset:\n", assembly);
    assembly.put_starts();
    assemble_text(kOfTest, "go to read_scales\n", assembly);
    assembly.finish();
    return assembly;
}

/// Samples of both, one after the other.
class PlaceComparison {
  public:
    PlaceComparison(const PlaceCase& of, MicrocodeMachine& machine, std::uint32_t seed)
        : of_(of),
          machine_(machine),
          random_(seed),
          scalers_(static_cast<std::size_t>(axes()), hls::PlaceScaler(fine_bits(), of.period_log2)),
          scales_(scalers_.size()),
          positions_(scalers_.size()) {
        machine_.ports().give = [this](int port, int limb) { return given(port, limb); };
        machine_.ports().take = [this](int port, int limb, std::int16_t value) {
            taken(port, limb, value);
        };
    }
    PlaceComparison(const PlaceComparison&) = delete;

    /// A reset and so many samples of a program, or of a host; returns the number of words that
    /// differ.
    int program(int samples, bool host) {
        axis_ = 0;
        for (int axis = 0; axis < axes(); ++axis) {
            if (random_() % 4 != 0 && scales_[of(axis)] != 0) continue;
            const int less = random_() % 2 == 0 ? 0 : static_cast<int>(random_() % 20);
            scales_[of(axis)] =
                1 + static_cast<std::int64_t>(random_() >> (64 - of_.scale_bits + less));
            if (random_() % 8 == 0) scales_[of(axis)] = (std::int64_t{1} << of_.scale_bits) - 1;
            if (random_() % 8 == 0) scales_[of(axis)] = kept_units();
            scalers_[of(axis)].set_scale(scales_[of(axis)]);
        }
        run(kReset);
        differ_ = axis_ == 0 ? 0 : 1;
        references_ = ready_ ? random_() : ~std::uint64_t{0};
        ready_ = true;
        for (int sample = 0; sample < samples && differ_ == 0; ++sample) {
            draw(host, sample == 0);
            if (sample == 0) references_ = random_();  // is not asked again
        }
        return differ_;
    }

    std::int64_t words() const { return words_; }
    int most_clocks(int program) const { return most_[program]; }
    int refused() const { return refused_; }

  private:
    static std::size_t of(int axis) { return static_cast<std::size_t>(axis); }
    int axes() const { return 3 + of_.aux_axes; }
    int fine_bits() const { return of_.position_bits + of_.guard_bits; }
    bool fresh(int axis) const { return (references_ >> axis & 1) != 0; }

    /// Scale whose places are positions.
    std::int64_t kept_units() const {
        return std::int64_t{1} << std::min(fine_bits(), of_.scale_bits - 1);
    }

    void draw(bool host, bool first) {
        std::vector<hls::StepRate> rates;
        for (int axis = 0; axis < axes(); ++axis) {
            positions_[of(axis)] = moved(axis, first, host);
            rates.push_back(scalers_[of(axis)].next(positions_[of(axis)], first && fresh(axis),
                                                    true, first && !host));
            if (!host) {
                machine_.set(axis < 3 ? "fine[k]" : "fine[" + std::to_string(axis) + "]",
                             positions_[of(axis)], axis < 3 ? axis : 0);
            }
        }
        placing_ = 0;
        axis_ = 0;
        rates_.assign(rates.size(), 0);
        kinds_.assign(rates.size(), -1);
        wholes_ = 0;
        machine_.spoil_locals(random_);
        run(host ? kPutPosition : kPutSample);
        const std::int64_t mask = (std::int64_t{1} << (hls::kStepFraction + of_.period_log2)) - 1;
        for (std::size_t axis = 0; axis < rates.size(); ++axis) {
            const hls::StepRate& rate = rates[axis];
            const int kind = rate.refused ? (rate.moves ? kRefusedMove : kRefused)
                             : rate.fresh ? kStandsAt
                                          : (rate.moves ? kMovedOn : kUnmoved);
            differ_ += kinds_[axis] == kind ? 0 : 1;
            differ_ += ((rates_[axis] ^ rate.rate) & mask) == 0 ? 0 : 1;
            refused_ += rate.refused ? 1 : 0;
            words_ += 2;
        }
        differ_ += placing_ == 1 && axis_ == axes() && wholes_ == (host ? 1 : 0) ? 0 : 1;
    }

    /// A position near the last one, or where its rate is the least that is refused.
    std::int64_t moved(int axis, bool first, bool host) {
        const std::int64_t half = std::int64_t{1} << (fine_bits() - 1);
        const int log2 = first && random_() % 2 == 0 ? hls::kStepFraction
                                                     : hls::kStepFraction + of_.period_log2 - 1;
        const double least = std::ldexp(1.0, fine_bits() + log2) / double(scales_[of(axis)]);
        std::int64_t by = 0;
        const std::uint64_t kind = random_() % 8;
        if (kind < 4 && least < double(half))
            by = std::llround(least) - 2 + std::int64_t(random_() % 5);
        if (kind == 4) by = static_cast<std::int64_t>(random_() >> (64 - fine_bits()));
        if (kind > 4)
            by = static_cast<std::int64_t>(random_() >> 1 >> (63 - fine_bits() + random_() % 42));
        if (kind == 5 && scales_[of(axis)] == kept_units()) {  // its rate is 0
            by = std::int64_t{1} << (hls::kStepFraction + of_.period_log2);
        }
        std::int64_t to = positions_[of(axis)] + (random_() % 2 == 0 ? by : -by);
        if (random_() % 64 == 0) to = random_() % 2 == 0 ? -half : half - 1;
        to = ((to + half) & (2 * half - 1)) - half;
        return host ? to & ~((std::int64_t{1} << of_.guard_bits) - 1) : to;
    }

    std::int16_t given(int port, int limb) {
        if (port == kReferences) return static_cast<std::int16_t>(reversed());
        std::int64_t word = 0;
        if (port == kPositionIn && of(axis_) < positions_.size()) {
            word = positions_[of(axis_)] >> of_.guard_bits;
        }
        if ((port == kScaleLow || port == kScaleHigh) && of(axis_) < scales_.size()) {
            const std::int64_t scale = scales_[of(axis_)];
            word = port == kScaleLow ? scale & 0xffffffff : scale >> 32;
        }
        if (port == kScaleHigh && limb == 2) axis_ = (axis_ + 1) % axes();
        const std::int64_t high = word >> 30;
        return static_cast<std::int16_t>(limb == 2 ? high : word >> (15 * limb) & 0x7fff);
    }
    std::uint64_t reversed() const {
        std::uint64_t mask = 0;
        for (int axis = 0; axis < axes(); ++axis) mask |= std::uint64_t{fresh(axis)} << (13 - axis);
        return mask;
    }

    void taken(int port, int limb, std::int16_t value) {
        if (port == kPlacing) placing_ += axis_ == 0 && value == 0 ? 1 : 2;
        if (port == kSampleWhole) wholes_ += value == 0 ? 1 : 2;
        if (port < kRate || port > kRefusedMove) return;
        if (of(axis_) >= kinds_.size()) throw std::runtime_error("more rates than axes");
        if (port != kRate) kinds_[of(axis_)] = value == 0 ? port : -1;
        if (port == kRate && limb < 2) {
            rates_[of(axis_)] |= std::int64_t{value} << (15 * limb);
            if (limb == 1) ++axis_;
        }
    }

    void run(int program) { most_[program] = std::max(most_[program], machine_.run(program)); }

    PlaceCase of_;
    MicrocodeMachine& machine_;
    std::mt19937_64 random_;
    std::vector<hls::PlaceScaler> scalers_;
    std::vector<std::int64_t> scales_, positions_, rates_;
    std::vector<int> kinds_;
    std::uint64_t references_ = 0;
    bool ready_ = false;
    int axis_ = 0;
    int placing_ = 0;
    int wholes_ = 0;
    int differ_ = 0;
    int refused_ = 0;
    int most_[3] = {};
    std::int64_t words_ = 0;
};

const std::vector<PlaceCase> kCases{
    {32, 10, 0, 13, 44}, {32, 12, 6, 12, 45}, {16, 2, 1, 6, 40}, {24, 6, 0, 10, 45}};

TEST(PlacesMicrocode, EqualsTheKernel) {
    for (const PlaceCase& of : kCases) {
        const assembler::Assembly assembly = places_microcode(of);
        MicrocodeMachine machine(assembly);
        PlaceComparison comparison(of, machine, 1);
        std::mt19937_64 random(2);
        int differ = 0;
        for (int n = 0; n < cases(4000, 100000) && differ == 0; ++n) {
            differ = comparison.program(1 + static_cast<int>(random() % 10), random() % 3 == 0);
        }
        EXPECT_EQ(differ, 0) << of.position_bits;
        EXPECT_GT(comparison.words(), 100000);
        EXPECT_GT(20 * comparison.refused(), comparison.words() / 2);
        for (const auto& [program, label] :
             {std::pair{kPutSample, "put_sample"}, std::pair{kPutPosition, "put_position"}}) {
            const int bound = assembler::worst_case(assembly, label);
            EXPECT_LE(comparison.most_clocks(program), bound) << label;
            EXPECT_GE(comparison.most_clocks(program), 0.97 * bound) << label;
            std::printf("%d axes: %lld words, %s %d clocks\n", 3 + of.aux_axes,
                        static_cast<long long>(comparison.words()), label, bound);
        }
        EXPECT_FALSE(machine.hazard());
        EXPECT_FALSE(machine.strays());
    }
}

TEST(PlacesMicrocode, AChangedInstructionIsSeen) {
    const PlaceCase& of = kCases[1];
    const assembler::Assembly assembly = places_microcode(of);
    const MutantShare share = seen_mutants(
        assembly, static_cast<std::size_t>(cases(3, 1)),
        [&](const std::vector<std::uint32_t>& program, MicrocodeTrace& trace) {
            MicrocodeMachine machine(assembly, program, &trace);
            PlaceComparison comparison(of, machine, 3);
            std::mt19937_64 random(4);
            for (int n = 0; n < 200; ++n) {
                if (comparison.program(1 + static_cast<int>(random() % 4), n % 3 == 0)) {
                    return true;
                }
            }
            return machine.strays();
        },
        [](const std::string& file) { return file != kOfTest; });
    EXPECT_EQ(share.deleted, "");
    share.expect(0.99);
}

}  // namespace curvecore::tb::places_microcode_test
