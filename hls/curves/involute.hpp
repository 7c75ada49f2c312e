// SPDX-License-Identifier: Apache-2.0
// Unwound by the angle t from a circle of radius R, of which a tooth's flank is a part: the path is
// R t^2/2 and the curvature 1/(R t). With a = 1/R and w = 1/t: w' = -a w^3.
// Made by `curvecore curve kernel involute.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// The involute of a circle, in any plane.
template <class C>
class InvoluteCurve : protected CurveSteps<C> {
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
    static constexpr int kFurther = 1;  // words of a segment that are the table's own

    InvoluteCurve() = default;
    explicit InvoluteCurve(const C& format) : Steps(format, "involute", rows()) {}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {
        Steps::open(segment);
        w_[0] = segment.further[0];
        a_ = segment.theta;
        for (int axis = 0; axis < 3; ++axis) {
            N_[axis][0] = segment.normal[axis];
            T_[axis][0] = segment.tangent[axis];
        }
        anchor();
        orders();
    }

    /// Moves on to the next integration step.
    void step() {
        Coef move_[3] = {};                           // CoefBits -2 fraction bits: +-2
        for (int axis = 0; axis < 3; ++axis) {
            // move[k] : -2 = sum(x[k])
            move_[axis] = keep(Row::move_, 0, Coef(sum(x_[axis], C::kOrder)));
            // T[k] : -2 = T[k] + sum(T[k])
            T_[axis][0] = keep(Row::T_, 0, Coef(Product(T_[axis][0]) + sum(T_[axis], C::kOrder)));
            // N[k] : -2 = N[k] + sum(N[k])
            N_[axis][0] = keep(Row::N_, 0, Coef(Product(N_[axis][0]) + sum(N_[axis], C::kOrder)));
        }
        // w : -3 = w + sum(w)
        w_[0] = keep(Row::w_, 0, Coef(Product(w_[0]) + sum(w_, C::kOrder)));
        Steps::move_origin(move_);
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
        // w2 : -5 = w*w
        w2_[0] = keep(Row::w2_, 0, rounded(times(w_[0], w_[0]), C::kCoefBits - 1));
        // w3 : -7 = w2*w
        w3_[0] = keep(Row::w3_, 0, rounded(times(w2_[0], w_[0]), C::kCoefBits - 1));
        // kappa : 0 = a*w
        kappa_[0] = keep(Row::kappa_, 0, rounded(times(a_, w_[0]), C::kCoefBits - 2));
    }

    /// Makes the orders of a step's series.
    void orders() {
        Coef DN_[3][C::kMostOrder + 1] = {};          // CoefBits -2 fraction bits: +-2
        Coef DT_[3][C::kMostOrder + 1] = {};          // CoefBits -2 fraction bits: +-2
        Coef Dw_[C::kMostOrder + 1] = {};             // CoefBits -4 fraction bits: +-8
        for (int i = 1; i <= C::kOrder; ++i) {
            // Dw : -4 = - a*w3'
            Dw_[i] = keep(Row::Dw_, i, rounded(-times(a_, w3_[i - 1]), C::kCoefBits - 2));
            // w : -3 = Dw/i
            w_[i] = keep(Row::w_, i, rounded(over(Dw_[i], i), C::kCoefBits - 2));
            if (i <= C::kOrder - 1) {
                // w2 : -5 = w*w
                w2_[i] = keep(Row::w2_, i, rounded(series_times(w_, w_, i), C::kCoefBits - 1));
                // w3 : -7 = w2*w
                w3_[i] = keep(Row::w3_, i, rounded(series_times(w2_, w_, i), C::kCoefBits - 1));
            }
            // kappa : 0 = a*w
            kappa_[i] = keep(Row::kappa_, i, rounded(times(a_, w_[i]), C::kCoefBits - 2));
            for (int axis = 0; axis < 3; ++axis) {
                // DT[k] : -2 = kappa*N[k]'
                DT_[axis][i] = keep(Row::DT_, i,
                    rounded(series_times(kappa_, N_[axis], i - 1), C::kCoefBits));
                // DN[k] : -2 = - kappa*T[k]'
                DN_[axis][i] = keep(Row::DN_, i,
                    rounded(-series_times(kappa_, T_[axis], i - 1), C::kCoefBits));
                // N[k] : -2 = DN[k]/i
                N_[axis][i] = keep(Row::N_, i, rounded(over(DN_[axis][i], i), C::kCoefBits - 1));
                // T[k] : -2 = DT[k]/i
                T_[axis][i] = keep(Row::T_, i, rounded(over(DT_[axis][i], i), C::kCoefBits - 1));
                // x[k] : -2 = T[k]'/i
                x_[axis][i] = keep(Row::x_, i, rounded(over(T_[axis][i - 1], i), C::kCoefBits - 1));
            }
        }
    }

    Coef N_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
    Coef T_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
    Coef a_ = 0;                                  // CoefBits +1 fraction bits: +-0.25
    Coef kappa_[C::kMostOrder + 1] = {};          // CoefBits +0 fraction bits: +-0.5
    Coef w_[C::kMostOrder + 1] = {};              // CoefBits -3 fraction bits: +-4
    Coef w2_[C::kMostOrder + 1] = {};             // CoefBits -5 fraction bits: +-16
    Coef w3_[C::kMostOrder + 1] = {};             // CoefBits -7 fraction bits: +-64
    Coef x_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2

  private:
    enum class Row { DN_, DT_, Dw_, N_, T_, a_, kappa_, move_, w_, w2_, w3_, x_ };
    /// Names and fraction bits of the rows, for a format that notes their ranges.
    static const WordRow* rows() {
        static constexpr WordRow kRows[] = {
            {"DN", -2},
            {"DT", -2},
            {"Dw", -4},
            {"N", -2},
            {"T", -2},
            {"a", 1},
            {"kappa", 0},
            {"move", -2},
            {"w", -3},
            {"w2", -5},
            {"w3", -7},
            {"x", -2},
            {nullptr, 0}};
        return kRows;
    }
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
