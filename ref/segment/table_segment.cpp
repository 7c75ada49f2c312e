// SPDX-License-Identifier: Apache-2.0
#include "ref/segment/table_segment.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ref/bound/table_bound.hpp"
#include "ref/format/path_words.hpp"
#include "ref/segment/last_step.hpp"

namespace curvecore::ref {
namespace {

constexpr int kMostSteps = 32;         // of a segment: each is followed by the bound
constexpr double kMostSegments = 512;  // of a move
constexpr double kLongest = static_cast<double>(std::uint64_t{1} << (kBusLengthBits - 16)) - 1;

/// A cut that keeps the limits: so far from the segment's start, in steps of 2^k.
struct Reach {
    double length = 0;
    int k = 0;
    double bound = 0;
};

class TableCutter {
  public:
    TableCutter(const TableCurve& curve, const PlanOptions& options, double least)
        : curve_(curve), options_(options), least_(least) {}

    std::vector<Segment> run() {
        std::vector<Segment> segments;
        const double length = curve_.length();
        k_ = static_cast<int>(std::ceil(std::log2(std::max(1.0, length))));
        for (double s = 0; s < length;) {
            const double rest = std::min(length - s, kLongest);
            const Reach reach = longest(curve_.piece_at(s), rest);
            if (!(reach.length * kMostSegments > length - s)) refuse();
            double part = reach.length;
            // What is left of the curve is no short piece.
            if (part < rest && rest < 1.5 * part) {
                part = std::ldexp(std::ceil(std::ldexp(rest / 2, -reach.k)), reach.k);
            }
            const double cut = cut_for_last_step(part, reach.k, least_);
            if (cut > 0) part = cut;
            const bool all = s + part >= length;
            const double end = all ? length : s + part;
            Segment segment;
            segment.curve = curve_.piece_at(s);
            segment.start = curve_.position(s);
            segment.end = curve_.position(end);
            segment.step_exponent = reach.k;
            segment.bound = reach.bound;
            segment.length = static_cast<std::uint64_t>(std::llround((end - s) * kQuantaPerUnit));
            segments.push_back(segment);
            k_ = std::min(reach.k + 1, kMaxStepExponent);
            s = end;
        }
        return segments;
    }

  private:
    [[noreturn]] static void refuse() {
        throw std::domain_error("no steps of the table keep the bound");
    }

    /// The longest of the cuts from steps of 2^k_ downwards, until they are shorter again.
    Reach longest(const TablePiece& piece, double rest) const {
        Reach best;
        for (int k = std::min(k_, kMaxStepExponent); k >= 0; --k) {
            const double steps = std::ceil(std::ldexp(rest, -k));
            const Reach reach =
                in_steps(piece, k, static_cast<int>(std::min(steps, 1.0 * kMostSteps)));
            if (reach.length >= rest) return {rest, k, reach.bound};
            if (reach.length > best.length) best = reach;
            if (std::ldexp(1.0 * kMostSteps, k) < best.length) break;
        }
        return best;
    }

    Reach in_steps(const TablePiece& piece, int k, int most) const {
        const double limit = options_.error_limit / 2;
        for (int steps = most; steps > 0; steps /= 2) {
            TableSegment segment;
            segment.values = piece.rows(std::ldexp(1.0, k));
            segment.k = segment.lambda = k;
            segment.steps = steps;
            const TableError error = table_error(*piece.table, options_.format, segment);
            if (!error.beyond.empty()) continue;
            Reach reach{0, k, 0};
            for (const auto& step : error.errors) {
                const double length = reach.length + std::ldexp(1.0, k);
                const double bound = std::max({reach.bound, step[0], step[1], step[2]});
                if (!(bound <= limit)) break;
                reach.length = length;
                reach.bound = bound;
            }
            return reach;
        }
        return {};
    }

    const TableCurve& curve_;
    const PlanOptions& options_;
    double least_;  // units, of a last step
    int k_ = 0;     // of the longest steps that are tried
};

}  // namespace

std::vector<Segment> cut_table(const TableCurve& curve, const PlanOptions& options,
                               double least_last_step) {
    return TableCutter(curve, options, least_last_step).run();
}

}  // namespace curvecore::ref
