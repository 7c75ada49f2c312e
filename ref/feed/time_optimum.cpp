// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/time_optimum.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "ref/feed/banded.hpp"

namespace curvecore::ref {
namespace {

constexpr double kInside = 0.98;                // of every limit, at the start
constexpr double kStage = 8;                    // by which the weight of the time grows
constexpr int kMostSteps = 30;                  // of Newton's method in a stage
constexpr double kCentred = 0.05;               // half the square of Newton's decrement
constexpr double kFirstGap = 0.5;               // of the time
constexpr double kGauss = 0.21132486540518713;  // (1 - 1 / sqrt 3) / 2
constexpr std::size_t kSmoothest = 63;          // intervals
constexpr double kInfinite = std::numeric_limits<double>::infinity();

using Three = Eigen::Vector3d;
using Square = Eigen::Matrix3d;

/// q, a, a' (rows) as linear functions of three neighbouring control points.
using Form = Square;

class Optimum {
  public:
    Optimum(const std::vector<PathInterval>& intervals, const std::vector<KnotMotion>& start)
        : intervals_(intervals),
          n_(intervals.size()),
          first_(1 / (3 + 2 * h(1) / h(0))),
          last_(1 / (3 + 2 * h(n_ - 2) / h(n_ - 1))),
          hessian_(n_ - 2),
          gradient_(n_ - 2) {
        for (std::size_t k = 0; k < n_; ++k) {
            forms_.push_back(forms(k));
            rooms_ += 3;
            for (const auto& limits : intervals[k].limits) rooms_ += limits.size();
        }
        // The control point of a piece of parabola, from both of its ends.
        for (std::size_t k = 1; k + 1 < n_; ++k) {
            const double q = (start[k].q + start[k + 1].q) / 2;
            const double bend = h(k) * (start[k].a - start[k + 1].a) / 2;
            y_.push_back(std::max(q + bend, std::min(start[k].q, start[k + 1].q)));
        }
        choose_start();
    }

    void run(double gap) {
        double share = kFirstGap;
        while (true) {
            weight_ = static_cast<double>(rooms_) / (share * time());
            centre();
            if (share <= gap) return;
            share = std::max(share / kStage, gap);
        }
    }

    std::vector<KnotMotion> knots() const {
        std::vector<KnotMotion> knots{{0, 0}};
        for (std::size_t k = 0; k + 1 < n_; ++k) {
            const Three m = motion(y_, k, 2);
            knots.push_back({m[0], m[1]});
        }
        knots.push_back({0, 0});
        return knots;
    }

  private:
    double h(std::size_t k) const { return intervals_[k].length; }

    /// q and a at the end of interval `left`, whose control point is in `column`.
    Form knot(std::size_t left, int column) const {
        const double sum = h(left) + h(left + 1);
        Form f = Form::Zero();
        f(0, column) = h(left + 1) / sum;
        f(0, column + 1) = h(left) / sum;
        f(1, column) = -1 / sum;
        f(1, column + 1) = 1 / sum;
        return f;
    }

    /// At the start, in the middle and at the end of an interval; next to rest at its other end.
    std::array<Form, 3> forms(std::size_t k) const {
        if (k == 0 || k + 1 == n_) {
            Form moving = k == 0 ? knot(0, 1) : knot(k - 1, 0);
            moving.row(2) = moving.row(0) * (2 / (9 * h(k) * h(k)));
            return {moving, moving, moving};
        }
        Form start = knot(k - 1, 0);
        Form end = knot(k, 1);
        start.row(2) = end.row(2) = (end.row(1) - start.row(1)) / h(k);
        Form middle = start;
        middle.row(0) += h(k) * start.row(1) + h(k) * h(k) / 4 * start.row(2);
        middle.row(1) += h(k) / 2 * start.row(2);
        return {start, middle, end};
    }

    /// Control points k - 1, k, k + 1.
    Three controls(const std::vector<double>& y, std::size_t k) const {
        Three c;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t at = k + i;  // plus 1
            c[static_cast<Eigen::Index>(i)] = at == 0 || at == n_ + 1 ? 0
                                              : at == 1               ? first_ * y.front()
                                              : at == n_              ? last_ * y.back()
                                                                      : y[at - 2];
        }
        return c;
    }

    Three motion(const std::vector<double>& y, std::size_t k, std::size_t place) const {
        return forms_[k][place] * controls(y, k);
    }

    /// All places where the motion is held against limits: starts, middles and ends of intervals.
    template <class Visit>
    void each_place(Visit visit) const {
        for (std::size_t k = 0; k < n_; ++k) {
            for (std::size_t place = 0; place < 3; ++place) {
                if ((k > 0 || place == 2) && (k + 1 < n_ || place == 0)) visit(k, place);
            }
        }
    }
    /// Acceleration at both ends, jerk in the middle or where the other end rests.
    bool has_jerk(std::size_t k, std::size_t place) const {
        return place == 1 || k == 0 || k + 1 == n_;
    }

