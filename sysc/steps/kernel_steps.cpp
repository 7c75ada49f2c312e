// SPDX-License-Identifier: Apache-2.0
// The step generator from event to event: equivalent to hls/step_generator.hpp, clock by clock.
#include <algorithm>

#include "sysc/steps/pulse_line.hpp"
#include "sysc/steps/step_block.hpp"
#include "sysc/steps/step_line.hpp"

namespace curvecore::sysc {
namespace {

/// An axis, hls::StepAxis, without the clocks between its events.
class KernelAxis {
  public:
    KernelAxis(int axis, const StepSetup& setup)
        : axis_(axis), line_(setup.period_log2), pulse_(setup.times) {}

    bool referenced() const { return referenced_; }
    StepFlags flags() const { return {pulse_.overrun(), refused_}; }

    /// Runs to the clock `end`, with a load on the clock before it; a null rate: no sample came.
    void run(std::uint64_t end, std::uint64_t load, const hls::StepRate* rate,
             std::vector<PinChange>& changes) {
        while (true) {
            const std::uint64_t pins =
                referenced_ || pulse_.step() ? std::max(next_, pulse_.next(back_)) : kNever;
            const std::uint64_t clock =
                std::min({next_ <= load ? load : kNever, turns_, carried_, due(), pins});
            if (clock >= end) return;
            this->clock(clock, changes);
            if (clock == load) this->load(clock, rate);
            next_ = clock + 1;
        }
    }

  private:
    /// Clock in which the pulse sees the next hit.
    std::uint64_t due() const { return line_.hit() == kNever ? kNever : line_.hit() + 1; }

    void clock(std::uint64_t clock, std::vector<PinChange>& changes) {
        if (clock == turns_) {
            back_ = !back_;
            turns_ = kNever;
        }
        const bool hit = clock == due() || clock == carried_;
        if (clock == due()) line_.take_hit();
        if (clock == carried_) carried_ = kNever;
        const bool step = pulse_.step();
        const bool direction = pulse_.direction();
        pulse_.clock(clock, hit && referenced_, referenced_ ? back_ : direction);
        if (pulse_.step() != step) changes.push_back({clock, axis_, Pin::kStep, !step});
        if (pulse_.direction() != direction) {
            changes.push_back({clock, axis_, Pin::kDirection, !direction});
        }
    }

    void load(std::uint64_t clock, const hls::StepRate* rate) {
        if (line_.load(clock, rate)) carried_ = clock + 1;
        if (rate == nullptr) return;
        // The direction is announced with the rate: hls::StepPhase shows it two clocks later.
        if (rate->moves && (rate->rate < 0) != back_) turns_ = clock + 2;
        if (rate->refused) pulse_.stop(clock);
        refused_ = !rate->fresh && (refused_ || rate->refused);
        referenced_ = !rate->refused && (referenced_ || rate->fresh);
    }

    int axis_;
    StepLine line_;
    PulseLine pulse_;
    std::uint64_t next_ = 0;  // first clock that is not over
    bool referenced_ = false;
    bool refused_ = false;
    bool back_ = false;
    std::uint64_t turns_ = kNever;    // clock in which back_ changes
    std::uint64_t carried_ = kNever;  // clock in which the pulse sees a hit of the rate before
};

class KernelSteps : public StepBlock {
  public:
    explicit KernelSteps(const StepSetup& setup)
        : period_(std::uint64_t(1) << setup.period_log2),
          scalers_(static_cast<std::size_t>(setup.axes),
                   hls::PlaceScaler(kStepFineBits, setup.period_log2)),
          loads_(scalers_.size()) {
        for (int a = 0; a < setup.axes; ++a) axes_.emplace_back(a, setup);
        for (hls::PlaceScaler& scaler : scalers_) scaler.set_scale(setup.scale);
    }

    void period(const std::int64_t* positions, std::vector<PinChange>& changes) override {
        const auto first = static_cast<std::ptrdiff_t>(changes.size());
        for (std::size_t a = 0; a < axes_.size(); ++a) {
            axes_[a].run(clock_ + period_, clock_ + a + 2, loaded_ ? &loads_[a] : nullptr, changes);
        }
        std::sort(changes.begin() + first, changes.end(), [](const auto& one, const auto& other) {
            return std::tie(one.clock, one.axis) < std::tie(other.clock, other.axis);
        });
        clock_ += period_;
        loaded_ = positions != nullptr;
        if (!loaded_) return;
        for (std::size_t a = 0; a < axes_.size(); ++a) {
            loads_[a] = scalers_[a].next(positions[a], fresh_, axes_[a].referenced());
        }
        fresh_ = false;
    }

    StepFlags flags(int axis) const override {
        return axes_[static_cast<std::size_t>(axis)].flags();
    }

  private:
    std::uint64_t period_;
    std::uint64_t clock_ = 0;
    std::vector<hls::PlaceScaler> scalers_;
    std::vector<hls::StepRate> loads_;
    std::vector<KernelAxis> axes_;
    bool loaded_ = false;
    bool fresh_ = true;
};

}  // namespace

std::unique_ptr<StepBlock> make_kernel_steps(const StepSetup& setup) {
    return std::make_unique<KernelSteps>(setup);
}

}  // namespace curvecore::sysc
