// SPDX-License-Identifier: Apache-2.0
// G-code to moves while it is read, in constant memory except for loops and calls.
#pragma once

#include "ref/gcode/blocks/program_flow.hpp"
#include "ref/gcode/interpreter/interpreter.hpp"
#include "ref/moves/block_stream.hpp"
#include "ref/program/gcode_options.hpp"

namespace curvecore::ref {

class GcodeStream : public BlockStream {
  public:
    /// @param text outlives this object
    GcodeStream(std::istream& text, const std::string& file, const GcodeOptions& options);

    std::optional<Dialect> dialect() const override { return flow_.dialect(); }
    void obey(const Obeyed& codes) override { interpreter_.obey(codes); }
    const Events& events() const override { return interpreter_.events(); }

  private:
    /// Modes that a call, or the program itself, has saved.
    struct Kept {
        std::optional<Interpreter::State> state;
        bool restores = false;  // when it returns
    };

    bool read() override;
    std::vector<Move> take(bool last) override;
    Program finish() override;

    void keep_modes(int code, const Place& place);
    void end_call();

    std::string file_;
    bool recognised_;
    ProgramParameters parameters_;
    Interpreter interpreter_;
    ProgramFlow flow_;
    std::vector<Kept> kept_{1};
};

}  // namespace curvecore::ref
