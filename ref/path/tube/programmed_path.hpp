// SPDX-License-Identifier: Apache-2.0
// The programmed path by its own length s, with which a smoother path is compared.
#pragma once

#include <cstddef>
#include <vector>

#include "ref/curve/cubic.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::ref {

/// Moves in a row: lines exact, arcs as cubics with an error of `error` at most.
///
/// | field  | unit | remark                                                     |
/// |--------|------|------------------------------------------------------------|
/// | s      | mm   | of the piece's start                                       |
/// | length | mm   | > 0; the cubic's parameter is (path - s) / length          |
/// | cubic  | mm   | q(s): for an arc's part of angle d within R d^4 / 384 of it |
/// | move   |      | whose part this is, from 0                                 |
class ProgrammedPath {
  public:
    struct Piece {
        double s;
        double length;
        Cubic cubic;
        std::size_t move;

        double end() const { return s + length; }
        Cubic part(double from, double to) const {
            return sub_cubic(cubic, (from - s) / length, (to - s) / length);
        }
    };

    /// Returns the number of pieces of a move.
    static std::size_t parts(const Move& move, double error);
    /// Adds a move, a line or an arc; arcs in parts with an error of `error` mm at most.
    void add(const Move& move, double error);

    const std::vector<Piece>& pieces() const { return pieces_; }
    std::size_t moves() const { return moves_; }
    double length() const { return pieces_.empty() ? 0 : pieces_.back().end(); }
    double error() const { return error_; }

    /// Returns the index of the piece at s; at a joint the later one.
    std::size_t piece_at(double s) const;
    Vec3 position(double s) const;

  private:
    std::vector<Piece> pieces_;
    std::size_t moves_ = 0;
    double error_ = 0;
};

}  // namespace curvecore::ref
