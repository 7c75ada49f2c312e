// SPDX-License-Identifier: Apache-2.0
// A part's file, whatever its kind, move by move: G-code in constant memory, points as a whole.
#pragma once

#include <array>
#include <fstream>
#include <functional>
#include <memory>

#include "ref/moves/move_source.hpp"
#include "ref/program/gcode_options.hpp"
#include "ref/program/points_reader.hpp"

namespace curvecore::ref {

/// The name of the file that is read from standard input, as G-code.
constexpr const char* kStandardInput = "-";

/// Extensions of G-code.
constexpr std::array<std::string_view, 14> kProgramKinds{".ngc", ".nc",  ".gcode", ".tap", ".ncf",
                                                         ".cnc", ".eia", ".mpf",   ".txt", ".gco",
                                                         ".gc",  ".g",   ".iso",   ".din"};

/// Whether the extension is .csv, in upper or lower case.
bool is_points_file(const std::string& file);

/// Reads G-code from a file by somebody else's interpreter. @throws InputError
using OpenProgram = std::function<std::unique_ptr<MoveStream>(const std::string& file)>;

class ProgramStream : public MoveStream {
  public:
    /// By the extension, in upper or lower case: .csv as points with `points`, kProgramKinds and
    /// none as G-code, as `gcode` says; or kStandardInput. With `open`,
    /// G-code is read by that. @throws InputError
    ProgramStream(const std::string& file, const PointsOptions& points,
                  const OpenProgram& open = {}, const GcodeOptions& gcode = {});
    /// Of one that is there.
    explicit ProgramStream(Program program);

    bool next(Move& move) override;

    /// As it is called in messages.
    const std::string& file() const { return file_; }
    std::optional<Dialect> dialect() const override;
    int aux_axes() const override;
    const std::vector<std::string>& warnings() const override;
    Events events() const override;

  private:
    std::string file_;
    std::unique_ptr<std::istream> text_;
    std::unique_ptr<MoveStream> gcode_;
    Program whole_;  // where there is no such stream
    std::size_t next_ = 0;
};

}  // namespace curvecore::ref
