// SPDX-License-Identifier: Apache-2.0
// The times at which an axis is due to step, in exact numbers.
#pragma once

#include <cstdint>

namespace curvecore::ref {

/// A crossing of the middle between two whole steps, by a place that moves linearly from one sample
/// to the next in a period.
struct StepCrossing {
    __extension__ using Wide = __int128;
    Wide part;   // place in the period, part / whole in [0, 1]
    Wide whole;  // > 0
    bool back;

    /// Returns the first of `clocks` equal parts of the period, from 1, at whose end it is crossed.
    std::int64_t clock(std::int64_t clocks) const {
        // A backward motion: the middle itself still belongs to the step above.
        const Wide end = part * clocks;
        return static_cast<std::int64_t>(back ? end / whole + 1 : (end + whole - 1) / whole);
    }
    /// Returns the time of the crossing in clocks of the period.
    double time(std::int64_t clocks) const {
        return static_cast<double>(part) / static_cast<double>(whole) * static_cast<double>(clocks);
    }
};

/// An axis of steps / units steps per unit of its positions; both below 2^60, positions below 2^44.
class StepCrossings {
  public:
    using Wide = StepCrossing::Wide;
    StepCrossings(std::int64_t steps, std::int64_t units) : steps_(steps), units_(units) {}

    /// Returns the whole step at a position: the nearest, of two the one above.
    std::int64_t count(std::int64_t position) const {
        const Wide twice = 2 * Wide(position) * steps_ + units_;
        const Wide whole = 2 * Wide(units_);
        return static_cast<std::int64_t>(twice / whole - (twice % whole < 0 ? 1 : 0));
    }

    /// Calls each(StepCrossing) in order.
    template <class Each>
    void between(std::int64_t from, std::int64_t to, Each&& each) const {
        const std::int64_t first = count(from);
        const std::int64_t last = count(to);
        const Wide whole = 2 * (Wide(to) - from) * steps_;
        for (std::int64_t n = first; n < last; ++n) each({middle(n, from), whole, false});
        for (std::int64_t n = first; n > last; --n) each({-middle(n - 1, from), -whole, true});
    }

  private:
    /// Distance from `from` to the middle above step n, in units of `whole`.
    Wide middle(std::int64_t n, std::int64_t from) const {
        return (2 * Wide(n) + 1) * units_ - 2 * Wide(from) * steps_;
    }

    std::int64_t steps_;
    std::int64_t units_;
};

}  // namespace curvecore::ref
