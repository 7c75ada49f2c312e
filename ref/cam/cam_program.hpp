// SPDX-License-Identifier: Apache-2.0
// A cam as G-code: X radius, Z along the axis, A angle in degrees. A line of these three axes is a
// piece of an Archimedean spiral on a helix. G93 holds the speed over the surface: every block
// states its inverse time, 1/min.
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "ref/cam/cam_path.hpp"

namespace curvecore::ref {

class CamProgram {
  public:
    /// `feed`: speed over the surface, mm/s. `remarks` become comments at the head.
    /// @throws std::runtime_error when the file cannot be written
    CamProgram(const std::string& file, double feed, const std::vector<std::string>& remarks);

    void piece(const CamPiece& piece);
    /// Writes M2. @throws std::runtime_error when the disk is full
    void close();

    std::size_t pieces() const { return pieces_; }

  private:
    void flush();

    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    double feed_;
    std::string buffer_;
    std::size_t pieces_ = 0;
};

/// Length of the piece on the unrolled surface, mm.
double surface_length(const CamPiece& piece);

}  // namespace curvecore::ref
