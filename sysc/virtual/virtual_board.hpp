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

#include "sysc/link/slip.hpp"

namespace curvecore::sysc {

struct VirtualStep {
    std::uint64_t clock = 0;
    int axis = 0;
    bool back = false;
};

/// Places of an axis, in steps from the start.
struct VirtualRange {
    int axis = 0;
    std::int64_t from = 0;
    std::int64_t to = 0;
};

/// The machine at the pins. Its encoders give an edge a step.
struct VirtualAxes {
    std::vector<VirtualRange> switches;  // home switches are closed there
    bool limits = false;                 // they are limit switches too
    std::vector<VirtualRange> slips;     // steps to these places, as they are counted, move nothing
    double lag_s = 0;                    // encoders are so late
};

class VirtualBoard {
  public:
    static constexpr int kAxes = 3;
    static constexpr int kPeriodLog2 = 8;
    static constexpr double kClockHertz = 2'560'000;

    /// `step` is called for every rising edge of a step pin while the drives are on.
    VirtualBoard(std::function<void(const VirtualStep&)> step, VirtualAxes axes);
    ~VirtualBoard();

    /// A frame that the board shall take.
    void offer(const Bytes& frame);
    /// All that was offered has gone in.
    bool taken() const;
    /// One clock; an answer that it completed.
    std::optional<Bytes> clock();
    std::uint64_t clocks() const;

  private:
    struct Model;

    struct Late {
        std::uint64_t clock;
        int axis;
        std::int64_t place;
    };

    void move(int axis, bool back);
    void set_switches();
    void set_encoders();

    std::unique_ptr<Model> model_;
    std::function<void(const VirtualStep&)> step_;
    VirtualAxes axes_;
    std::array<std::int64_t, kAxes> given_{};   // steps
    std::array<std::int64_t, kAxes> places_{};  // that were made
    std::array<std::int64_t, kAxes> edges_{};   // of encoders
    std::deque<Late> late_;
    std::deque<std::uint8_t> offered_;
    SlipDecoder answers_;
    unsigned steps_ = 0;  // levels of the pins
};

}  // namespace curvecore::sysc
