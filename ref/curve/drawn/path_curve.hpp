// SPDX-License-Identifier: Apache-2.0
// The questions that plans, checks and reports ask of a curve that a core draws, of any kind.
#pragma once

#include "ref/curve/vec3.hpp"

namespace curvecore::ref {

/// | field     | unit    | remark                            |
/// |-----------|---------|-----------------------------------|
/// | curvature | 1/units | largest of the curve              |
/// | s         | units   | path length from its start to it  |
struct SharpestPlace {
    double curvature = 0;
    double s = 0;
};

/// An exact curve by its path length s, 0 to its own length, in length units; a value beyond the
/// ends may be that of the end.
///
/// | function  | unit    | value                                                            |
/// |-----------|---------|------------------------------------------------------------------|
/// | position  | units   | r                                                                |
/// | direction | 1       | r'; shorter than 1 where only auxiliary axes move or one of them |
/// |           |         | is the fastest                                                   |
/// | bend      | 1/units | r''                                                              |
/// | curvature | 1/units | |r''|; infinite at a cusp                                        |
/// | sharpest  |         | place of the largest curvature, to 1e-6 of it                    |
/// | straight  |         | true: r' is constant                                             |
class PathCurve {
  public:
    virtual ~PathCurve() = default;
    virtual Vec3 position(double s) const = 0;
    virtual Vec3 direction(double s) const = 0;
    virtual Vec3 bend(double s) const = 0;
    virtual double curvature(double s) const = 0;
    virtual SharpestPlace sharpest() const = 0;
    virtual bool straight() const = 0;
};

}  // namespace curvecore::ref
