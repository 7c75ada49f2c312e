// SPDX-License-Identifier: Apache-2.0
// A kernel that draws the curve of a table, as those of hls/ draw theirs: the same words of a
// segment, the same samples. It is some hundred times as slow.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "ref/curves/table_machine.hpp"
#include "sysc/kernel/run_time_format.hpp"
#include "sysc/kernel/table_words.hpp"

namespace curvecore::sysc {

/// The first word of a segment at a place of the bus; of a row of three axes the others follow.
inline const std::int64_t* words_at(const ref::BusPlace& place, const RunSegment& words) {
    if (place.further()) return words.further.data() + place.number;
    if (place.field == "theta") return &words.theta;
    return place.field == "tangent"  ? words.tangent
           : place.field == "normal" ? words.normal
                                     : words.advance;
}

/// Axes X Y Z of a segment; for hls::InterpolatorKernel.
class TableKernel {
  public:
    using Real = boost::multiprecision::number<
        boost::multiprecision::cpp_bin_float<113, boost::multiprecision::digit_base_2>,
        boost::multiprecision::et_off>;
    using Machine = ref::TableMachine<Real, TableWords<Real>>;

    TableKernel(const ref::CurveTable& table, const RunTimeFormat& format)
        : table_(table),
          coef_bits_(format.kCoefBits),
          guard_bits_(format.kGuardBits),
          machine_(table, format.kOrder, !format.kSeries,
                   {coef_bits_, guard_bits_, format.kParameterGuard}, format.kAnchor) {}

    void load(const RunSegment& words) {
        k_ = words.step_exponent;
        for (const auto& [name, row] : table_.bus) {
            const ref::CurveRow& of = table_.rows.at(row);
            const ref::BusPlace place = ref::bus_place(name);
            const std::int64_t* const field = words_at(place, words);
            for (int axis = 0; axis < (of.of_axis ? 3 : 1); ++axis) {
                const Real word(field[axis]);
                machine_.set(row, ldexp(word, -coef_bits_ - of.fraction), axis);
            }
        }
        Machine::Axes start;
        for (int axis = 0; axis < 3; ++axis) {
            start[axis] = ldexp(Real(words.start[axis]), -guard_bits_);
        }
        machine_.load(start, k_, words.lambda);
    }

    void step() { machine_.step(); }

    /// Sets the fine position at sigma quanta of the step.
    void sample(std::int64_t sigma, std::int64_t* out) {
        const int unit = coef_bits_ - 1;
        const Real tau = floor(ldexp(Real(sigma), unit - k_ - hls::kPathFrac));  // cut
        const Machine::Axes at = machine_.sample(ldexp(tau, -unit));
        for (int axis = 0; axis < 3; ++axis) {
            out[axis] = static_cast<std::int64_t>(ldexp(at[axis], guard_bits_));
        }
    }

    /// An order of a row, as a word.
    std::int64_t word(const std::string& row, int order = 0, int axis = 0) const {
        const int bits = coef_bits_ + table_.rows.at(row).fraction;
        return static_cast<std::int64_t>(ldexp(machine_.value(row, order, axis), bits));
    }

  private:
    const ref::CurveTable& table_;
    int coef_bits_;
    int guard_bits_;
    int k_ = 0;
    Machine machine_;
};

}  // namespace curvecore::sysc
