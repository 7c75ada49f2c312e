// SPDX-License-Identifier: Apache-2.0
// (a cos p + b sin p)/mu at constant path speed: p' = mu u with u = 1/|V|, V = b cos p - a sin p,
// u' = -u^3 V V'. c and e are cosine and sine of p.
// Made by `curvecore curve kernel ellipse.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// An ellipse in any plane, by its half axes times mu.
template <class C>
class EllipseCurve : protected CurveSteps<C> {
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
    static constexpr int kFurther = 3;  // words of a segment that are the table's own

    EllipseCurve() = default;
    explicit EllipseCurve(const C& format) : Steps(format, "ellipse", rows()) {}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {
        Steps::open(segment);
        c_[0] = segment.further[0];
        e_[0] = segment.further[1];
        u_[0] = segment.further[2];
        mu_ = segment.theta;
        for (int axis = 0; axis < 3; ++axis) {
            b_[axis] = segment.normal[axis];
            a_[axis] = segment.tangent[axis];
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
        }
        // c : -2 = c + sum(c)
        c_[0] = keep(Row::c_, 0, Coef(Product(c_[0]) + sum(c_, C::kOrder)));
        // e : -2 = e + sum(e)
        e_[0] = keep(Row::e_, 0, Coef(Product(e_[0]) + sum(e_, C::kOrder)));
        // u : -3 = u + sum(u)
        u_[0] = keep(Row::u_, 0, Coef(Product(u_[0]) + sum(u_, C::kOrder)));
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
            // V[k] : -2 = b[k]*c - a[k]*e
            V_[axis][0] = keep(Row::V_, 0,
                rounded(times(b_[axis], c_[0]) - times(a_[axis], e_[0]), C::kCoefBits - 2));
        }
        // S : -5 = u*u
        S_[0] = keep(Row::S_, 0, rounded(times(u_[0], u_[0]), C::kCoefBits - 1));
        // Q : -7 = - S*u
        Q_[0] = keep(Row::Q_, 0, rounded(-times(S_[0], u_[0]), C::kCoefBits - 1));
        for (int axis = 0; axis < 3; ++axis) {
            // T[k] : -2 = V[k]*u
            T_[axis][0] = keep(Row::T_, 0, rounded(times(V_[axis][0], u_[0]), C::kCoefBits - 3));
        }
    }

    /// Makes the orders of a step's series.
    void orders() {
        Coef DG_[C::kMostOrder + 1] = {};             // CoefBits -2 fraction bits: +-2
        Coef DV_[3][C::kMostOrder + 1] = {};          // CoefBits -2 fraction bits: +-2
        Coef Dc_[C::kMostOrder + 1] = {};             // CoefBits -2 fraction bits: +-2
        Coef De_[C::kMostOrder + 1] = {};             // CoefBits -2 fraction bits: +-2
        Coef Dp_[C::kMostOrder + 1] = {};             // CoefBits -2 fraction bits: +-2
        Coef Du_[C::kMostOrder + 1] = {};             // CoefBits -4 fraction bits: +-8
        for (int i = 1; i <= C::kOrder; ++i) {
            // Dp : -2 = mu*u'
            Dp_[i] = keep(Row::Dp_, i, rounded(times(mu_, u_[i - 1]), C::kCoefBits));
            // Dc : -2 = - e*Dp
            Dc_[i] = keep(Row::Dc_, i, rounded(-stieltjes(e_, Dp_, i), C::kCoefBits - 2));
            // De : -2 = c*Dp
            De_[i] = keep(Row::De_, i, rounded(stieltjes(c_, Dp_, i), C::kCoefBits - 2));
            for (int axis = 0; axis < 3; ++axis) {
                // DV[k] : -2 = b[k]*Dc - a[k]*De
                DV_[axis][i] = keep(Row::DV_, i,
                    rounded(times(b_[axis], Dc_[i]) - times(a_[axis], De_[i]), C::kCoefBits - 2));
            }
            // DG : -2 += V[k]*DV[k]
            DG_[i] = keep(Row::DG_, i,
                Coef(rounded(stieltjes(V_[0], DV_[0], i), C::kCoefBits - 2) +
                rounded(stieltjes(V_[1], DV_[1], i), C::kCoefBits - 2) +
                rounded(stieltjes(V_[2], DV_[2], i), C::kCoefBits - 2)));
            // Du : -4 = Q*DG
            Du_[i] = keep(Row::Du_, i, rounded(stieltjes(Q_, DG_, i), C::kCoefBits - 5));
            // c : -2 = Dc/i
            c_[i] = keep(Row::c_, i, rounded(over(Dc_[i], i), C::kCoefBits - 1));
            // e : -2 = De/i
            e_[i] = keep(Row::e_, i, rounded(over(De_[i], i), C::kCoefBits - 1));
            // u : -3 = Du/i
            u_[i] = keep(Row::u_, i, rounded(over(Du_[i], i), C::kCoefBits - 2));
            if (i <= C::kOrder - 1) {
                for (int axis = 0; axis < 3; ++axis) {
                    // V[k] : -2 = DV[k]/i
                    V_[axis][i] = keep(Row::V_, i,
                        rounded(over(DV_[axis][i], i), C::kCoefBits - 1));
                }
                // S : -5 = u*u
                S_[i] = keep(Row::S_, i, rounded(series_times(u_, u_, i), C::kCoefBits - 1));
                // Q : -7 = - S*u
                Q_[i] = keep(Row::Q_, i, rounded(-series_times(S_, u_, i), C::kCoefBits - 1));
                for (int axis = 0; axis < 3; ++axis) {
                    // T[k] : -2 = V[k]*u
                    T_[axis][i] = keep(Row::T_, i,
                        rounded(series_times(V_[axis], u_, i), C::kCoefBits - 3));
                }
            }
            for (int axis = 0; axis < 3; ++axis) {
                // x[k] : -2 = T[k]'/i
                x_[axis][i] = keep(Row::x_, i, rounded(over(T_[axis][i - 1], i), C::kCoefBits - 1));
            }
        }
    }

    Coef Q_[C::kMostOrder + 1] = {};              // CoefBits -7 fraction bits: +-64
    Coef S_[C::kMostOrder + 1] = {};              // CoefBits -5 fraction bits: +-16
    Coef T_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
    Coef V_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
    Coef a_[3] = {};                              // CoefBits -2 fraction bits: +-2
    Coef b_[3] = {};                              // CoefBits -2 fraction bits: +-2
    Coef c_[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2
    Coef e_[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2
    Coef mu_ = 0;                                 // CoefBits +1 fraction bits: +-0.25
    Coef u_[C::kMostOrder + 1] = {};              // CoefBits -3 fraction bits: +-4
    Coef x_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2

  private:
    enum class Row { DG_, DV_, Dc_, De_, Dp_, Du_, Q_, S_, T_, V_, a_, b_, c_, e_, move_,
                    mu_, u_, x_ };
    /// Names and fraction bits of the rows, for a format that notes their ranges.
    static const WordRow* rows() {
        static constexpr WordRow kRows[] = {
            {"DG", -2},
            {"DV", -2},
            {"Dc", -2},
            {"De", -2},
            {"Dp", -2},
            {"Du", -4},
            {"Q", -7},
            {"S", -5},
            {"T", -2},
            {"V", -2},
            {"a", -2},
            {"b", -2},
            {"c", -2},
            {"e", -2},
            {"move", -2},
            {"mu", 1},
            {"u", -3},
            {"x", -2},
            {nullptr, 0}};
        return kRows;
    }
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
