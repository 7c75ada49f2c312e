// SPDX-License-Identifier: Apache-2.0
#include "sysc/wasm/chords.hpp"

#include <algorithm>
#include <cmath>

#include "ref/plan/curve_follower.hpp"
#include "sysc/words/bus_words.hpp"

namespace curvecore::sysc {
namespace {

constexpr int kPlaces = 64;  // of a segment at which its curvature is looked at
constexpr int kLooks = 8;    // within a chord

/// The integral of sqrt(curvature) ds from a segment's start, at equal distances.
std::vector<double> turned(const ref::PathCurve& curve, double length) {
    std::vector<double> sums{0};
    for (int i = 0; i < kPlaces; ++i) {
        const double curvature = curve.curvature(length * (i + 0.5) / kPlaces);
        const double root = std::isfinite(curvature) ? std::sqrt(std::abs(curvature)) : 0;
        sums.push_back(sums.back() + root * length / kPlaces);
    }
    return sums;
}

/// The place at which the integral has that value.
double place_of(double value, const std::vector<double>& sums, double length) {
    const auto behind = std::upper_bound(sums.begin() + 1, sums.end() - 1, value);
    const auto before = behind - 1;
    const double part = *behind > *before ? (value - *before) / (*behind - *before) : 1;
    return length * (static_cast<double>(before - sums.begin()) + part) / kPlaces;
}

double length_of(const ref::Segment& segment) {
    return std::ldexp(static_cast<double>(segment.length), -hls::kPathFrac);
}

class ChordWriter {
  public:
    ChordWriter(double unit_mm, Chords& chords) : unit_mm_(unit_mm), chords_(chords) {}

    void start(const ref::Vec3& point) { chords_.corners.emplace_back(point * unit_mm_); }

    /// Adds the chord from one place of a curve to another.
    void add(const ref::PathCurve& curve, double from, double to) {
        const ref::Vec3 end = place(curve, to);
        const ref::Vec3 start = chords_.corners.back();
        const ref::Vec3 along = (end - start).normalized();
        double most = 0;
        for (int i = 1; i < kLooks; ++i) {
            const ref::Vec3 arm = place(curve, from + (to - from) * i / kLooks) - start;
            most = std::max(most, (arm - along * arm.dot(along)).norm());
        }
        if (most > chords_.off_mm) {
            chords_.off_mm = most;
            chords_.worst = chords_.count();
            chords_.beside.clear();
            for (int i = 0; i <= kPlaces; ++i) {
                chords_.beside.push_back(place(curve, from + (to - from) * i / kPlaces));
            }
        }
        chords_.corners.push_back(end);
    }

  private:
    ref::Vec3 place(const ref::PathCurve& curve, double s) const {
        return curve.position(s) * unit_mm_;
    }

    double unit_mm_;
    Chords& chords_;
};

}  // namespace

Chords chords_of_equal_traffic(const Job& job) {
    const DrawnPlan& plan = job.plan;
    Chords chords;
    chords.bits = job.words() * std::size_t(hls::kBusBits);
    ref::CurveFollower curve;
    double all = 0;
    for (std::size_t n = 0; n < plan.segments.size(); ++n) {
        const ref::Segment& segment = plan.segments[n];
        all += turned(curve.on(segment), length_of(segment)).back();
    }
    const std::size_t most = chords.bits / kChordBits;
    const double left =
        most > plan.segments.size() ? static_cast<double>(most - plan.segments.size()) : 0;
    ChordWriter writer(plan.unit_mm, chords);
    for (std::size_t n = 0; n < plan.segments.size(); ++n) {
        const ref::Segment& segment = plan.segments[n];
        const ref::PathCurve& on = curve.on(segment);
        const double length = length_of(segment);
        const std::vector<double> sums = turned(on, length);
        if (n == 0) writer.start(on.position(0));
        const int parts = all > 0 ? 1 + static_cast<int>(left * sums.back() / all) : 1;
        double from = 0;
        for (int part = 1; part <= parts; ++part) {
            const double to =
                part == parts ? length : place_of(sums.back() * part / parts, sums, length);
            writer.add(on, from, to);
            from = to;
        }
    }
    return chords;
}

}  // namespace curvecore::sysc
