// SPDX-License-Identifier: Apache-2.0
// A part's file of any kind, move by move: G-code in constant memory, points as a whole.
#pragma once

#include <array>
#include <fstream>
#include <functional>
#include <memory>

#include "ref/moves/move_source.hpp"
#include "ref/program/gcode_options.hpp"
#include "ref/program/points_reader.hpp"

namespace curvecore::ref {

/// Name of the file that means standard input, as G-code.
constexpr const char* kStandardInput = "-";

/// Extensions of G-code.
constexpr std::array<std::string_view, 14> kProgramKinds{".ngc", ".nc",  ".gcode", ".tap", ".ncf",
                                                         ".cnc", ".eia", ".mpf",   ".txt", ".gco",
                                                         ".gc",  ".g",   ".iso",   ".din"};

/// Returns true if the extension is .csv, in upper or lower case.
bool is_points_file(const std::string& file);

/// Opens G-code with another interpreter. @throws InputError
using OpenProgram = std::function<std::unique_ptr<MoveStream>(const std::string& file)>;

/// Whole program with all that its stream told.
struct HeldProgram : Program {
    Events events;
    std::optional<Dialect> dialect;
};

class ProgramStream : public MoveStream {
  public:
    /// Opens a file by its extension, in upper or lower case: .csv as points with `points`,
    /// kProgramKinds and none as G-code with `gcode`, or kStandardInput. `open` reads G-code if it
    /// is given. @throws InputError
    ProgramStream(const std::string& file, const PointsOptions& points,
                  const OpenProgram& open = {}, const GcodeOptions& gcode = {});
    /// Makes a stream of a whole program.
    explicit ProgramStream(HeldProgram program);

    bool next(Move& move) override;

    /// Name of the file in messages.
    const std::string& file() const { return file_; }
    std::optional<Dialect> dialect() const override;
    int aux_axes() const override;
    const std::vector<std::string>& warnings() const override;
    const Events& events() const override;
    /// Reads all of it. @throws InputError
    HeldProgram held();

  private:
    std::string file_;
    std::unique_ptr<std::istream> text_;
    std::unique_ptr<MoveStream> gcode_;
    HeldProgram whole_;  // the program if there is no such stream
    std::size_t next_ = 0;
};

}  // namespace curvecore::ref
