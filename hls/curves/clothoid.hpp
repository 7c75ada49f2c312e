// SPDX-License-Identifier: Apache-2.0
// The natural equation of a curve, T' = kappa N, with its frame in any plane; T and N of length 1.
// Each axis has its own kappa, as a segment has no word more; the three are the same.
// Made by `curvecore curve kernel clothoid.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// A curve whose curvature is linear in its path, in any plane.
template <class C>
class ClothoidCurve : protected CurveSteps<C> {
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
    static constexpr int kFurther = 0;  // words of a segment that are the table's own

    ClothoidCurve() = default;
    explicit ClothoidCurve(const C& format) : Steps(format, "clothoid", rows()) {}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {
        Steps::open(segment);
        sigma_ = segment.theta;
        for (int axis = 0; axis < 3; ++axis) {
            kappa_[axis] = segment.advance[axis];
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
            // kappa[k] : +1 = kappa[k].0 + sigma
            kappa_[axis] = keep(Row::kappa_, 0, Coef(Product(kappa_[axis]) + Product(sigma_)));
        }
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
        for (int axis = 0; axis < 3; ++axis) {
            // minus_kappa[k] : +1 = - kappa[k].0
            minus_kappa_[axis] = keep(Row::minus_kappa_, 0, Coef(-Product(kappa_[axis])));
        }
        // minus_sigma : +1 = - sigma
        minus_sigma_ = keep(Row::minus_sigma_, 0, Coef(-Product(sigma_)));
    }

    /// Makes the orders of a step's series.
    void orders() {
        Coef DN_[3][C::kMostOrder + 1] = {};          // CoefBits -2 fraction bits: +-2
        Coef DT_[3][C::kMostOrder + 1] = {};          // CoefBits -2 fraction bits: +-2
        for (int i = 1; i <= C::kOrder; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                // DT[k] : -2 = kappa[k].0*N[k]' + sigma*N[k]''
                DT_[axis][i] = keep(Row::DT_, i,
                    rounded(times(kappa_[axis], N_[axis][i - 1]) +
                    times(sigma_, before(N_[axis], i - 2)), C::kCoefBits + 1));
                // DN[k] : -2 = minus_kappa[k]*T[k]' + minus_sigma*T[k]''
                DN_[axis][i] = keep(Row::DN_, i,
                    rounded(times(minus_kappa_[axis], T_[axis][i - 1]) +
                    times(minus_sigma_, before(T_[axis], i - 2)), C::kCoefBits + 1));
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
    Coef kappa_[3] = {};                          // CoefBits +1 fraction bits: +-0.25
    Coef minus_kappa_[3] = {};                    // CoefBits +1 fraction bits: +-0.25
    Coef minus_sigma_ = 0;                        // CoefBits +1 fraction bits: +-0.25
    Coef sigma_ = 0;                              // CoefBits +1 fraction bits: +-0.25
    Coef x_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2

  private:
    enum class Row { DN_, DT_, N_, T_, kappa_, minus_kappa_, minus_sigma_, move_, sigma_, x_ };
    /// Names and fraction bits of the rows, for a format that notes their ranges.
    static const WordRow* rows() {
        static constexpr WordRow kRows[] = {
            {"DN", -2},
            {"DT", -2},
            {"N", -2},
            {"T", -2},
            {"kappa", 1},
            {"minus_kappa", 1},
            {"minus_sigma", 1},
            {"move", -2},
            {"sigma", 1},
            {"x", -2},
            {nullptr, 0}};
        return kRows;
    }
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
