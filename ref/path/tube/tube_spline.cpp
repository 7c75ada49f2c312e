// SPDX-License-Identifier: Apache-2.0
#include "ref/path/tube/tube_spline.hpp"

#include <algorithm>
#include <cmath>

#include "ref/numeric/band_matrix.hpp"
#include "ref/numeric/newton_work.hpp"

namespace curvecore::ref {
namespace {

constexpr double kStart = 0.97;                         // share of the limit that a start may take
constexpr int kWeightings = 6;                          // weightings of least squares
constexpr std::array<double, 3> kStages{1, 0.2, 0.04};  // barrier, as a share of the energy
constexpr int kSteps = 6;                               // Newton's steps of a stage
constexpr double kWorth = 0.02;                         // share of the barrier that a step promises
constexpr int kHalvings = 30;

}  // namespace

TubeSpline::TubeSpline(const ProgrammedPath& path, double tolerance,
                       const std::vector<double>& knots, const TubeEnd& start, const TubeEnd& end)
    : spline_(knots),
      limit_(tolerance - path.error()),
      path_error_(path.error()),
      first_(start.points()),
      last_(spline_.points.size() - end.points()) {
    const auto give = [this](const TubeEnd& state, bool at_end) {
        const std::size_t m = spline_.points.size();
        const auto own = spline_.knot(at_end ? spline_.spans() : 0);
        for (std::size_t i = 0; i < state.points(); ++i) {
            const std::size_t point = at_end ? m - 1 - i : i;
            const double* t = spline_.arguments(point);
            const double x = t[0] - own;
            const double y = t[1] - own;
            const double z = t[2] - own;
            spline_.points[point] = state.position + state.slope * ((x + y + z) / 3) +
                                    state.bend * ((x * y + x * z + y * z) / 6);
        }
    };
    give(start, false);
    give(end, true);
    add_rows(path);
}

void TubeSpline::add_rows(const ProgrammedPath& path) {
    const auto add = [this](std::size_t span, double x, double y, double z, const Vec3& target) {
        Row row{span, spline_.weights(span, x, y, z), target, false};
        for (std::size_t i = 0; i < 4; ++i) {
            row.free = row.free || (row.weight[i] != 0 && is_free(span + i));
        }
        rows_.push_back(row);
    };
    std::size_t piece = path.piece_at(spline_.knot(0));
    for (std::size_t span = 0; span < spline_.spans(); ++span) {
        row_of_span_.push_back(rows_.size());
        const double end = spline_.knot(span + 1);
        double x = spline_.knot(span);
        while (x < end) {
            const ProgrammedPath::Piece& q = path.pieces()[piece];
            const bool last = piece + 1 == path.pieces().size();
            const double y = last ? end : std::min(end, q.end());
            if (y > x) {
                const Bezier target = to_bezier(q.part(x, y));
                add(span, x, x, x, target[0]);
                add(span, x, x, y, target[1]);
                add(span, x, y, y, target[2]);
                if (y == end) add(span, y, y, y, target[3]);
            }
            x = std::max(x, y);
            if (!last && y == q.end()) ++piece;
        }
        const double a = spline_.knot(span);
        std::array<double, 4> third{};
        const std::array<double, 4> sign{-1, 3, -3, 1};
        for (std::size_t i = 0; i < 4; ++i) {
            const std::array<double, 4> w =
                spline_.weights(span, i > 0 ? end : a, i > 1 ? end : a, i > 2 ? end : a);
            for (std::size_t j = 0; j < 4; ++j) third[j] += sign[i] * w[j];
        }
        third_.push_back(third);
    }
    row_of_span_.push_back(rows_.size());
}

Vec3 TubeSpline::error(const Row& row) const {
    Vec3 sum = -row.target;
    for (std::size_t i = 0; i < 4; ++i) sum += row.weight[i] * spline_.points[row.span + i];
    return sum;
}

double TubeSpline::deviation(std::size_t span) const {
    double most = 0;
    for (std::size_t i = row_of_span_[span]; i < row_of_span_[span + 1]; ++i) {
        most = std::max(most, error(rows_[i]).norm());
    }
    return most + path_error_;
}

double TubeSpline::worst() const {
    double most = 0;
    for (const Row& row : rows_) {
        if (row.free) most = std::max(most, error(row).norm());
    }
    return most;
}

bool TubeSpline::fit() {
    std::vector<double> weights(rows_.size(), 1);
    for (int round = 0; round < kWeightings; ++round) {
        least_squares(weights);
        if (worst() <= kStart * limit_) return true;
        for (std::size_t i = 0; i < rows_.size(); ++i) {  // Lawson
            weights[i] *= std::pow(0.2 + std::min(error(rows_[i]).norm() / limit_, 3.0), 1.5);
        }
    }
    return false;
}

void TubeSpline::least_squares(const std::vector<double>& weights) {
    BandMatrix<3> matrix(last_ - first_);
    std::array<std::vector<double>, 3> right;
    for (auto& column : right) column.assign(last_ - first_, 0);
    for (std::size_t point = first_; point < last_; ++point) spline_.points[point].setZero();
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        const Row& row = rows_[k];
        if (!row.free) continue;
        const Vec3 rest = error(row);
        for (std::size_t i = 0; i < 4; ++i) {
            if (!is_free(row.span + i)) continue;
            const std::size_t at = row.span + i - first_;
            const double w = weights[k] * row.weight[i];
            for (int axis = 0; axis < 3; ++axis) right[axis][at] -= w * rest[axis];
            for (std::size_t j = 0; j <= i; ++j) {
                if (is_free(row.span + j)) matrix.add(at, row.span + j - first_, w * row.weight[j]);
            }
        }
    }
    matrix.decompose();
    for (int axis = 0; axis < 3; ++axis) {
        matrix.solve(right[axis]);
        for (std::size_t point = first_; point < last_; ++point) {
            spline_.points[point][axis] = right[axis][point - first_];
        }
    }
}

