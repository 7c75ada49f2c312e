// SPDX-License-Identifier: Apache-2.0
// The time of a motion and its distance from all limits as one number, and its derivatives.
#pragma once

#include <array>
#include <vector>

#include "ref/feed/optimum/speed_spline.hpp"
#include "ref/numeric/band_matrix.hpp"

namespace curvecore::ref {

/// The barrier of a range of free control points; those beside it stay:
///
///     weight * time - sum of ln(room), a room for each of
///
///     q <= V^2                                    in the middle and at the end of every interval
///     |r' a + r'' q| <= A                         at places
///     |f r' a' + 3 r'' a + r''' q| <= J / sqrt(q) at places; f: LimitedPlace::mean
///     0 <= c_k
///
/// Within an interval a' is constant and sqrt(q) is not: the jerk along the path is the mean one,
/// and that is the jerk of a cubic s(t) through both of its knots.
class TimeBarrier {
  public:
    /// Frees the control points first .. last - 1.
    TimeBarrier(const std::vector<PathInterval>& path, const SpeedSpline& spline, std::size_t first,
                std::size_t last);

    /// Value of the barrier; infinite if a limit is violated.
    double value(const SpeedSpline& spline, double weight) const;

    /// Derivatives by the free control points.
    struct Derivatives {
        explicit Derivatives(std::size_t count) : gradient(count), hessian(count) {}

        std::vector<double> gradient;
        BandMatrix<2> hessian;
    };
    /// Differentiates the barrier. The term 1 / sqrt(q) is convex, so its tangent replaces it; the
    /// tangent lies below it, so the result is conservative.
    void differentiate(const SpeedSpline& spline, double weight, Derivatives& by) const;

    double time(const SpeedSpline& spline) const;
    std::size_t rooms() const { return rooms_.size(); }

  private:
    using Three = std::array<double, 3>;
    using Square = std::array<double, 6>;  // symmetric: 00, 10, 11, 20, 21, 22

    /// Room that one limit leaves.
    ///
    /// | kind          | room, of the three control points c of an interval |
    /// |---------------|----------------------------------------------------|
    /// | kVelocity     | 1 - row.c                                          |
    /// | kAcceleration | 1 - c^T form c                                     |
    /// | kJerk         | 1 / row.c - c^T form c                             |
    /// | kControl      | c_k                                                |
    struct Room {
        enum class Kind { kVelocity, kAcceleration, kJerk, kControl } kind;
        Three row;
        Square form;
    };
    /// Time length / sqrt(row.c), s.
    struct Slowness {
        double length;
        Three row;
    };
    struct Interval {
        std::size_t rooms, times;  // ends of its rooms and times
    };

    void add_interval(const std::vector<PathInterval>& path, const SpeedSpline& spline,
                      std::size_t k);

    static double room(const Room& room, const Three& c);

    std::size_t first_, last_;
    std::vector<Interval> intervals_;  // first - 1 .. last
    std::vector<Room> rooms_;
    std::vector<Slowness> times_;
};

}  // namespace curvecore::ref
