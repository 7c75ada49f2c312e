// SPDX-License-Identifier: Apache-2.0
// G-code to moves while it is read, in constant memory.
#pragma once

#include <deque>
#include <exception>

#include "ref/program/interpreter.hpp"
#include "ref/program/text_file.hpp"

namespace curvecore::ref {

class GcodeStream {
  public:
    /// @param text outlives this object
    GcodeStream(std::istream& text, const std::string& file, double fit_tolerance);

    /// The next move; false: there is none.
    /// @throws InputError of a block, after all moves of the blocks before it
    bool next(Move& move);

    /// At the end.
    int aux_axes() const { return aux_axes_; }
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    void read_block();
    void take(bool last);

    std::string file_;
    TextLines lines_;
    Interpreter interpreter_;
    std::deque<Move> moves_;
    int aux_axes_ = 0;
    std::vector<std::string> warnings_;
    bool framed_ = false;
    bool begun_ = false;
    bool ended_ = false;
    std::exception_ptr error_;
};

}  // namespace curvecore::ref
