// SPDX-License-Identifier: Apache-2.0
// The Verilated motion_board: bytes and clocks in, bytes and steps out.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sysc/core/core_parameters.hpp"
#include "sysc/link/slip.hpp"
#include "sysc/virtual/virtual_model.hpp"

namespace curvecore::sysc {

struct VirtualStep {
    std::uint64_t clock = 0;
    int axis = 0;
    bool back = false;
};

/// An edge of an output's pin; PWM is output 8.
struct VirtualEdge {
    std::uint64_t clock = 0;
    int output = 0;
    bool on = false;
};

/// Range of places of an axis, in steps from the start.
struct VirtualRange {
    int axis = 0;
    std::int64_t from = 0;
    std::int64_t to = 0;
};

/// The machine at the pins. Its encoders make one edge a step.
struct VirtualAxes {
    std::vector<VirtualRange> switches;  // ranges where home switches are closed
    bool limits = false;                 // home switches are limit switches too
    std::vector<VirtualRange> slips;     // ranges of counted places: steps to them move nothing
    double lag_s = 0;                    // lag of the encoders
    std::function<void(const VirtualEdge&)> edge;  // is called for every edge of an output
};

/// Times of a virtual board, which its build needs.
struct VirtualTimes {
    int period_log2;  // clocks of a sample period
    double clock_hz;
};

class VirtualBoard {
  public:
    static constexpr int kAxes = 3;
    static constexpr int kOutputs = 9;

    /// `step` is called for every rising edge of a step pin while the drives are on. A board is
    /// made when its build, or its table, is first asked for. An engine draws the table, if one is
    /// given, among lines, arcs and splines.
    /// @throws UsageError: another build; those of sysc/cache/core_cache.hpp
    VirtualBoard(std::function<void(const VirtualStep&)> step, VirtualAxes axes,
                 Build build = Build::kEngine,
                 std::shared_ptr<const ref::CurveTable> table = nullptr);

    /// Offers a frame to the board.
    void offer(const Bytes& frame);
    /// Returns true once all offered frames have gone in.
    bool taken() const;
    /// Advances by one clock. Returns the answer that it completed, if any.
    std::optional<Bytes> clock();
    std::uint64_t clocks() const { return model_->clocks; }
    bool drives_on() const { return model_->out.enable; }
    /// Returns where the axes are, in steps from the start.
    const std::array<std::int64_t, kAxes>& places() const { return places_; }
    const VirtualTimes& times() const { return times_; }

  private:
    struct Late {
        std::uint64_t clock;
        int axis;
        std::int64_t place;
    };

    void move(int axis, bool back);
    void set_switches();
    void set_encoders();

    VirtualTimes times_;
    std::unique_ptr<VirtualModel> model_;
    std::function<void(const VirtualStep&)> step_;
    VirtualAxes axes_;
    std::array<std::int64_t, kAxes> given_{};   // steps
    std::array<std::int64_t, kAxes> places_{};  // steps made
    std::array<std::int64_t, kAxes> edges_{};   // edges of encoders
    std::deque<Late> late_;
    std::deque<std::uint8_t> offered_;
    SlipDecoder answers_;
    unsigned steps_ = 0;    // levels of the pins
    unsigned outputs_ = 0;  // levels of the outputs
};

}  // namespace curvecore::sysc