    double velocity(std::size_t k, std::size_t place) const {
        if (place == 1) return intervals_[k].velocity;
        const std::size_t left = place == 2 ? k : k - 1;
        return std::min({intervals_[left].velocity, intervals_[left].end_velocity,
                         intervals_[left + 1].velocity});
    }

    /// The motion given, and smoother ones below it: what one rough place costs, all must be slowed
    /// by. The fastest of them.
    void choose_start() {
        const std::vector<double> given = y_;
        std::vector<double> best;
        double least = kInfinite;
        for (std::size_t width = 0; width <= kSmoothest; width = 2 * width + 1) {
            y_ = smooth_below(given, width);
            slow_down();
            const double needed = time();
            if (needed < least) {
                least = needed;
                best = y_;
            }
        }
        y_ = std::move(best);
    }

    /// Means of the least values within `width` places to both sides.
    static std::vector<double> smooth_below(const std::vector<double>& values, std::size_t width) {
        const std::size_t n = values.size();
        const auto window = [&](const std::vector<double>& from, const auto& value) {
            std::vector<double> to(n);
            for (std::size_t i = 0; i < n; ++i) {
                const std::size_t first = i > width ? i - width : 0;
                const std::size_t last = std::min(n - 1, i + width);
                to[i] = value(from.begin() + static_cast<std::ptrdiff_t>(first),
                              from.begin() + static_cast<std::ptrdiff_t>(last) + 1);
            }
            return to;
        };
        const auto mean = [](auto begin, auto end) {
            return std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin);
        };
        const auto least = [](auto begin, auto end) { return *std::min_element(begin, end); };
        return window(window(window(values, least), mean), mean);
    }

    void slow_down() {
        double slower = 1;  // of the speed
        each_place([&](std::size_t k, std::size_t place) {
            const Three m = motion(y_, k, place);
            slower = std::min(slower, kInside * velocity(k, place) / std::sqrt(m[0]));
            for (const PlaceLimit& limit : intervals_[k].limits[place]) {
                const double a =
                    std::sqrt(std::max(acceleration_square(limit, m[0], m[1]), 1e-300));
                const double jerk = m[0] * m.dot(jerk_square(limit) * m);
                if (place != 1) {
                    slower = std::min(slower, std::sqrt(kInside * limit.acceleration / a));
                }
                if (!has_jerk(k, place)) continue;
                slower = std::min(
                    slower, std::cbrt(kInside * limit.jerk / std::sqrt(std::max(jerk, 1e-300))));
            }
        });
        for (double& c : y_) c *= slower * slower;
    }

    /// q in the two Gauss points of an interval.
    std::array<Three, 2> gauss(std::size_t k) const {
        const Form& f = forms_[k][0];
        std::array<Three, 2> rows;
        for (int i = 0; i < 2; ++i) {
            const double x = (i == 0 ? kGauss : 1 - kGauss) * h(k);
            rows[static_cast<std::size_t>(i)] =
                (f.row(0) + 2 * x * f.row(1) + x * x * f.row(2)).transpose();
        }
        return rows;
    }

    double time() const { return time(y_); }
    double time(const std::vector<double>& y) const {
        double sum = 0;
        for (std::size_t k = 0; k < n_; ++k) {
            if (k == 0 || k + 1 == n_) {
                sum += 3 * h(k) / std::sqrt(motion(y, k, 1)[0]);
                continue;
            }
            const Three c = controls(y, k);
            for (const Three& row : gauss(k)) {
                const double q = row.dot(c);
                if (!(q > 0)) return kInfinite;
                sum += h(k) / 2 / std::sqrt(q);
            }
        }
        return sum;
    }

    /// The true barrier.
    double value(const std::vector<double>& y) const {
        double sum = weight_ * time(y);
        bool inside = std::isfinite(sum);
        double product = 1;
        const auto room = [&](double space) {
            if (!(space > 0)) inside = false;
            product *= space;
            if (!(product > 1e-200 && product < 1e200)) {
                sum -= std::log(product);
                product = 1;
            }
        };
        each_place([&](std::size_t k, std::size_t place) {
            if (!inside) return;
            const Three m = motion(y, k, place);
            if (!(m[0] > 0)) {
                inside = false;
                return;
            }
            const double v = velocity(k, place);
            room(1 - m[0] / (v * v));
            for (const PlaceLimit& limit : intervals_[k].limits[place]) {
                if (place != 1) {
                    room(1 - acceleration_square(limit, m[0], m[1]) /
                                 (limit.acceleration * limit.acceleration));
                }
                if (!has_jerk(k, place)) continue;
                room(1 / m[0] - m.dot(jerk_square(limit) * m) / (limit.jerk * limit.jerk));
            }
        });
        return inside ? sum - std::log(product) : kInfinite;
    }

