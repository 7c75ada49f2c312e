// SPDX-License-Identifier: Apache-2.0
#include "ref/cam/cam_program.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

namespace curvecore::ref {
namespace {

constexpr std::size_t kBuffer = std::size_t(1) << 16;

}  // namespace

double surface_length(const CamPiece& piece) {
    const double turn = (piece.to.angle - piece.from.angle) * M_PI / 180;
    return std::hypot((piece.from.rho + piece.to.rho) / 2 * turn, piece.to.rho - piece.from.rho,
                      piece.to.x - piece.from.x);
}

CamProgram::CamProgram(const std::string& file, double feed,
                       const std::vector<std::string>& remarks)
    : file_(std::fopen(file.c_str(), "wb"), &std::fclose), feed_(feed) {
    if (!file_) throw std::runtime_error("cannot write " + file);
    for (const std::string& remark : remarks) buffer_ += "; " + remark + "\n";
    buffer_ += "G21 G90 G94 G64\n";
}

void CamProgram::piece(const CamPiece& piece) {
    auto out = std::back_inserter(buffer_);
    if (pieces_ == 0) {
        fmt::format_to(out, "G0 X{:.6f} Z{:.6f} A{:.6f}\nG93\n", piece.from.rho, piece.from.x,
                       piece.from.angle);
    }
    fmt::format_to(out, "G1 X{:.6f} Z{:.6f} A{:.6f} F{:.6f}\n", piece.to.rho, piece.to.x,
                   piece.to.angle, 60 * feed_ / surface_length(piece));
    ++pieces_;
    if (buffer_.size() >= kBuffer) flush();
}

void CamProgram::flush() {
    if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size()) {
        throw std::runtime_error("cannot write the program: is the disk full?");
    }
    buffer_.clear();
}

void CamProgram::close() {
    buffer_ += "G94\nM2\n";
    flush();
    if (std::fclose(file_.release()) != 0) {
        throw std::runtime_error("cannot write the program: is the disk full?");
    }
}

}  // namespace curvecore::ref
