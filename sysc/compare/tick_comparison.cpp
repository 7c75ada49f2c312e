// SPDX-License-Identifier: Apache-2.0
#include "sysc/compare/tick_comparison.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include "ref/series/exact_path.hpp"
#include "ref/series/paper_words.hpp"
#include "ref/series/spline_tables.hpp"

namespace curvecore::sysc {
namespace {

constexpr double kBlownUp = std::numeric_limits<double>::infinity();

ref::SplineMethod method_of(Scheme scheme) {
    switch (scheme) {
        case Scheme::kRungeKutta:
            return ref::SplineMethod::kRungeKutta;
        case Scheme::kScalar:
            return ref::SplineMethod::kScalar;
        default:
            return ref::SplineMethod::kPropagated;
    }
}

/// A follower that draws in double.
struct DoubleFollower {
    ref::SplineFollower<double> follower;
    double h;

    bool step() {
        follower.step(h);
        return true;
    }
    ref::Vec3 position() const {
        const auto at = follower.position();
        return {at[0], at[1], at[2]};
    }
};

class TickComparison {
  public:
    TickComparison(const Subject& subject, const TickScheme& ticks, Row& row,
                   const std::function<void()>& progress)
        : subject_(subject), step_(ticks.step()), row_(row), progress_(progress) {}

    /// Follows every cubic; `make(cubic, u0)` makes a follower that starts there.
    template <class Make>
    void run(const Make& make) {
        for (const ref::Move& move : subject_.program.moves) {
            double worst = 0;
            for (int phase = 0; phase < ref::kSplinePhases && worst < kBlownUp; ++phase) {
                ref::ExactPath<double> path(move.cubic);
                const double start = step_ * phase / ref::kSplinePhases;
                if (start > path.length()) break;
                worst = std::max(worst, follow(move.cubic, make(move.cubic, path.parameter(start)),
                                               path, start));
            }
            row_.blow_ups += worst == kBlownUp ? 1 : 0;
            row_.by_move.push_back(worst);
        }
        if (row_.blow_ups > 0) return;
        row_.fine = fine_count_->figures(3);
        row_.output = output_count_->figures(3);
    }

  private:
    /// Returns the worst distance, mm; infinite: blown up.
    template <class Follower>
    double follow(const ref::Cubic& cubic, Follower follower, ref::ExactPath<double>& path,
                  double start) {
        const double unit = subject_.unit_mm;
        double worst = 0;
        ref::Vec3 last_exact = cubic.position(path.parameter(start));
        ref::Vec3 last_drawn = last_exact;
        for (int n = 1; start + n * step_ <= path.length(); ++n) {
            progress_();
            ++row_.steps;
            const bool drawn_at_all = follower.step();
            const double u = path.parameter(start + n * step_);
            const ref::Vec3 exact = cubic.position(u);
            const ref::Vec3 drawn = follower.position();
            const ref::Vec3 miss = drawn - exact;
            const double distance = miss.norm();
            if (!drawn_at_all || !(distance <= ref::kSplineLostMm)) return kBlownUp;
            worst = std::max(worst, distance);
            double before[3];
            double after[3];
            for (int axis = 0; axis < 3; ++axis) {
                before[axis] = miss[axis] / unit;
                after[axis] = std::floor(drawn[axis] / unit + 0.5) - exact[axis] / unit;
            }
            const ref::Vec3 tangent = cubic.velocity(u).normalized();
            fine_count_->add(before, tangent.data(), 3);
            output_count_->add(after, tangent.data(), 3);
            ++row_.samples;
            const double chord = (exact - last_exact).norm() / unit;
            const double error = std::abs((drawn - last_drawn).norm() / unit - chord);
            row_.speed_error = std::max(row_.speed_error, error);
            if (chord >= kSpeedChord) {
                row_.speed_relative = std::max(row_.speed_relative.value_or(0), error / chord);
            }
            last_exact = exact;
            last_drawn = drawn;
        }
        return worst;
    }

    const Subject& subject_;
    const double step_;
    Row& row_;
    const std::function<void()>& progress_;
    std::unique_ptr<PositionCount> fine_count_ = std::make_unique<PositionCount>();
    std::unique_ptr<PositionCount> output_count_ = std::make_unique<PositionCount>();
};

}  // namespace

double ticks_of(const ref::Program& program, const TickScheme& ticks) {
    double length = 0;
    for (const ref::Move& move : program.moves) length += ref::arc_length(move.cubic, 0, 1);
    return ref::kSplinePhases * length / ticks.step();
}

Row compare_ticks(const Subject& subject, const CoreParameters& setting, const TickScheme& ticks,
                  const std::function<void()>& progress) {
    Row row;
    row.setting = setting;
    row.ticks = ticks;
    row.drawn = true;
    row.segments = subject.program.moves.size();
    TickComparison comparison(subject, ticks, row, progress);
    const double h = ticks.step();
    if (ticks.words) {
        comparison.run([&](const ref::Cubic& cubic, double u0) {
            return ref::PaperWords(cubic, setting.order, setting.coef_bits, u0, h);
        });
    } else {
        comparison.run([&](const ref::Cubic& cubic, double u0) {
            return DoubleFollower{{cubic, method_of(ticks.scheme), setting.order, u0}, h};
        });
    }
    return row;
}

}  // namespace curvecore::sysc
