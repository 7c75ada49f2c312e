// SPDX-License-Identifier: Apache-2.0
// r = e^(c p), the path grows with r: kappa' = -c kappa^2.
// Made by `curvecore curve kernel spiral.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// A logarithmic spiral, in any plane.
template <class C>
class SpiralCurve : protected CurveSteps<C> {
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

    SpiralCurve() = default;
    explicit SpiralCurve(const C& format) : Steps(format, "spiral", rows()) {}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {
        Steps::open(segment);
        kappa_[0] = segment.further[0];
        c_ = segment.theta;
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
        // kappa : 0 = kappa + sum(kappa)
        kappa_[0] = keep(Row::kappa_, 0, Coef(Product(kappa_[0]) + sum(kappa_, C::kOrder)));
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
        // kappa2 : +1 = kappa*kappa
        kappa2_[0] = keep(Row::kappa2_, 0, rounded(times(kappa_[0], kappa_[0]), C::kCoefBits - 1));
    }

    /// Makes the orders of a step's series.
    void orders() {
        Coef DN_[3][C::kMostOrder + 1] = {};          // CoefBits -2 fraction bits: +-2
        Coef DT_[3][C::kMostOrder + 1] = {};          // CoefBits -2 fraction bits: +-2
        Coef Dkappa_[C::kMostOrder + 1] = {};         // CoefBits +0 fraction bits: +-0.5
        for (int i = 1; i <= C::kOrder; ++i) {
            // Dkappa : 0 = - c*kappa2'
            Dkappa_[i] = keep(Row::Dkappa_, i,
                rounded(-times(c_, kappa2_[i - 1]), C::kCoefBits - 2));
            // kappa : 0 = Dkappa/i
            kappa_[i] = keep(Row::kappa_, i, rounded(over(Dkappa_[i], i), C::kCoefBits - 1));
            if (i <= C::kOrder - 1) {
                // kappa2 : +1 = kappa*kappa
                kappa2_[i] = keep(Row::kappa2_, i,
                    rounded(series_times(kappa_, kappa_, i), C::kCoefBits - 1));
            }
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
    Coef c_ = 0;                                  // CoefBits -3 fraction bits: +-4
    Coef kappa_[C::kMostOrder + 1] = {};          // CoefBits +0 fraction bits: +-0.5
    Coef kappa2_[C::kMostOrder + 1] = {};         // CoefBits +1 fraction bits: +-0.25
    Coef x_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2

  private:
    enum class Row { DN_, DT_, Dkappa_, N_, T_, c_, kappa_, kappa2_, move_, x_ };
    /// Names and fraction bits of the rows, for a format that notes their ranges.
    static const WordRow* rows() {
        static constexpr WordRow kRows[] = {
            {"DN", -2},
            {"DT", -2},
            {"Dkappa", 0},
            {"N", -2},
            {"T", -2},
            {"c", -3},
            {"kappa", 0},
            {"kappa2", 1},
            {"move", -2},
            {"x", -2},
            {nullptr, 0}};
        return kRows;
    }
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
