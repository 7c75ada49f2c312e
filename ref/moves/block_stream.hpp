// SPDX-License-Identifier: Apache-2.0
// A program that is executed block by block, with a few moves ahead.
#pragma once

#include <deque>
#include <exception>

#include "ref/moves/move_source.hpp"

namespace curvecore::ref {

class BlockStream : public MoveStream {
  public:
    bool next(Move& move) override;
    int aux_axes() const override { return aux_axes_; }
    const std::vector<std::string>& warnings() const override { return warnings_; }

  private:
    /// Executes the next block; returns false if the program ends with it. @throws InputError
    virtual bool read() = 0;
    /// Returns the finished moves, as MoveList gives them.
    virtual std::vector<Move> take(bool last) = 0;
    virtual Program finish() = 0;

    std::deque<Move> moves_;
    int aux_axes_ = 0;
    std::vector<std::string> warnings_;
    bool ended_ = false;
    std::exception_ptr error_;
};

}  // namespace curvecore::ref
