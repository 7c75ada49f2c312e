// SPDX-License-Identifier: Apache-2.0
// A virtual board behind UDP: a datagram is a frame or an answer.
//
// The board has one master, the first host that writes, until it is silent for 1 s of the board;
// from others it takes frames that only read. A fast board's time passes with frames alone: while
// its drives are off, it lets a silent master go once it has refused 8 frames of others.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sysc/virtual/virtual_board.hpp"

namespace curvecore::sysc {

struct BoardServerOptions {
    std::string address;  // ADDRESS[:PORT]; port 0: any free port
    /// Fast clock: only frames, of any host, advance it, by 5 ms each, so no step depends on the
    /// computer's load. Otherwise the clock follows real time.
    bool fast = false;
    VirtualAxes axes;
    Build build = Build::kEngine;
    std::shared_ptr<const ref::CurveTable> table = nullptr;  // null: none
};

class BoardServer {
  public:
    /// @throws UsageError: no such address, or it is in use
    BoardServer(const BoardServerOptions& options, std::function<void(const VirtualStep&)> step);
    ~BoardServer();

    /// Returns ADDRESS:PORT.
    std::string where() const;
    /// Works for a while: frames, clocks, answers.
    void work();

    const VirtualBoard& board() const;
    std::uint64_t clocks() const { return board().clocks(); }
    const VirtualTimes& times() const { return board().times(); }
    /// Ratio of the clocks made to the clocks of real time.
    double pace() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace curvecore::sysc
