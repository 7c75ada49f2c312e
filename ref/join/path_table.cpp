// SPDX-License-Identifier: Apache-2.0
#include "ref/join/path_table.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace curvecore::ref {
namespace {

constexpr std::size_t kParts = 32;
constexpr int kMostSteps = 20;

}  // namespace

PathTable::PathTable(std::vector<BezierPiece> pieces) : pieces_(std::move(pieces)), knots_{0} {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        for (std::size_t k = 0; k < kParts; ++k) {
            knots_.push_back(knots_.back() + part(i, static_cast<double>(k) / kParts,
                                                  static_cast<double>(k + 1) / kParts));
        }
    }
}

double PathTable::part(std::size_t piece, double from, double to) const {
    const BezierPiece& bezier = pieces_[piece];
    return boost::math::quadrature::gauss<double, 5>::integrate(
        [&bezier](double u) { return bezier.h * bezier.at(u).d1.norm(); }, from, to);
}

std::vector<double> PathTable::starts() const {
    std::vector<double> found;
    for (std::size_t i = 0; i < knots_.size(); i += kParts) found.push_back(knots_[i]);
    return found;
}

PathTable::Place PathTable::place(double s) const {
    const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, s);
    const auto knot = static_cast<std::size_t>(above - knots_.begin()) - 1;
    const std::size_t piece = knot / kParts;
    const double low = static_cast<double>(knot % kParts) / kParts;
    const double wanted = s - knots_[knot];
    const double whole = knots_[knot + 1] - knots_[knot];
    double u = low + std::clamp(whole > 0 ? wanted / whole : 0, 0.0, 1.0) / kParts;
    for (int i = 0; i < kMostSteps; ++i) {
        const double speed = pieces_[piece].h * pieces_[piece].at(u).d1.norm();
        if (!(speed > 0)) break;
        const double next =
            std::clamp(u + (wanted - part(piece, low, u)) / speed, low, low + 1.0 / kParts);
        if (std::abs(next - u) < 1e-13) break;
        u = next;
    }
    return {piece, u};
}

Joint PathTable::at(double s) const { return at(place(s)); }

Joint PathTable::at(const Place& place) const {
    const BezierPiece::Point point = pieces_[place.piece].at(place.u);
    Joint joint{{point.r, Vec3::Zero(), Vec3::Zero()}, 0};
    const double square = point.d1.squaredNorm();
    if (square > 0) {
        joint.tangent = point.d1 / std::sqrt(square);
        joint.curvature = point.d1.cross(point.d2).cross(point.d1) / (square * square);
    }
    return joint;
}

}  // namespace curvecore::ref
