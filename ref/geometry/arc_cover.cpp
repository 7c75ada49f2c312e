// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/arc_cover.hpp"

#include <algorithm>
#include <cmath>

#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {
namespace {

constexpr double kShortestPiece = 1;       // unit: no plan has shorter pieces
constexpr double kLengthPrecision = 1.01;  // relative precision of the longest piece
constexpr double kLonger = 1.25;

class Search {
  public:
    Search(const CoreParameters& format, double least_radius, double most_radius, double limit)
        : format_(format), least_(least_radius), most_(most_radius), limit_(limit) {}

    ArcCover run() {
        const double quarter = M_PI_2 * most_;
        ArcCover cover;
        if (!keeps(std::min(kShortestPiece, quarter), cover)) return cover;
        if (!keeps(quarter, cover)) {
            double low = cover.longest;
            for (double high = quarter; high > low * kLengthPrecision;) {
                const double middle = std::sqrt(low * high);
                (keeps(middle, cover) ? low : high) = middle;
            }
        }
        rates(cover);
        return cover;
    }

  private:
    double bound(double length, int step_exponent) const {
        return family_bound(format_, {least_, most_, length, step_exponent});
    }

    /// Returns true if pieces up to this length keep the limit, with the longest step in `cover`.
    bool keeps(double length, ArcCover& cover) const {
        const int longest =
            std::clamp(static_cast<int>(std::ceil(std::log2(length))), 0, kMaxStepExponent);
        for (int k = longest; k >= 0 && std::ldexp(kMaxSteps, k) > length; --k) {
            if (std::ldexp(1 / least_, k) > kMostTheta) continue;
            const double error = bound(length, k);
            if (error > limit_) continue;
            // A piece of half the length is too short for a step that is longer than it.
            const double half = std::ldexp(1.0, k - 1);
            if (k > 0 && half < length && bound(half, k - 1) > limit_) continue;
            cover.longest = length;
            cover.step_exponent = k;
            cover.bound = error;
            return true;
        }
        return false;
    }

    /// One segment's own bound is a little below the family's, so the planner may find longer
    /// pieces. The step that it takes for them is not shorter than half that of the least bound.
    int shortest_step(const ArcCover& cover) const {
        if (cover.longest >= M_PI_2 * most_) return cover.step_exponent;
        int best = cover.step_exponent;
        double least = cover.bound;
        for (int k = best - 1; k >= 0 && std::ldexp(kMaxSteps, k) > cover.longest; --k) {
            const double error = bound(cover.longest, k);
            if (error >= least) continue;
            least = error;
            best = k;
        }
        return std::max(0, best - 1);
    }

    /// Pieces of length l have ceil(l / h) steps: most of them to a unit in the shortest piece, or
    /// in one that begins a new step.  The planner's are up to a quarter longer than the family's.
    void rates(ArcCover& cover) const {
        const double quarter = M_PI_2 * least_;
        const double pieces = std::max(1.0, std::floor(quarter / cover.longest));
        cover.shortest = std::min(cover.longest, quarter) * pieces / (pieces + 1);
        const double h = std::ldexp(1.0, shortest_step(cover));
        const double whole = std::ceil(cover.shortest / h);
        cover.steps_per_unit = whole / cover.shortest;
        if (whole * h < kLonger * cover.longest) {
            cover.steps_per_unit = std::max(cover.steps_per_unit, (whole + 1) / (whole * h));
        }
    }

    const CoreParameters& format_;
    const double least_, most_, limit_;
};

}  // namespace

ArcCover arc_cover(const CoreParameters& format, double least_radius, double most_radius,
                   double limit) {
    return Search(format, least_radius, most_radius, limit).run();
}

}  // namespace curvecore::ref
