// SPDX-License-Identifier: Apache-2.0
// r = start + c1 s + c2 s^2 .. c6 s^6: what a machine's joints do while the tool goes along its
// path. A step is a segment: none follows it.
// Made by `curvecore curve kernel series.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// A power series in the path, of six orders.
template <class C>
class SeriesCurve : protected CurveSteps<C> {
    using Steps = CurveSteps<C>;
    using Steps::before;
    using Steps::down;
    using Steps::even;
    using Steps::keep;
    using Steps::lifted;
    using Steps::named;
    using Steps::odd;
    using Steps::over;
    using Steps::rounded;
    using Steps::series_times;
    using Steps::stieltjes;
    using Steps::sum;
    using Steps::times;
    using Product = typename C::Product;

  public:
    using Coef = typename C::Coef;
    using Fine = typename C::Fine;
    static constexpr int kFurther = 9;  // words of a segment that are the table's own

    SeriesCurve() = default;
    explicit SeriesCurve(const C& format) : Steps(format, "series", rows()) {}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {
        Steps::open(segment);
        for (int axis = 0; axis < 3; ++axis) {
            c3_[axis] = segment.advance[axis];
            c4_[axis] = segment.further[0 + axis];
            c5_[axis] = segment.further[3 + axis];
            c6_[axis] = segment.further[6 + axis];
            c2_[axis] = segment.normal[axis];
            c1_[axis] = segment.tangent[axis];
        }
        anchor();
        orders();
    }

    /// Moves on to the next integration step.
    void step() {
        Steps::move_auxiliary();
        anchor();
        orders();
    }

    /// Sets the fine position at an offset of quanta into the present step.
    void sample(const Word<kLengthBits + 1>& offset, Fine* out) const {
        const Coef tau = Steps::tau_of(offset);
        Coef d[3];
        for (int axis = 0; axis < 3; ++axis) {
            d[axis] = Steps::in_tau(Row::x_, x_[axis], tau);
        }
        Steps::draw(d, tau, out);
    }

  protected:  // the words of a step
    /// Makes what a step begins with.
    void anchor() {
        for (int axis = 0; axis < 3; ++axis) {
            // x[k].1 : -2 = c1[k]
            x_[axis][1] = keep(Row::x_, 1, Coef(c1_[axis]));
            // x[k].2 : -2 = c2[k]
            x_[axis][2] = keep(Row::x_, 2, Coef(c2_[axis]));
        }
        if (C::kOrder >= 3) {
            for (int axis = 0; axis < 3; ++axis) {
                // x[k].3 : -2 = c3[k]
                x_[axis][3] = keep(Row::x_, 3, Coef(c3_[axis]));
            }
        }
        if (C::kOrder >= 4) {
            for (int axis = 0; axis < 3; ++axis) {
                // x[k].4 : -2 = c4[k]
                x_[axis][4] = keep(Row::x_, 4, Coef(c4_[axis]));
            }
        }
        if (C::kOrder >= 5) {
            for (int axis = 0; axis < 3; ++axis) {
                // x[k].5 : -2 = c5[k]
                x_[axis][5] = keep(Row::x_, 5, Coef(c5_[axis]));
            }
        }
        if (C::kOrder >= 6) {
            for (int axis = 0; axis < 3; ++axis) {
                // x[k].6 : -2 = c6[k]
                x_[axis][6] = keep(Row::x_, 6, Coef(c6_[axis]));
            }
        }
    }

    /// Makes the orders of a step's series.
    void orders() {
    }

    Coef c1_[3] = {};                             // CoefBits -2 fraction bits: +-2
    Coef c2_[3] = {};                             // CoefBits -2 fraction bits: +-2
    Coef c3_[3] = {};                             // CoefBits -2 fraction bits: +-2
    Coef c4_[3] = {};                             // CoefBits -2 fraction bits: +-2
    Coef c5_[3] = {};                             // CoefBits -2 fraction bits: +-2
    Coef c6_[3] = {};                             // CoefBits -2 fraction bits: +-2
    Coef x_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2

  private:
    enum class Row { c1_, c2_, c3_, c4_, c5_, c6_, x_ };
    /// Names and fraction bits of the rows, for a format that notes their ranges.
    static const WordRow* rows() {
        static constexpr WordRow kRows[] = {
            {"c1", -2},
            {"c2", -2},
            {"c3", -2},
            {"c4", -2},
            {"c5", -2},
            {"c6", -2},
            {"x", -2},
            {nullptr, 0}};
        return kRows;
    }
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
