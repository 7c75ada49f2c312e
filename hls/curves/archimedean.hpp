// SPDX-License-Identifier: Apache-2.0
// r = p/b at the angle p: p' = b w with w = 1/sqrt(1 + p^2), w' = -b p w^4, kappa = b (w + w^3).
// Made by `curvecore curve kernel archimedean.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// An Archimedean spiral, in any plane.
template <class C>
class ArchimedeanCurve : private CurveSteps<C> {
    using Steps = CurveSteps<C>;
    using Steps::before;
    using Steps::down;
    using Steps::even;
    using Steps::lifted;
    using Steps::odd;
    using Steps::over;
    using Steps::rounded;
    using Steps::series_times;
    using Steps::stieltjes;
    using Steps::sum;
    using Steps::times;

  public:
    using Coef = typename C::Coef;
    using Fine = typename C::Fine;
    static constexpr int kFurther = 2;  // words of a segment that are the table's own

    ArchimedeanCurve() = default;
    explicit ArchimedeanCurve(const C& format) : Steps(format) {}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {
        Steps::open(segment);
        p_[0] = segment.further[0];
        w_[0] = segment.further[1];
        b_ = segment.theta;
        for (int axis = 0; axis < 3; ++axis) {
            N_[axis][0] = segment.normal[axis];
            T_[axis][0] = segment.tangent[axis];
        }
        expand();
    }

    /// Moves on to the next integration step.
    void step() {
        Coef move[3] = {};                            // CoefBits -2 fraction bits: +-2
        for (int axis = 0; axis < 3; ++axis) {
            // move[k] : -2 = sum(x[k])
            move[axis] = Coef(sum(x_[axis], C::kOrder));
            // T[k] : -2 = T[k] + sum(T[k])
            T_[axis][0] = Coef(T_[axis][0] + sum(T_[axis], C::kOrder));
            // N[k] : -2 = N[k] + sum(N[k])
            N_[axis][0] = Coef(N_[axis][0] + sum(N_[axis], C::kOrder));
        }
        // p : -6 = p + sum(p)
        p_[0] = Coef(p_[0] + sum(p_, C::kOrder));
        // w : -2 = w + sum(w)
        w_[0] = Coef(w_[0] + sum(w_, C::kOrder));
        Steps::move_origin(move);
        Steps::move_auxiliary();
        expand();
    }

    /// Sets the fine position at an offset of quanta into the present step.
    void sample(const Word<kLengthBits + 1>& offset, Fine* out) const {
        const Coef tau = Steps::tau_of(offset);
        Coef d[3];
        for (int axis = 0; axis < 3; ++axis) {
            d[axis] = Steps::in_tau(x_[axis], tau);
        }
        Steps::draw(d, tau, out);
    }

  private:
    void expand() {
        Coef DN[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
        Coef DT[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
        Coef Dp[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2
        Coef Dw[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2
        Coef kappa[C::kMostOrder + 1] = {};           // CoefBits +0 fraction bits: +-0.5
        Coef pw4[C::kMostOrder + 1] = {};             // CoefBits -2 fraction bits: +-2
        Coef u[C::kMostOrder + 1] = {};               // CoefBits -2 fraction bits: +-2
        Coef w2[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2
        Coef w3[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2
        // w2 : -2 = w*w
        w2[0] = rounded(times(w_[0], w_[0]), C::kCoefBits - 2);
        // w3 : -2 = w2*w
        w3[0] = rounded(times(w2[0], w_[0]), C::kCoefBits - 2);
        // u : -2 = w2*w2
        u[0] = rounded(times(w2[0], w2[0]), C::kCoefBits - 2);
        // pw4 : -2 = p*u
        pw4[0] = rounded(times(p_[0], u[0]), C::kCoefBits - 6);
        // kappa : 0 = b*w + b*w3
        kappa[0] = rounded(times(b_, w_[0]) + times(b_, w3[0]), C::kCoefBits - 2);
        for (int i = 1; i <= C::kOrder; ++i) {
            // Dp : -2 = b*w'
            Dp[i] = rounded(times(b_, w_[i - 1]), C::kCoefBits);
            // Dw : -2 = - b*pw4'
            Dw[i] = rounded(-times(b_, pw4[i - 1]), C::kCoefBits);
            // p : -6 = Dp/i
            p_[i] = rounded(over(Dp[i], i), C::kCoefBits + 3);
            // w : -2 = Dw/i
            w_[i] = rounded(over(Dw[i], i), C::kCoefBits - 1);
            // w2 : -2 = w*w
            w2[i] = rounded(series_times(w_, w_, i), C::kCoefBits - 2);
            // w3 : -2 = w2*w
            w3[i] = rounded(series_times(w2, w_, i), C::kCoefBits - 2);
            if (i <= C::kOrder - 1) {
                // u : -2 = w2*w2
                u[i] = rounded(series_times(w2, w2, i), C::kCoefBits - 2);
                // pw4 : -2 = p*u
                pw4[i] = rounded(series_times(p_, u, i), C::kCoefBits - 6);
            }
            // kappa : 0 = b*w + b*w3
            kappa[i] = rounded(times(b_, w_[i]) + times(b_, w3[i]), C::kCoefBits - 2);
            for (int axis = 0; axis < 3; ++axis) {
                // DT[k] : -2 = kappa*N[k]'
                DT[axis][i] = rounded(series_times(kappa, N_[axis], i - 1), C::kCoefBits);
                // DN[k] : -2 = - kappa*T[k]'
                DN[axis][i] = rounded(-series_times(kappa, T_[axis], i - 1), C::kCoefBits);
                // N[k] : -2 = DN[k]/i
                N_[axis][i] = rounded(over(DN[axis][i], i), C::kCoefBits - 1);
                // T[k] : -2 = DT[k]/i
                T_[axis][i] = rounded(over(DT[axis][i], i), C::kCoefBits - 1);
                // x[k] : -2 = T[k]'/i
                x_[axis][i] = rounded(over(T_[axis][i - 1], i), C::kCoefBits - 1);
            }
        }
    }

    Coef N_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
    Coef T_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
    Coef b_ = 0;                                  // CoefBits +0 fraction bits: +-0.5
    Coef p_[C::kMostOrder + 1] = {};              // CoefBits -6 fraction bits: +-32
    Coef w_[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2
    Coef x_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
