// SPDX-License-Identifier: Apache-2.0
// Path length of a cubic and its inverse, by quadrature or from a table.
#pragma once

#include <vector>

#include "ref/curve/cubic.hpp"

namespace curvecore::ref {

/// | quantity  | symbol                        | unit   | domain                            |
/// |-----------|-------------------------------|--------|-----------------------------------|
/// | parameter | u                             | 1      | 0 .. 1                            |
/// | path      | s(u) = integral of v = |V| du | length | 0 .. s(1)                         |
///
/// The path length from u0 to u1, negative when u1 < u0: adaptive Gauss-Kronrod quadrature, split
/// where the speed is least or greatest. Error: 1e-13 of the result.
/// Source: [Obukhov] (3), with a rule that does not stop too early.
double arc_length(const Cubic& cubic, double u0, double u1);

/// u(s) by Newton's method within a bracket on the function above. s beyond the ends gives the end.
/// Error: 1e-13 s(1) of path. Source: [Obukhov], "tick search".
double parameter_at(const Cubic& cubic, double s);

/// The same two functions from a table, for checkers that evaluate every sample.
///
/// The table cuts 0 .. 1 where the speed turns and then in halves until ten Gauss points give the
/// length of a piece. Within a piece s(u) is convex or concave, so Newton's method cannot fail; it
/// starts from uniform acceleration between the ends' speeds, which is exact for a cusp.
///
/// Error: 1e-13 s(1) of path, both ways. Time per parameter(): below 1 us.
class ArcLength {
  public:
    explicit ArcLength(const Cubic& cubic);

    double length() const { return knots_.back().s; }

    /// s(u); u beyond 0 .. 1 gives the end.
    double path(double u) const;

    /// u(s); s beyond 0 .. length() gives the end.
    double parameter(double s) const;

  private:
    struct Knot {
        double u;
        double s;
        double speed;
    };

    double speed(double u) const;
    double integral(double from, double to) const;
    double short_integral(double from, double to) const;
    void append(double end, double estimate);

    // The coefficients of V, in axis order: what the integrand reads.
    double a_[3], b_[3], c_[3];
    double tolerance_ = 0;
    std::vector<Knot> knots_;
};

}  // namespace curvecore::ref
