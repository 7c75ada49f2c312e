// SPDX-License-Identifier: Apache-2.0
// A virtual board behind UDP: a datagram is a frame, and an answer.
//
// It has one master, the first that writes, until that is silent; of others it takes frames that
// only read.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sysc/virtual/virtual_board.hpp"

namespace curvecore::sysc {

struct BoardServerOptions {
    std::string address;  // ADDRESS[:PORT]; port 0: any that is free
    /// Each frame that it takes, of whomever, gives the clock 5 ms, and nothing else does: no step
    /// depends on how busy the computer is. Otherwise the clock goes as the wall's does.
    bool fast = false;
    VirtualAxes axes;
};

class BoardServer {
  public:
    /// @throws UsageError: no such address, or it is taken
    BoardServer(const BoardServerOptions& options, std::function<void(const VirtualStep&)> step);
    ~BoardServer();

    /// ADDRESS:PORT
    std::string where() const;
    /// A while of work: frames, clocks, answers.
    void work();

    std::uint64_t clocks() const;
    /// Clocks that passed against those that time asked for.
    double pace() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace curvecore::sysc
