// SPDX-License-Identifier: Apache-2.0
// A program as LinuxCNC's own interpreter reads it: sysc/linuxcnc/interpret.py runs it in a
// separate process and prints canonical moves as JSON lines, which sysc/linuxcnc/README.md
// describes.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ref/gcode/interpreter/canonical_moves.hpp"
#include "ref/moves/block_stream.hpp"
#include "sysc/cli/child_process.hpp"

namespace curvecore::sysc {

/// A temporary folder, removed with this object.
class ScratchFolder {
  public:
    /// Creates the folder. @throws std::runtime_error
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

class LinuxcncProgram : public ref::BlockStream {
  public:
    /// @param command prints the lines when it is called with the file and `--scratch FOLDER`
    LinuxcncProgram(std::vector<std::string> command, const std::string& file,
                    double fit_tolerance);

    void obey(const ref::Obeyed& codes) override { moves_.obey(codes); }
    const ref::Events& events() const override { return moves_.events(); }

  private:
    bool read() override;
    std::vector<ref::Move> take(bool last) override { return moves_.take(last); }
    ref::Program finish() override { return moves_.finish(); }

    /// Carries out a call. Returns false at the end. @throws ref::InputError,
    /// nlohmann::json::exception
    bool carry_out(const nlohmann::json& call);
    /// Throws the reason why no more lines come.
    [[noreturn]] void refuse_end();

    ScratchFolder scratch_;
    ChildProcess interpreter_;
    ref::CanonicalMoves moves_;
    int lines_ = 0;
};

/// Files of a machine; empty: none.
struct LinuxcncMachine {
    std::string ini;
    std::string tools;  // replaces the tool table of the .ini
};

/// Opens a program with the interpreter that is shipped, or with the command CURVECORE_LINUXCNC.
std::unique_ptr<ref::MoveStream> open_linuxcnc(const std::string& file,
                                               const LinuxcncMachine& machine,
                                               double fit_tolerance);

}  // namespace curvecore::sysc
