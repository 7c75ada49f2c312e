// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/drawn/spline_piece.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <optional>

#include "ref/curve/arc_length.hpp"

namespace curvecore::ref {
namespace {

constexpr int kPlaces = 64;
constexpr int kBits = 26;  // bits of a minimum's place: half a double's

/// Returns the parameter of the largest curvature, by search between kPlaces places.
double sharpest_parameter(const Cubic& cubic) {
    const auto bend = [&cubic](double u) { return -curvature(cubic, u); };
    int best = 0;
    for (int i = 1; i <= kPlaces; ++i) {
        if (bend(static_cast<double>(i) / kPlaces) < bend(static_cast<double>(best) / kPlaces)) {
            best = i;
        }
    }
    const double low = std::max(best - 1, 0) / static_cast<double>(kPlaces);
    const double high = std::min(best + 1, kPlaces) / static_cast<double>(kPlaces);
    const double inside = boost::math::tools::brent_find_minima(bend, low, high, kBits).first;
    const double place = static_cast<double>(best) / kPlaces;
    return bend(inside) < bend(place) ? inside : place;
}

class SplinePath final : public PathCurve {
  public:
    SplinePath(const Cubic& cubic, double length) : cubic_(cubic), length_(length) {}

    Vec3 position(double s) const override { return cubic_.position(parameter(s)); }
    Vec3 direction(double s) const override { return tangent(cubic_, parameter(s)); }
    Vec3 bend(double s) const override { return curvature_vector(cubic_, parameter(s)); }
    double curvature(double s) const override { return ref::curvature(cubic_, parameter(s)); }
    bool straight() const override { return false; }

    SharpestPlace sharpest() const override {
        const double u = sharpest_parameter(cubic_);
        return {ref::curvature(cubic_, u), arc_length(cubic_, 0, u)};
    }

  private:
    double parameter(double s) const {
        if (s <= 0) return 0;
        if (s >= length_) return 1;
        if (!table_) table_.emplace(cubic_);
        return table_->parameter(s);
    }

    const Cubic cubic_;
    const double length_;
    mutable std::optional<ArcLength> table_;  // the ends need none
};

}  // namespace

Cubic SplinePiece::cubic(const Vec3& start) const {
    const double unit = std::ldexp(1.0, lambda);
    return {a * (unit * beta * beta * beta), b * (unit * beta * beta), c * (unit * beta), start};
}

std::unique_ptr<PathCurve> SplinePiece::path(const Vec3& start, double length) const {
    return std::make_unique<SplinePath>(cubic(start), length);
}

}  // namespace curvecore::ref
