// SPDX-License-Identifier: Apache-2.0
// The parameter of the next tick by search along the arc: [Obukhov] Fig. 1, steps 1 to 4.
//
//     err = S - s     dt = err / |r'(t)|     t += dt, s += arc(t, t + dt)     until err < tolerance
#pragma once

#include "ref/numeric/simpson.hpp"

namespace curvecore::ref {

/// | form     | starts a tick from      | stops when        | arc lengths count from             |
/// |----------|-------------------------|-------------------|------------------------------------|
/// | literal  | t = 0, s = 0            | err < tolerance   | the frame's start                  |
/// | signed   | the tick before         | err < tolerance   | the frame's start                  |
/// | mended   | the tick before         | |err| < tolerance | the frame's start                  |
/// | summed   | the tick before         | |err| < tolerance | the tick before, taken to be right |
///
/// `literal` and `signed` stop after the first step that goes too far. `summed` is the form that
/// the paper warns of: errors below the tolerance add up.
enum class SearchForm { kLiteral, kSigned, kMended, kSummed };

class TickSearch {
  public:
    static constexpr int kMostIterations = 50;

    /// Searches with the `tolerance` of a length and of its quadrature, mm.
    TickSearch(const Cubic& cubic, SearchForm form, double tolerance);

    /// Returns the parameter at a length of `s` from the start (of the frame), mm; s grows.
    double at(double s);

    double parameter() const { return t_; }
    int iterations() const { return iterations_; }  // of the last tick

  private:
    double arc(double from, double to) const;

    Cubic cubic_;
    SearchForm form_;
    double tolerance_;
    double t_ = 0;
    double s_ = 0;      // mm, path length taken for t_
    double asked_ = 0;  // mm, s of the last tick
    int iterations_ = 0;
};

}  // namespace curvecore::ref
