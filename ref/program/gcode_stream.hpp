// SPDX-License-Identifier: Apache-2.0
// G-code to moves while it is read: in constant memory but for loops and calls.
#pragma once

#include "ref/program/block_stream.hpp"
#include "ref/program/interpreter.hpp"
#include "ref/program/program_flow.hpp"

namespace curvecore::ref {

class GcodeStream : public BlockStream {
  public:
    /// @param text outlives this object
    GcodeStream(std::istream& text, const std::string& file, double fit_tolerance);

  private:
    bool read() override;
    std::vector<Move> take(bool last) override;
    Program finish() override { return interpreter_.finish(); }

    std::string file_;
    ProgramParameters parameters_;
    Interpreter interpreter_;
    ProgramFlow flow_;
};

}  // namespace curvecore::ref
