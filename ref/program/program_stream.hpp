// SPDX-License-Identifier: Apache-2.0
// A part's file, whatever its kind, move by move: G-code in constant memory, points as a whole.
#pragma once

#include <memory>
#include <optional>

#include "ref/program/gcode_stream.hpp"
#include "ref/program/points_reader.hpp"

namespace curvecore::ref {

/// The name of the file that is read from standard input, as G-code.
constexpr const char* kStandardInput = "-";

/// Whether the extension is .csv, in upper or lower case.
bool is_points_file(const std::string& file);

class ProgramStream {
  public:
    /// By the extension, in upper or lower case: .ngc .nc .gcode .tap as G-code, .csv as points
    /// with `points`; or kStandardInput. @throws InputError
    ProgramStream(const std::string& file, const PointsOptions& points);

    /// The next move; false: there is none. @throws InputError
    bool next(Move& move);

    /// As it is called in messages.
    const std::string& file() const { return file_; }
    /// At the end.
    int aux_axes() const;
    const std::vector<std::string>& warnings() const;

  private:
    std::string file_;
    std::unique_ptr<std::istream> text_;
    std::optional<GcodeStream> gcode_;
    Program points_;
    std::size_t next_ = 0;
};

}  // namespace curvecore::ref
