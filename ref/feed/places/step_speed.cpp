// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/places/step_speed.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ref/numeric/unlimited.hpp"
#include "ref/segment/core_budget.hpp"

namespace curvecore::ref {
namespace {

/// The starts of all steps along the path.
class Changes {
  public:
    Changes(const std::vector<Segment>& segments, const CoreTime& core)
        : segments_(segments), core_(core) {
        skip_empty();
    }

    bool over() const { return index_ == segments_.size(); }
    std::uint64_t place() const { return segments_[index_].s_start + offset_; }
    double cost() const {
        const CurveTime& time = core_.curve[segments_[index_].kind()];
        return offset_ == 0 ? time.segment : time.step;
    }

    void next() {
        offset_ += std::uint64_t{1} << (segments_[index_].step_exponent + 16);
        if (offset_ < segments_[index_].length) return;
        offset_ = 0;
        ++index_;
        skip_empty();
    }

  private:
    void skip_empty() {
        while (!over() && segments_[index_].length == 0) ++index_;
    }

    const std::vector<Segment>& segments_;
    const CoreTime& core_;
    std::size_t index_ = 0;
    std::uint64_t offset_ = 0;  // quanta into the segment
};

/// Speeds of the moves on a stretch of the path; stretches come in order.
class MoveSpeeds {
  public:
    explicit MoveSpeeds(const std::vector<PlannedMove>& moves)
        : moves_(moves), speeds_(moves.size(), kUnlimitedSpeed) {}

    void limit(std::uint64_t from, std::uint64_t to, double speed) {
        while (start_ + moves_[first_].length <= from) start_ += moves_[first_++].length;
        std::uint64_t start = start_;
        for (std::size_t i = first_; i < moves_.size() && start < to; ++i) {
            speeds_[i] = std::min(speeds_[i], speed);
            start += moves_[i].length;
        }
    }

    std::vector<double> take() { return std::move(speeds_); }

  private:
    const std::vector<PlannedMove>& moves_;
    std::vector<double> speeds_;
    std::size_t first_ = 0;
    std::uint64_t start_ = 0;  // start of the first one
};

}  // namespace

std::vector<double> step_speeds(const std::vector<Segment>& segments,
                                const std::vector<PlannedMove>& moves, const PlanOptions& options) {
    const CoreTime& core = options.core;
    const double window = window_of(options);
    const double budget = budget_of(options);
    MoveSpeeds speeds(moves);
    Changes first(segments, core);
    // The program's first step is ready before its first sample if steps are made in turn.
    if (!core.ahead && !first.over()) first.next();
    if (first.over()) return speeds.take();
    Changes last = first;
    double work = last.cost();
    for (; !first.over(); first.next()) {
        while (work <= budget || last.place() == first.place()) {
            if (!core.ahead && work > budget) {
                throw std::invalid_argument("a step takes longer than the samples leave it");
            }
            last.next();
            if (last.over()) return speeds.take();
            work += last.cost();
        }
        const double time = core.ahead ? work - first.cost() : window;
        const auto quanta = static_cast<double>(last.place() - first.place());
        speeds.limit(first.place(), last.place(), std::ldexp(quanta, -16) * options.unit_mm / time);
        work -= first.cost();
    }
    return speeds.take();
}

}  // namespace curvecore::ref
