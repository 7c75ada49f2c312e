// SPDX-License-Identifier: Apache-2.0
// Fig. 10, anchored at every step: hls/spline_kernel.hpp, hls/spline_network.hpp.
// Made by `curvecore curve kernel spline.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// A cubic r(v) = start + 2^lambda ((a v + b) v + c) v at constant path speed.
template <class C>
class SplineCurve : private CurveSteps<C> {
    using Steps = CurveSteps<C>;
    using Steps::before;
    using Steps::down;
    using Steps::even;
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

    SplineCurve() = default;
    explicit SplineCurve(const C& format) : Steps(format) {}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {
        Steps::open(segment);
        phi_[0] = segment.theta;
        for (int axis = 0; axis < 3; ++axis) {
            c_[axis] = segment.advance[axis];
            b_[axis] = segment.normal[axis];
            a_[axis] = segment.tangent[axis];
        }
        v_ = 0;
        for (int axis = 0; axis < 3; ++axis) {
            // three_a[k] : -2 = a[k] + 2 a[k]
            three_a_[axis] = Coef(Product(a_[axis]) + 2 * Product(a_[axis]));
            // step_a[k] : -1 = a[k] >> 2s
            step_a_[axis] = Steps::template scaled_down<64>(a_[axis], 1, 2 * down());
            // six_a[k] : +1 = 2 three_a[k] >> 2s
            six_a_[axis] = Steps::template scaled_down<64>(2 * Product(three_a_[axis]), 3,
                2 * down());
        }
        expand();
    }

    /// Moves on to the next integration step.
    void step() {
        Coef gain_ = 0;                               // CoefBits -1 fraction bits: +-1
        Coef moved_ = 0;                              // CoefBits -2 fraction bits: +-2
        // moved : -2 = sum(q)
        moved_ = Coef(sum(q_, C::kOrder));
        // gain : -1 = moved >> s
        gain_ = Steps::template scaled_down<64>(moved_, 1, down());
        // v : -1 = v + gain
        v_ = Coef(Product(v_) + Product(gain_));
        // phi : -2 = phi + sum(phi)
        phi_[0] = Coef(Product(phi_[0]) + sum(phi_, C::kOrder - 1));
        Steps::move_auxiliary();
        expand();
    }

    /// Sets the fine position at an offset of quanta into the present step.
    void sample(const Word<kLengthBits + 1>& offset, Fine* out) const {
        const Coef tau = Steps::tau_of(offset);
        Coef d[3];
        if (C::kSeries) {
            for (int axis = 0; axis < 3; ++axis) {
                d[axis] = Steps::in_tau(x_[axis], tau);
            }
        } else {
            Coef e2_[3] = {};                             // CoefBits -1 fraction bits: +-1
            Coef f2_[3] = {};                             // CoefBits -1 fraction bits: +-1
            Coef q_tau_ = 0;                              // CoefBits -2 fraction bits: +-2
            // q_tau : -2 = horner(q)
            q_tau_ = Steps::in_tau(q_, tau);
            for (int axis = 0; axis < 3; ++axis) {
                // e2[k] : -1 = half_W[k] + step_a[k]*q_tau
                e2_[axis] = rounded(lifted(half_W_[axis], C::kCoefBits - 2) +
                    times(step_a_[axis], q_tau_), C::kCoefBits - 2);
                // f2[k] : -1 = V[k] + e2[k]*q_tau
                f2_[axis] = rounded(lifted(V_[axis][0], C::kCoefBits - 2) +
                    times(e2_[axis], q_tau_), C::kCoefBits - 2);
                // d[k] : -2 = f2[k]*q_tau
                d[axis] = rounded(times(f2_[axis], q_tau_), C::kCoefBits - 1);
            }
        }
        Steps::draw(d, tau, out);
    }

