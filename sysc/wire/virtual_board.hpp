// SPDX-License-Identifier: Apache-2.0
// The Verilated motion_board: bytes and clocks in, bytes and steps out.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "sysc/wire/slip.hpp"

namespace curvecore::sysc {

struct VirtualStep {
    std::uint64_t clock = 0;
    int axis = 0;
    bool back = false;
};

class VirtualBoard {
  public:
    static constexpr int kAxes = 3;
    static constexpr int kPeriodLog2 = 8;
    static constexpr double kClockHertz = 2'560'000;

    /// `step` is called for every rising edge of a step pin while the drives are on.
    explicit VirtualBoard(std::function<void(const VirtualStep&)> step);
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
    std::unique_ptr<Model> model_;
    std::function<void(const VirtualStep&)> step_;
    std::deque<std::uint8_t> offered_;
    SlipDecoder answers_;
    unsigned steps_ = 0;  // levels of the pins
};

}  // namespace curvecore::sysc