Vec3 TubeSpline::third_difference(std::size_t span) const {
    Vec3 d3 = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) d3 += third_[span][i] * spline_.points[span + i];
    return d3;
}

double TubeSpline::energy() const {
    double sum = 0;
    for (std::size_t span = 0; span < third_.size(); ++span) {
        sum += jerk_weight_[span] * third_difference(span).squaredNorm();
    }
    return sum / 2;
}

/// Value of the barrier that Newton's method minimises; infinite outside the tube.
double TubeSpline::barrier(double mu) const {
    double product = 1;
    double sum = 0;
    for (const Row& row : rows_) {
        if (!row.free) continue;
        const double room = 1 - error(row).squaredNorm() / (limit_ * limit_);
        if (!(room > 0)) return HUGE_VAL;
        product *= room;
        if (product < 1e-100) {
            sum += std::log(product);
            product = 1;
        }
    }
    return energy() - mu * (sum + std::log(product));
}

/// Slope and second derivative of the barrier by the four control points of a span.
struct TubeSpline::Local {
    using Symmetric = Eigen::Matrix<double, 6, 1>;  // xx, yx, yy, zx, zy, zz

    Eigen::Matrix<double, 3, 4> slope = Eigen::Matrix<double, 3, 4>::Zero();
    Eigen::Matrix<double, 6, 10> bend = Eigen::Matrix<double, 6, 10>::Zero();  // pairs i >= j

    /// Adds f(sum of weight x point) by f' = first e and f'' = diagonal I + square e e^T.
    void add(const std::array<double, 4>& weight, const Vec3& e, double first, double diagonal,
             double square) {
        Symmetric second;
        second << diagonal + square * e[0] * e[0], square * e[1] * e[0],
            diagonal + square * e[1] * e[1], square * e[2] * e[0], square * e[2] * e[1],
            diagonal + square * e[2] * e[2];
        for (int i = 0, at = 0; i < 4; ++i) {
            const double own = weight[static_cast<std::size_t>(i)];
            slope.col(i) += own * first * e;
            for (int j = 0; j <= i; ++j, ++at) {
                bend.col(at) += own * weight[static_cast<std::size_t>(j)] * second;
            }
        }
    }
};

