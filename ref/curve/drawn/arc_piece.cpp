// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/drawn/arc_piece.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace curvecore::ref {
namespace {

class ArcPath final : public PathCurve {
  public:
    ArcPath(const Vec3& start, const ArcPiece& piece) : start_(start), piece_(piece) {}

    Vec3 position(double s) const override {
        Vec3 linear = start_ + piece_.advance * s;
        if (straight()) return linear;
        const double half = s * piece_.cos_pitch / (2 * piece_.radius);
        const double sin_half = std::sin(half);
        const double cos_half = std::cos(half);
        const double chord = 2 * piece_.radius * sin_half;
        return linear + (piece_.tangent * cos_half - piece_.normal * sin_half) * chord;
    }

    Vec3 direction(double s) const override {
        if (straight()) return piece_.advance;
        const double angle = s * piece_.cos_pitch / piece_.radius;
        return piece_.advance + piece_.cos_pitch * (piece_.tangent * std::cos(angle) -
                                                    piece_.normal * std::sin(angle));
    }

    Vec3 bend(double s) const override {
        const double twist = piece_.twist();
        return -piece_.cos_pitch * twist *
               (piece_.normal * std::cos(twist * s) + piece_.tangent * std::sin(twist * s));
    }

    double curvature(double /*s*/) const override {
        return straight() ? 0 : piece_.cos_pitch * piece_.cos_pitch / piece_.radius;
    }

    SharpestPlace sharpest() const override { return {curvature(0), 0}; }

    bool straight() const override { return piece_.radius == 0; }

  private:
    const Vec3 start_;
    const ArcPiece piece_;
};

}  // namespace

const char* ArcPiece::name() const {
    if (radius == 0) return "line";
    constexpr double kFlatRise = 1e-9;  // per unit of path: an advance in the plane makes no helix
    return std::abs(normal.cross(tangent).dot(advance)) < kFlatRise ? "arc" : "helix";
}

std::unique_ptr<PathCurve> ArcPiece::path(const Vec3& start, double /*length*/) const {
    return std::make_unique<ArcPath>(start, *this);
}

}  // namespace curvecore::ref
