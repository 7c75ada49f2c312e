// SPDX-License-Identifier: Apache-2.0
#include "ref/program/program_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <utility>

#include "ref/program/gcode_stream.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

std::string kind_of(const std::string& file) {
    std::string kind = std::filesystem::path(file).extension().string();
    std::transform(kind.begin(), kind.end(), kind.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return kind;
}

}  // namespace

bool is_points_file(const std::string& file) { return kind_of(file) == ".csv"; }

ProgramStream::ProgramStream(const std::string& file, const PointsOptions& points,
                             const OpenProgram& open, const GcodeOptions& gcode)
    : file_(file) {
    GcodeOptions options = gcode;
    options.fit_tolerance = points.fit_tolerance;
    if (file == kStandardInput) {
        file_ = "stdin";
        gcode_ = std::make_unique<GcodeStream>(std::cin, file_, options);
        gcode_->obey(gcode.obeyed);
        return;
    }
    if (is_points_file(file)) {
        whole_ = {read_points(file, points), {}, {}};
        return;
    }
    const std::string kind = kind_of(file);
    if (!kind.empty() &&
        std::find(kProgramKinds.begin(), kProgramKinds.end(), kind) == kProgramKinds.end()) {
        throw InputError(file, 0,
                         fmt::format("unknown kind of file: {} are read as G-code, .csv as points; "
                                     "- reads standard input",
                                     fmt::join(kProgramKinds, " ")));
    }
    text_ = std::make_unique<std::ifstream>(open_text_file(file));
    gcode_ = open ? open(file) : std::make_unique<GcodeStream>(*text_, file, options);
    gcode_->obey(gcode.obeyed);
}

ProgramStream::ProgramStream(HeldProgram program)
    : file_(program.file), whole_(std::move(program)) {}

bool ProgramStream::next(Move& move) {
    if (gcode_) return gcode_->next(move);
    if (next_ == whole_.moves.size()) return false;
    move = whole_.moves[next_++];
    return true;
}

std::optional<Dialect> ProgramStream::dialect() const {
    return gcode_ ? gcode_->dialect() : whole_.dialect;
}

int ProgramStream::aux_axes() const { return gcode_ ? gcode_->aux_axes() : whole_.aux_axes; }

const std::vector<std::string>& ProgramStream::warnings() const {
    return gcode_ ? gcode_->warnings() : whole_.warnings;
}

const Events& ProgramStream::events() const { return gcode_ ? gcode_->events() : whole_.events; }

HeldProgram ProgramStream::held() {
    Program program = read_all(*this, file_);
    return {std::move(program), events(), dialect()};
}

}  // namespace curvecore::ref