TubeSpline::Local TubeSpline::local(std::size_t span, double mu) const {
    Local sum;
    sum.add(third_[span], third_difference(span), jerk_weight_[span], jerk_weight_[span], 0);
    for (std::size_t k = row_of_span_[span]; k < row_of_span_[span + 1]; ++k) {
        if (!rows_[k].free) continue;
        const Vec3 e = error(rows_[k]);
        const double factor = 2 * mu / (limit_ * limit_ - e.squaredNorm());
        sum.add(rows_[k].weight, e, factor, factor, factor * factor / mu);
    }
    return sum;
}

/// Makes a Newton step; returns true if it lowered the barrier.
bool TubeSpline::newton_step(double mu) {
    constexpr int kAt[3][3]{{0, 1, 3}, {1, 2, 4}, {3, 4, 5}};  // indices into Local::Symmetric
    const std::size_t n = last_ - first_;
    newton_work() += n;
    BandMatrix<11> matrix(3 * n);
    std::vector<double> step(3 * n, 0);
    for (std::size_t span = 0; span < third_.size(); ++span) {
        const Local sum = local(span, mu);
        for (std::size_t i = 0, pair = 0; i < 4; ++i) {
            for (std::size_t j = 0; j <= i; ++j, ++pair) {
                if (!is_free(span + i) || !is_free(span + j)) continue;
                const std::size_t at = 3 * (span + i - first_);
                const std::size_t to = 3 * (span + j - first_);
                for (std::size_t a = 0; a < 3; ++a) {
                    for (std::size_t b = 0; b < (i == j ? a + 1 : 3); ++b) {
                        matrix.add(at + a, to + b, sum.bend(kAt[a][b], static_cast<int>(pair)));
                    }
                }
            }
            if (!is_free(span + i)) continue;
            for (std::size_t a = 0; a < 3; ++a) {
                step[3 * (span + i - first_) + a] -=
                    sum.slope(static_cast<int>(a), static_cast<int>(i));
            }
        }
    }
    std::vector<double> slope = step;
    matrix.decompose();
    matrix.solve(step);
    double gain = 0;  // gain that the quadratic model promises, twice
    for (std::size_t i = 0; i < step.size(); ++i) gain += slope[i] * step[i];
    if (!(gain > 0)) return false;
    const double before = barrier(mu);
    const std::vector<Vec3> from = spline_.points;
    double length = 1;
    for (int halving = 0; halving < kHalvings; ++halving, length /= 2) {
        for (std::size_t point = first_; point < last_; ++point) {
            const double* by = &step[3 * (point - first_)];
            spline_.points[point] = from[point] + length * Vec3(by[0], by[1], by[2]);
        }
        if (barrier(mu) < before - 0.01 * length * gain) {
            return gain > kWorth * mu * static_cast<double>(rows_.size());
        }
    }
    spline_.points = from;
    return false;
}

void TubeSpline::smooth(const std::vector<double>& speeds, const Stages& stages) {
    jerk_weight_.clear();
    for (std::size_t span = 0; span < third_.size(); ++span) {
        jerk_weight_.push_back(std::pow(speeds[span] / spline_.width(span), 5) / (limit_ * limit_));
    }
    if (first_ >= last_) return;
    for (std::size_t i = stages.first; i < stages.end; ++i) {
        const double mu = kStages[i] * energy() / static_cast<double>(rows_.size());
        if (!(mu > 0)) return;
        for (int step = 0; step < kSteps && newton_step(mu); ++step) {
        }
    }
}

}  // namespace curvecore::ref