  private:
    void expand() {
        Coef B_[3] = {};                              // CoefBits -2 fraction bits: +-2
        Coef DP_[C::kMostOrder + 1] = {};             // CoefBits +1 fraction bits: +-0.25
        Coef DQ_[C::kMostOrder + 1] = {};             // CoefBits -4 fraction bits: +-8
        Coef DV_[3][C::kMostOrder + 1] = {};          // CoefBits +1 fraction bits: +-0.25
        Coef Dphi_[C::kMostOrder + 1] = {};           // CoefBits +0 fraction bits: +-0.5
        Coef Dx_[3][C::kMostOrder + 1] = {};          // CoefBits -2 fraction bits: +-2
        Coef M_[3] = {};                              // CoefBits -2 fraction bits: +-2
        Coef N_ = 0;                                  // CoefBits -1 fraction bits: +-1
        Coef Q_[C::kMostOrder + 1] = {};              // CoefBits -4 fraction bits: +-8
        Coef R_[C::kMostOrder + 1] = {};              // CoefBits -5 fraction bits: +-16
        Coef S_[C::kMostOrder + 1] = {};              // CoefBits -3 fraction bits: +-4
        Coef W_[3][C::kMostOrder + 1] = {};           // CoefBits +1 fraction bits: +-0.25
        Coef cube_ = 0;                               // CoefBits -4 fraction bits: +-8
        Coef e_[3] = {};                              // CoefBits -2 fraction bits: +-2
        Coef f_[3] = {};                              // CoefBits -2 fraction bits: +-2
        Coef m_ = 0;                                  // CoefBits -1 fraction bits: +-1
        Coef place_[3] = {};                          // CoefBits -2 fraction bits: +-2
        Coef z_ = 0;                                  // CoefBits +3 fraction bits: +-0.0625
        for (int axis = 0; axis < 3; ++axis) {
            // B[k] : -2 = b[k] + three_a[k]*v         # half of dV/dv
            B_[axis] = rounded(lifted(b_[axis], C::kCoefBits - 1) +
                times(three_a_[axis], v_), C::kCoefBits - 1);
            // M[k] : -2 = b[k] + 1/2 three_a[k]*v
            M_[axis] = rounded(lifted(b_[axis], C::kCoefBits) +
                times(three_a_[axis], v_), C::kCoefBits);
            // V[k] : -1 = c[k] + 2 M[k]*v
            V_[axis][0] = rounded(lifted(c_[axis], C::kCoefBits - 1) +
                2 * times(M_[axis], v_), C::kCoefBits - 2);
            // W[k] : +1 = 2 B[k] >> s
            W_[axis][0] = Steps::template scaled_down<64>(2 * Product(B_[axis]), 3, down());
            // half_W[k] : -1 = 1/2 W[k]
            half_W_[axis] = rounded(W_[axis][0], 3);
            // e[k] : -2 = b[k] + a[k]*v
            e_[axis] = rounded(lifted(b_[axis], C::kCoefBits - 1) +
                times(a_[axis], v_), C::kCoefBits - 1);
            // f[k] : -2 = c[k] + e[k]*v
            f_[axis] = rounded(lifted(c_[axis], C::kCoefBits - 1) +
                times(e_[axis], v_), C::kCoefBits - 1);
            // place[k] : -2 = f[k]*v
            place_[axis] = rounded(times(f_[axis], v_), C::kCoefBits - 1);
        }
        // N : -1 = V[*]*V[*]
        N_ = rounded(times(V_[0][0], V_[0][0]) + times(V_[1][0], V_[1][0]) +
            times(V_[2][0], V_[2][0]), C::kCoefBits - 1);
        // m : -1 = N*phi                          # phi onto 1 / |V|: a Newton step
        m_ = rounded(times(N_, phi_[0]), C::kCoefBits - 2);
        // z : +3 = 1 - m*phi
        z_ = rounded(lifted(1, 2 * C::kCoefBits - 3) - times(m_, phi_[0]), C::kCoefBits - 6);
        // phi : -2 = phi + 1/2 z*phi
        phi_[0] = rounded(lifted(phi_[0], C::kCoefBits + 4) + times(z_, phi_[0]), C::kCoefBits + 4);
        // S : -3 = phi*phi
        S_[0] = rounded(times(phi_[0], phi_[0]), C::kCoefBits - 1);
        // cube : -4 = S*phi
        cube_ = rounded(times(S_[0], phi_[0]), C::kCoefBits - 1);
        // Q : -4 = - cube
        Q_[0] = Coef(-Product(cube_));
        // R : -5 = -3 S
        R_[0] = rounded(-3 * Product(S_[0]), 2);
        Steps::place_origin(place_);
        for (int i = 1; i <= C::kOrder; ++i) {
            // q : -2 = phi'/i
            q_[i] = rounded(over(phi_[i - 1], i), C::kCoefBits - 1);
            if (i <= C::kOrder - 1) {
                for (int axis = 0; axis < 3; ++axis) {
                    // DV[k] : +1 = W[k]*Dq
                    DV_[axis][i] = rounded(series_times(W_[axis], phi_, i - 1), C::kCoefBits - 2);
                }
                // DP : +1 += V[k]*DV[k]
                DP_[i] = Coef(rounded(stieltjes(V_[0], DV_[0], i), C::kCoefBits - 1) +
                    rounded(stieltjes(V_[1], DV_[1], i), C::kCoefBits - 1) +
                    rounded(stieltjes(V_[2], DV_[2], i), C::kCoefBits - 1));
            }
            if (i <= C::kOrder - (C::kSeries ? 1 : 2)) {
                for (int axis = 0; axis < 3; ++axis) {
                    // V[k] : -1 = DV[k]/i
                    V_[axis][i] = rounded(over(DV_[axis][i], i), C::kCoefBits + 1);
                }
            }
            if (i <= C::kOrder - 2) {
                for (int axis = 0; axis < 3; ++axis) {
                    // W[k] : +1 = six_a[k]*q
                    W_[axis][i] = rounded(times(six_a_[axis], q_[i]), C::kCoefBits - 2);
                }
            }
            if (C::kSeries) {
                for (int axis = 0; axis < 3; ++axis) {
                    // Dx[k] : -2 = V[k]*Dq
                    Dx_[axis][i] = rounded(series_times(V_[axis], phi_, i - 1), C::kCoefBits - 1);
                    // x[k] : -2 = Dx[k]/i
                    x_[axis][i] = rounded(over(Dx_[axis][i], i), C::kCoefBits - 1);
                }
            }
            if (i <= C::kOrder - 1) {
                // Dphi : 0 = Q*DP
                Dphi_[i] = rounded(stieltjes(Q_, DP_, i), C::kCoefBits - 3);
                // phi : -2 = Dphi/i
                phi_[i] = rounded(over(Dphi_[i], i), C::kCoefBits + 1);
            }
            if (i <= C::kOrder - 2) {
                // DQ : -4 = R*Dphi
                DQ_[i] = rounded(stieltjes(R_, Dphi_, i), C::kCoefBits - 1);
                // Q : -4 = DQ/i
                Q_[i] = rounded(over(DQ_[i], i), C::kCoefBits - 1);
            }
            if (i <= C::kOrder - 3) {
                // S : -3 = phi*phi
                S_[i] = rounded(series_times(phi_, phi_, i), C::kCoefBits - 1);
                // R : -5 = -3 S
                R_[i] = rounded(-3 * Product(S_[i]), 2);
            }
        }
    }

    Coef V_[3][C::kMostOrder + 1] = {};           // CoefBits -1 fraction bits: +-1
    Coef a_[3] = {};                              // CoefBits -2 fraction bits: +-2
    Coef b_[3] = {};                              // CoefBits -2 fraction bits: +-2
    Coef c_[3] = {};                              // CoefBits -2 fraction bits: +-2
    Coef half_W_[3] = {};                         // CoefBits -1 fraction bits: +-1
    Coef phi_[C::kMostOrder + 1] = {};            // CoefBits -2 fraction bits: +-2
    Coef q_[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2
    Coef six_a_[3] = {};                          // CoefBits +1 fraction bits: +-0.25
    Coef step_a_[3] = {};                         // CoefBits -1 fraction bits: +-1
    Coef three_a_[3] = {};                        // CoefBits -2 fraction bits: +-2
    Coef v_ = 0;                                  // CoefBits -1 fraction bits: +-1
    Coef x_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
