// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/time_barrier.hpp"

#include <cmath>
#include <limits>

#include "ref/feed/limited_places.hpp"

namespace curvecore::ref {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

template <class Three>
double dot(const Three& a, const Three& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// (form) c
template <class Three, class Square>
Three product(const Square& f, const Three& c) {
    return {f[0] * c[0] + f[1] * c[1] + f[3] * c[2], f[1] * c[0] + f[2] * c[1] + f[4] * c[2],
            f[3] * c[0] + f[4] * c[1] + f[5] * c[2]};
}

/// ln of a product of many.
class Logarithm {
  public:
    void times(double factor) {
        product_ *= factor;
        if (!(product_ > 1e-200 && product_ < 1e200)) {
            sum_ += std::log(product_);
            product_ = 1;
        }
    }
    double sum() const { return sum_ + std::log(product_); }

  private:
    double product_ = 1;
    double sum_ = 0;
};

/// Control points k - 1, k, k + 1; 0 beyond the ends.
std::array<double, 3> controls(const SpeedSpline& spline, std::size_t k) {
    return {k == 0 ? 0 : spline.control(k - 1), spline.control(k),
            k + 1 == spline.intervals() ? 0 : spline.control(k + 1)};
}

}  // namespace

TimeBarrier::TimeBarrier(const std::vector<PathInterval>& path, const SpeedSpline& spline,
                         std::size_t first, std::size_t last)
    : first_(first), last_(last) {
    for (std::size_t k = first - 1; k <= last; ++k) {
        add_interval(path, spline, k);
        intervals_.push_back({rooms_.size(), times_.size()});
    }
}

void TimeBarrier::add_interval(const std::vector<PathInterval>& path, const SpeedSpline& spline,
                               std::size_t k) {
    const SpeedSpline::Form& form = spline.form(k);
    const auto row = [&](double x) {
        const Eigen::Vector3d r = form.transpose() * Eigen::Vector3d(1, 2 * x, x * x);
        return Three{r[0], r[1], r[2]};
    };
    const auto square = [&](double x, const Eigen::Matrix3d& u, double most) {
        Eigen::Matrix3d there;  // the motion at x by that at the start
        there << 1, 2 * x, x * x, 0, 1, x, 0, 0, 1;
        const Eigen::Matrix3d by_start = there * form;
        const Eigen::Matrix3d f = by_start.transpose() * u * by_start / (most * most);
        return Square{f(0, 0), f(1, 0), f(1, 1), f(2, 0), f(2, 1), f(2, 2)};
    };
    each_limit_at(
        path, spline, k,
        [&](double x, double v) {
            Three r = row(x);
            for (double& factor : r) factor /= v * v;
            rooms_.push_back({false, 1, r, {}});
        },
        [&](double x, const PlaceLimit& limit, double most) {
            rooms_.push_back({false, 1, {}, square(x, acceleration_form(limit), most)});
        },
        [&](double x, const Eigen::Matrix3d& jerk, double most) {
            rooms_.push_back({true, 0, row(x), square(x, jerk, most)});
        });
    const double h = spline.length(k);
    if (spline.rests(k)) {
        times_.push_back({3 * h, row(0)});
        return;
    }
    rooms_.push_back({false, 0, {0, -1, 0}, {}});
    for (const double x : SpeedSpline::gauss_points(h)) times_.push_back({h / 2, row(x)});
}

double TimeBarrier::time(const SpeedSpline& spline) const {
    double time = 0;
    auto next = times_.begin();
    for (std::size_t i = 0; i < intervals_.size(); ++i) {
        const Three c = controls(spline, first_ - 1 + i);
        for (; next != times_.begin() + static_cast<std::ptrdiff_t>(intervals_[i].times); ++next) {
            const double q = dot(next->row, c);
            if (!(q > 0)) return kInfinite;
            time += next->length / std::sqrt(q);
        }
    }
    return time;
}

double TimeBarrier::value(const SpeedSpline& spline, double weight) const {
    const double seconds = time(spline);
    if (!std::isfinite(seconds)) return kInfinite;
    Logarithm rooms;
    std::size_t next = 0;
    for (std::size_t i = 0; i < intervals_.size(); ++i) {
        const Three c = controls(spline, first_ - 1 + i);
        for (; next < intervals_[i].rooms; ++next) {
            const Room& room = rooms_[next];
            const double along = dot(room.row, c);
            if (room.jerk && !(along > 0)) return kInfinite;
            const double space =
                (room.jerk ? 1 / along : room.most - along) - dot(c, product(room.form, c));
            if (!(space > 0)) return kInfinite;
            rooms.times(space);
        }
    }
    return weight * seconds - rooms.sum();
}

void TimeBarrier::differentiate(const SpeedSpline& spline, double weight,
                                std::vector<double>& gradient, BandMatrix<2>& hessian) const {
    const std::size_t count = last_ - first_;
    gradient.assign(count, 0);
    hessian.clear();
    std::size_t next = 0;
    std::size_t next_time = 0;
    for (std::size_t i = 0; i < intervals_.size(); ++i) {
        const Three c = controls(spline, first_ - 1 + i);
        Three slope{};
        Square bend{};
        const auto add = [&](const Three& row, double factor, double square) {
            for (std::size_t j = 0, at = 0; j < 3; ++j) {
                slope[j] += factor * row[j];
                for (std::size_t l = 0; l <= j; ++l, ++at) bend[at] += square * row[j] * row[l];
            }
        };
        for (; next_time < intervals_[i].times; ++next_time) {
            const Slowness& slow = times_[next_time];
            const double q = dot(slow.row, c);
            const double t = weight * slow.length / std::sqrt(q);
            add(slow.row, -t / (2 * q), 0.75 * t / (q * q));
        }
        for (; next < intervals_[i].rooms; ++next) {
            const Room& room = rooms_[next];
            const double along = dot(room.row, c);
            const Three fc = product(room.form, c);
            const double inverse = 1 / ((room.jerk ? 1 / along : room.most - along) - dot(c, fc));
            const double head = room.jerk ? 1 / (along * along) : 1;
            Three down{};  // the room's gradient, negative
            for (std::size_t j = 0; j < 3; ++j) down[j] = head * room.row[j] + 2 * fc[j];
            add(down, inverse, inverse * inverse);
            for (std::size_t j = 0; j < 6; ++j) bend[j] += 2 * inverse * room.form[j];
            if (room.jerk) add(room.row, 0, -inverse * head / (2 * along));
        }
        // Control point k - 1 + j; those before the first free one wrap round beyond the last.
        for (std::size_t j = 0, at = 0; j < 3; ++j) {
            const std::size_t to = i + j - 2;
            if (to < count) gradient[to] += slope[j];
            for (std::size_t l = 0; l <= j; ++l, ++at) {
                const std::size_t from = i + l - 2;
                if (to < count && from < count) hessian.add(to, from, bend[at]);
            }
        }
    }
}

}  // namespace curvecore::ref