    void add(std::size_t k, const Three& gradient, const Square& hessian) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [at, factor] = place(k + i);
            if (factor == 0) continue;
            gradient_[at] += factor * gradient[static_cast<Eigen::Index>(i)];
            for (std::size_t j = 0; j < 3; ++j) {
                const auto [to, other] = place(k + j);
                if (other == 0) continue;
                hessian_.add(
                    at, to,
                    factor * other *
                        hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
            }
        }
    }

    /// The unknown that control point `at` - 1 hangs on.
    std::pair<std::size_t, double> place(std::size_t at) const {
        if (at == 0 || at == n_ + 1) return {0, 0.0};
        if (at == 1) return {0, first_};
        if (at == n_) return {n_ - 3, last_};
        return {at - 2, 1.0};
    }

    /// Gradient and Hessian, the jerk's right side by its tangent.
    void differentiate() {
        hessian_.clear();
        std::fill(gradient_.begin(), gradient_.end(), 0);
        for (std::size_t k = 0; k < n_; ++k) {
            const Three c = controls(y_, k);
            const auto count = [&](const Three& row, double length) {
                const double q = row.dot(c);
                const double t = weight_ * length / std::sqrt(q);
                add(k, -t / (2 * q) * row, 0.75 * t / (q * q) * row * row.transpose());
            };
            if (k == 0 || k + 1 == n_) {
                count(forms_[k][1].row(0).transpose(), 3 * h(k));
            } else {
                for (const Three& row : gauss(k)) count(row, h(k) / 2);
            }
        }
        each_place([&](std::size_t k, std::size_t place) {
            const Form& form = forms_[k][place];
            const Three m = motion(y_, k, place);
            Three slope = Three::Zero();
            Square bend = Square::Zero();
            const double v = velocity(k, place);
            const double left = v * v - m[0];
            slope[0] += 1 / left;
            bend(0, 0) += 1 / (left * left);
            for (const PlaceLimit& limit : intervals_[k].limits[place]) {
                if (place != 1) {
                    Square a = Square::Zero();
                    a.topLeftCorner<2, 2>() << limit.d22, limit.d12, limit.d12, limit.d11;
                    const Three p = 2 * a * m;
                    const double room = limit.acceleration * limit.acceleration -
                                        acceleration_square(limit, m[0], m[1]);
                    slope += p / room;
                    bend += p * p.transpose() / (room * room) + 2 * a / room;
                }
                if (!has_jerk(k, place)) continue;
                const Square u = jerk_square(limit);
                const double g = limit.jerk / std::sqrt(m[0]);
                const double dg = -g / (2 * m[0]);
                const double space = g * g - m.dot(u * m);
                Three w = -2 * u * m;
                w[0] += 2 * g * dg;
                slope -= w / space;
                bend += w * w.transpose() / (space * space) + 2 * u / space;
                bend(0, 0) -= 2 * dg * dg / space;
            }
            add(k, form.transpose() * slope, form.transpose() * bend * form);
        });
    }

    void centre() {
        double here = value(y_);
        for (int step = 0; step < kMostSteps; ++step) {
            differentiate();
            std::vector<double> direction = gradient_;
            hessian_.solve(direction);
            double decrement = 0;
            for (std::size_t i = 0; i < y_.size(); ++i) decrement += gradient_[i] * direction[i];
            if (!(decrement > 2 * kCentred)) return;
            double part = 1;
            while (part > 1e-9) {
                std::vector<double> next = y_;
                for (std::size_t i = 0; i < y_.size(); ++i) next[i] -= part * direction[i];
                const double there = value(next);
                if (there <= here - 0.1 * part * decrement) {
                    y_ = std::move(next);
                    here = there;
                    break;
                }
                part /= 2;
            }
            if (part <= 1e-9) return;
        }
    }

    const std::vector<PathInterval>& intervals_;
    std::size_t n_;
    double first_, last_;                     // control points 0 and n - 1 of the next ones
    std::vector<std::array<Form, 3>> forms_;  // of intervals: start, middle, end
    std::size_t rooms_ = 0;
    double weight_ = 1;
    std::vector<double> y_;  // control points 1 .. n - 2
    Banded hessian_;
    std::vector<double> gradient_;
};

}  // namespace

std::vector<KnotMotion> time_optimum(const std::vector<PathInterval>& intervals,
                                     const std::vector<KnotMotion>& start, double gap) {
    Optimum optimum(intervals, start);
    optimum.run(gap);
    return optimum.knots();
}

}  // namespace curvecore::ref
