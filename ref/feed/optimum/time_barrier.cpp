// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/optimum/time_barrier.hpp"

#include <cmath>
#include <limits>

#include "ref/feed/optimum/limited_places.hpp"

namespace curvecore::ref {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

inline double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Product (form) c.
inline std::array<double, 3> product(const std::array<double, 6>& f,
                                     const std::array<double, 3>& c) {
    return {f[0] * c[0] + f[1] * c[1] + f[3] * c[2], f[1] * c[0] + f[2] * c[1] + f[4] * c[2],
            f[3] * c[0] + f[4] * c[1] + f[5] * c[2]};
}

/// Logarithm of a product of many factors.
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

/// Slope and bend of a sum by three control points.
struct Sum {
    std::array<double, 3> slope{};
    std::array<double, 6> bend{};

    /// Adds a function of row.c with these derivatives.
    void add(const std::array<double, 3>& row, double first, double second) {
        slope[0] += first * row[0];
        slope[1] += first * row[1];
        slope[2] += first * row[2];
        const double to_first = second * row[0];
        const double to_second = second * row[1];
        bend[0] += to_first * row[0];
        bend[1] += to_first * row[1];
        bend[2] += to_second * row[1];
        bend[3] += to_first * row[2];
        bend[4] += to_second * row[2];
        bend[5] += second * row[2] * row[2];
    }

    void add_form(const std::array<double, 6>& form, double factor) {
        bend[0] += factor * form[0];
        bend[1] += factor * form[1];
        bend[2] += factor * form[2];
        bend[3] += factor * form[3];
        bend[4] += factor * form[4];
        bend[5] += factor * form[5];
    }

    /// Adds -ln of a room.
    template <class Room>
    void add_room(const Room& room, const std::array<double, 3>& c) {
        if (room.kind == Room::Kind::kControl) {
            const double inverse = 1 / c[1];
            slope[1] -= inverse;
            bend[2] += inverse * inverse;
            return;
        }
        if (room.kind == Room::Kind::kVelocity) {
            const double inverse = 1 / (1 - dot(room.row, c));
            add(room.row, inverse, inverse * inverse);
            return;
        }
        const std::array<double, 3> fc = product(room.form, c);
        if (room.kind == Room::Kind::kAcceleration) {
            const double twice = 2 / (1 - dot(c, fc));
            add(fc, twice, twice * twice);
            add_form(room.form, twice);
            return;
        }
        const double head = 1 / dot(room.row, c);
        const double square = head * head;
        const double inverse = 1 / (head - dot(c, fc));
        add({square * room.row[0] + 2 * fc[0], square * room.row[1] + 2 * fc[1],
             square * room.row[2] + 2 * fc[2]},
            inverse, inverse * inverse);
        add_form(room.form, 2 * inverse);
        // The square of the tangent of 1 / sqrt(q) stands for 1 / q.
        add(room.row, 0, -inverse * square * head / 2);
    }
};

}  // namespace

TimeBarrier::TimeBarrier(const std::vector<PathInterval>& path, const SpeedSpline& spline,
                         std::size_t first, std::size_t last)
    : first_(first), last_(last) {
    std::size_t most = 0;
    for (std::size_t k = first - 1; k <= last; ++k) most += 3 + 2 * path[k].places.size();
    rooms_.reserve(most);
    intervals_.reserve(last + 2 - first);
    times_.reserve(2 * (last + 2 - first));
    for (std::size_t k = first - 1; k <= last; ++k) {
        add_interval(path, spline, k);
        intervals_.push_back({rooms_.size(), times_.size()});
    }
}

