// SPDX-License-Identifier: Apache-2.0
// A format of the kernels (hls/configuration.hpp) whose widths are known at run time only: native
// integers, cut to their words' widths; their ranges are noted for who asks.
#pragma once

#include <array>

#include "hls/curve_kernel.hpp"
#include "ref/curves/curve_table.hpp"
#include "ref/moves/move.hpp"
#include "sysc/core/core_parameters.hpp"
#include "sysc/kernel/value_ranges.hpp"

namespace curvecore::sysc {

struct RunTimeFormat {
    /// Creates the format; `axes`: at most 3 + AuxAxes; `ranges` notes what the words hold.
    RunTimeFormat(const CoreParameters& core, int axes, ValueRanges* ranges = nullptr)
        : kOrder(core.order),
          kCoefBits(core.coef_bits),
          kGuardBits(core.guard_bits),
          kParameterGuard(core.parameter_guard),
          kAxes(axes),
          kFineBits(core.position_bits + core.guard_bits),
          kCoefFrac(core.coef_bits - 2),
          kUnitFrac(core.coef_bits - 1),
          kAnchor(core.anchor != 0),
          kSeries(!core.polynomial()),
          kFurtherWords(core.further_words),
          kTable(core.table),
          ranges_(ranges) {}

    using Coef = std::int64_t;
    using Fine = std::int64_t;
    using Position = std::int64_t;
    using FineParameter = std::int64_t;
    using Product = hls::Word<128>;
    struct Further : std::array<Coef, ref::kMostFurther> {
        Coef& operator[](int n) { return data()[n]; }
        const Coef& operator[](int n) const { return data()[n]; }
    };
    static constexpr int kMostOrder = hls::kMostOrder;
    static constexpr int kMostAxes = 3 + ref::kAuxAxes;

    void note_rows(const char* curve, const hls::WordRow* rows) {
        if (ranges_ != nullptr) first_row_ = ranges_->first_row(curve, rows);
    }
    /// The value without the bits that its word has not; noted before.
    Coef keep(int row, int order, Coef value) const {
        if (ranges_ != nullptr) ranges_->note(first_row_ + row, order, value);
        const int left = 64 - kCoefBits;
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << left) >> left;
    }

    int kOrder, kCoefBits, kGuardBits, kParameterGuard, kAxes, kFineBits;
    int kCoefFrac, kUnitFrac;
    bool kAnchor, kSeries;
    int kFurtherWords;
    std::shared_ptr<const ref::CurveTable> kTable;  // none, or that of the core

  private:
    ValueRanges* ranges_;
    int first_row_ = 0;  // of the kernel's table
};

using RunSegment = hls::SegmentWords<RunTimeFormat>;
constexpr int kMostAxes = RunTimeFormat::kMostAxes;

}  // namespace curvecore::sysc
