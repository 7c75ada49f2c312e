// SPDX-License-Identifier: Apache-2.0
// G-code to moves while it is read, in constant memory.
#pragma once

#include "ref/program/block_stream.hpp"
#include "ref/program/interpreter.hpp"
#include "ref/program/text_file.hpp"

namespace curvecore::ref {

class GcodeStream : public BlockStream {
  public:
    /// @param text outlives this object
    GcodeStream(std::istream& text, const std::string& file, double fit_tolerance)
        : file_(file), lines_(text), interpreter_(file, fit_tolerance, parameters_) {}

  private:
    bool read() override;
    std::vector<Move> take(bool last) override { return interpreter_.take(last); }
    Program finish() override { return interpreter_.finish(); }

    std::string file_;
    TextLines lines_;
    ProgramParameters parameters_;
    Interpreter interpreter_;
    bool framed_ = false;
    bool begun_ = false;
};

}  // namespace curvecore::ref