void TimeBarrier::add_interval(const std::vector<PathInterval>& path, const SpeedSpline& spline,
                               std::size_t k) {
    const SpeedSpline::Form& form = spline.form(k);
    const auto by_controls = [&](double x) {  // the motion there of each control point alone
        std::array<PathMotion, 3> by;
        for (int j = 0; j < 3; ++j) by[j] = farther({form(0, j), form(1, j), form(2, j)}, x);
        return by;
    };
    const auto row = [&](double x, double most) {
        const std::array<PathMotion, 3> by = by_controls(x);
        return Three{by[0][0] / most, by[1][0] / most, by[2][0] / most};
    };
    const auto square = [&](double x, double most, const auto& product_of) {
        const std::array<PathMotion, 3> by = by_controls(x);
        const double scale = 1 / (most * most);
        return Square{
            scale * product_of(by[0], by[0]), scale * product_of(by[1], by[0]),
            scale * product_of(by[1], by[1]), scale * product_of(by[2], by[0]),
            scale * product_of(by[2], by[1]), scale * product_of(by[2], by[2]),
        };
    };
    each_limit_at(
        path, spline, k,
        [&](double x, double v) {
            rooms_.push_back({Room::Kind::kVelocity, row(x, v * v), {}});
        },
        [&](double x, const PlaceLimit& limit, double most) {
            const auto product_of = [&](const PathMotion& m, const PathMotion& n) {
                return acceleration_product(limit, m, n);
            };
            rooms_.push_back({Room::Kind::kAcceleration, {}, square(x, most, product_of)});
        },
        [&](double x, const PlaceLimit& limit, double mean, double most) {
            const auto product_of = [&](const PathMotion& m, const PathMotion& n) {
                return jerk_product(limit, mean, m, n);
            };
            rooms_.push_back({Room::Kind::kJerk, row(x, 1), square(x, most, product_of)});
        });
    const double h = spline.length(k);
    if (spline.rests(k)) {
        times_.push_back({3 * h, row(0, 1)});
        return;
    }
    rooms_.push_back({Room::Kind::kControl, {}, {}});
    for (const double x : SpeedSpline::gauss_points(h)) times_.push_back({h / 2, row(x, 1)});
}

double TimeBarrier::time(const SpeedSpline& spline) const {
    double time = 0;
    auto next = times_.begin();
    for (std::size_t i = 0; i < intervals_.size(); ++i) {
        const Three c = spline.controls(first_ - 1 + i);
        for (; next != times_.begin() + static_cast<std::ptrdiff_t>(intervals_[i].times); ++next) {
            const double q = dot(next->row, c);
            if (!(q > 0)) return kInfinite;
            time += next->length / std::sqrt(q);
        }
    }
    return time;
}

/// Room of a limit; <= 0 if it is violated.
inline double TimeBarrier::room(const Room& room, const Three& c) {
    switch (room.kind) {
        case Room::Kind::kVelocity:
            return 1 - dot(room.row, c);
        case Room::Kind::kAcceleration:
            return 1 - dot(c, product(room.form, c));
        case Room::Kind::kJerk: {
            const double along = dot(room.row, c);
            return along > 0 ? 1 / along - dot(c, product(room.form, c)) : 0;
        }
        case Room::Kind::kControl:
            break;
    }
    return c[1];
}

double TimeBarrier::value(const SpeedSpline& spline, double weight) const {
    const double seconds = time(spline);
    if (!std::isfinite(seconds)) return kInfinite;
    Logarithm rooms;
    std::size_t next = 0;
    for (std::size_t i = 0; i < intervals_.size(); ++i) {
        const Three c = spline.controls(first_ - 1 + i);
        for (; next < intervals_[i].rooms; ++next) {
            const double space = room(rooms_[next], c);
            if (!(space > 0)) return kInfinite;
            rooms.times(space);
        }
    }
    return weight * seconds - rooms.sum();
}

void TimeBarrier::differentiate(const SpeedSpline& spline, double weight, Derivatives& by) const {
    const std::size_t count = last_ - first_;
    by.gradient.assign(count, 0);
    by.hessian.clear();
    std::size_t next = 0;
    std::size_t next_time = 0;
    for (std::size_t i = 0; i < intervals_.size(); ++i) {
        const Three c = spline.controls(first_ - 1 + i);
        Sum sum;
        for (; next_time < intervals_[i].times; ++next_time) {
            const Slowness& slow = times_[next_time];
            const double q = dot(slow.row, c);
            const double t = weight * slow.length / std::sqrt(q);
            sum.add(slow.row, -t / (2 * q), 0.75 * t / (q * q));
        }
        for (; next < intervals_[i].rooms; ++next) sum.add_room(rooms_[next], c);
        // Control point k - 1 + j; those before the first free one wrap around beyond the last.
        for (std::size_t j = 0, at = 0; j < 3; ++j) {
            const std::size_t to = i + j - 2;
            if (to < count) by.gradient[to] += sum.slope[j];
            for (std::size_t l = 0; l <= j; ++l, ++at) {
                const std::size_t from = i + l - 2;
                if (to < count && from < count) by.hessian.add(to, from, sum.bend[at]);
            }
        }
    }
}

}  // namespace curvecore::ref
