// SPDX-License-Identifier: Apache-2.0
// [Chikurov] (30), Fig. 10: one Riemann integrator, three scalers, twelve Stieltjes integrators and
// one adder, with the factor 6 that the print of R_i lacks: R = -3 phi^2. A step of h = 2^k units
// is drawn in its own parameter q, v = v(0) + q h / 2^lambda, and in tau = s / h, so that the only
// step size in the equations is 1: dq = phi dtau, dW = 6a' dq, dV = W dq, dP = V.dV, dphi = Q dP,
// dQ = R dphi, in series mode dx = V dq. W = dV/dq and a' carry h / 2^lambda and its square: the
// longer the step, the larger they are. The planner keeps 1/2 < |V| < 1 for V = dr/dv / 2^lambda,
// |3a v + b| < 2, |a| < 2/3, and steps so short that every row keeps its range and m stays below 1,
// which the last step's phi may exceed where |V| comes near 1. With Anchor 1 v is the only state
// between steps: position, V, W and phi are made from it, and the Newton step squares phi's error.
// Chain of an order: DV, DP, adder, Dphi, phi; all but the last product of each sum is known
// before.
// Made by `curvecore curve kernel spline.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// A cubic r(v) = start + 2^lambda ((a v + b) v + c) v at constant path speed.
template <class C>
class SplineCurve : protected CurveSteps<C> {
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

    SplineCurve() = default;
    explicit SplineCurve(const C& format) : Steps(format, "spline", rows()) {}

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
        v_guarded = Steps::guarded(v_);
        for (int axis = 0; axis < 3; ++axis) {
            // three_a[k] : -2 = a[k] + 2 a[k]
            three_a_[axis] = keep(Row::three_a_, 0,
                Coef(Product(a_[axis]) + 2 * Product(a_[axis])));
            // step_a[k] : -1 = a[k] >> 2s
            step_a_[axis] = keep(Row::step_a_, 0,
                Steps::template scaled_down<64>(a_[axis], 1, 2 * down()));
            // six_a[k] : +1 = 2 three_a[k] >> 2s
            six_a_[axis] = keep(Row::six_a_, 0,
                Steps::template scaled_down<64>(2 * Product(three_a_[axis]), 3, 2 * down()));
        }
        anchor();
        orders();
    }

    /// Moves on to the next integration step.
    void step() {
        typename C::FineParameter gain_guarded = 0;   // the same, and ParameterGuard more
        Coef moved_ = 0;                              // CoefBits -2 fraction bits: +-2
        // moved : -2 = sum(q)
        moved_ = keep(Row::moved_, 0, Coef(sum(q_, C::kOrder)));
        // gain : -1 = moved >> s
        gain_guarded = Steps::template scaled_down<64,
            typename C::FineParameter>(moved_, 1 + C::kParameterGuard, down());
        // v : -1 = v + gain
        v_guarded = typename C::FineParameter(v_guarded + gain_guarded);
        v_ = keep(Row::v_, 0, Steps::unguarded(v_guarded));
        // phi : -2 = phi + sum(phi)
        phi_[0] = keep(Row::phi_, 0,
            Coef(Product(phi_[0]) + sum(phi_, C::kOrder - (C::kAnchor ? 1 : 0))));
        Steps::move_auxiliary();
        if (C::kAnchor) {
            anchor();
        } else {
            carry();
        }
        orders();
    }

    /// Sets the fine position at an offset of quanta into the present step.
    void sample(const Word<kLengthBits + 1>& offset, Fine* out) const {
        const Coef tau = Steps::tau_of(offset);
        Coef d[3];
        if (C::kSeries) {
            for (int axis = 0; axis < 3; ++axis) {
                d[axis] = Steps::in_tau(Row::x_, x_[axis], tau);
            }
        } else {
            Coef e2_[3] = {};                             // CoefBits -1 fraction bits: +-1
            Coef f2_[3] = {};                             // CoefBits -1 fraction bits: +-1
            Coef q_tau_ = 0;                              // CoefBits -2 fraction bits: +-2
            // q_tau : -2 = horner(q)
            q_tau_ = keep(Row::q_tau_, 0, Steps::in_tau(Row::q_, q_, tau));
            for (int axis = 0; axis < 3; ++axis) {
                // e2[k] : -1 = half_W[k] + step_a[k]*q_tau
                e2_[axis] = keep(Row::e2_, 0,
                    rounded(lifted(half_W_[axis], C::kCoefBits - 2) + times(step_a_[axis], q_tau_),
                    C::kCoefBits - 2));
                // f2[k] : -1 = V[k] + e2[k]*q_tau
                f2_[axis] = keep(Row::f2_, 0,
                    rounded(lifted(V_[axis][0], C::kCoefBits - 2) + times(e2_[axis], q_tau_),
                    C::kCoefBits - 2));
                // d[k] : -2 = f2[k]*q_tau
                d[axis] = keep(Row::d, 0, rounded(times(f2_[axis], q_tau_), C::kCoefBits - 1));
            }
        }
        Steps::draw(d, tau, out);
    }

  protected:  // the words of a step
    /// Makes what a step begins with.
    void anchor() {
        Coef B_[3] = {};                              // CoefBits -2 fraction bits: +-2
        Coef M_[3] = {};                              // CoefBits -2 fraction bits: +-2
        Coef N_ = 0;                                  // CoefBits -1 fraction bits: +-1
        Coef cube_ = 0;                               // CoefBits -4 fraction bits: +-8
        Coef m_ = 0;                                  // CoefBits -1 fraction bits: +-1
        Coef z_ = 0;                                  // CoefBits +3 fraction bits: +-0.0625
        for (int axis = 0; axis < 3; ++axis) {
            // B[k] : -2 = b[k] + three_a[k]*v         # half of dV/dv
            B_[axis] = keep(Row::B_, 0,
                rounded(lifted(b_[axis], C::kCoefBits - 1) + times(three_a_[axis], v_),
                C::kCoefBits - 1));
            // M[k] : -2 = b[k] + 1/2 three_a[k]*v
            M_[axis] = keep(Row::M_, 0,
                rounded(lifted(b_[axis], C::kCoefBits) + times(three_a_[axis], v_), C::kCoefBits));
            // V[k] : -1 = c[k] + 2 M[k]*v
            V_[axis][0] = keep(Row::V_, 0,
                rounded(lifted(c_[axis], C::kCoefBits - 1) + 2 * times(M_[axis], v_),
                C::kCoefBits - 2));
            // W[k] : +1 = 2 B[k] >> s
            W_[axis][0] = keep(Row::W_, 0,
                Steps::template scaled_down<64>(2 * Product(B_[axis]), 3, down()));
            // half_W[k] : -1 = 1/2 W[k]
            half_W_[axis] = keep(Row::half_W_, 0, rounded(W_[axis][0], 3));
            // e[k] : -2 = b[k] + a[k]*v
            e_[axis] = keep(Row::e_, 0,
                rounded(lifted(b_[axis], C::kCoefBits - 1) + times(a_[axis], v_),
                C::kCoefBits - 1));
            // f[k] : -2 = c[k] + e[k]*v
            f_[axis] = keep(Row::f_, 0,
                rounded(lifted(c_[axis], C::kCoefBits - 1) + times(e_[axis], v_),
                C::kCoefBits - 1));
            // place[k] : -2 = f[k]*v
            place_[axis] = keep(Row::place_, 0, rounded(times(f_[axis], v_), C::kCoefBits - 1));
        }
        // N : -1 = V[*]*V[*]
        N_ = keep(Row::N_, 0,
            rounded(times(V_[0][0], V_[0][0]) + times(V_[1][0], V_[1][0]) +
            times(V_[2][0], V_[2][0]), C::kCoefBits - 1));
        // m : -1 = N*phi                          # phi onto 1 / |V|: a Newton step
        m_ = keep(Row::m_, 0, rounded(times(N_, phi_[0]), C::kCoefBits - 2));
        // z : +3 = 1 - m*phi
        z_ = keep(Row::z_, 0,
            rounded(lifted(1, 2 * C::kCoefBits - 3) - times(m_, phi_[0]), C::kCoefBits - 6));
        // phi : -2 = phi + 1/2 z*phi
        phi_[0] = keep(Row::phi_, 0,
            rounded(lifted(phi_[0], C::kCoefBits + 4) + times(z_, phi_[0]), C::kCoefBits + 4));
        // S : -3 = phi*phi
        S_[0] = keep(Row::S_, 0, rounded(times(phi_[0], phi_[0]), C::kCoefBits - 1));
        // cube : -4 = S*phi
        cube_ = keep(Row::cube_, 0, rounded(times(S_[0], phi_[0]), C::kCoefBits - 1));
        // Q : -4 = - cube
        Q_[0] = keep(Row::Q_, 0, Coef(-Product(cube_)));
        // R : -5 = -3 S
        R_[0] = keep(Row::R_, 0, rounded(-3 * Product(S_[0]), 2));
        Steps::place_origin(place_);
    }
    /// The same with Anchor 0, of the step before.
    void carry() {
        Coef move_[3] = {};                           // CoefBits -2 fraction bits: +-2
        for (int axis = 0; axis < 3; ++axis) {
            // V[k] : -1 = V[k] + sum(V[k])
            V_[axis][0] = keep(Row::V_, 0, Coef(Product(V_[axis][0]) + sum(V_[axis], C::kOrder)));
            // W[k] : +1 = W[k] + sum(W[k])
            W_[axis][0] = keep(Row::W_, 0, Coef(Product(W_[axis][0]) + sum(W_[axis], C::kOrder)));
            // half_W[k] : -1 = 1/2 W[k]
            half_W_[axis] = keep(Row::half_W_, 0, rounded(W_[axis][0], 3));
        }
        // Q : -4 = Q + sum(Q)
        Q_[0] = keep(Row::Q_, 0, Coef(Product(Q_[0]) + sum(Q_, C::kOrder)));
        // R : -5 = R + sum(R)
        R_[0] = keep(Row::R_, 0, Coef(Product(R_[0]) + sum(R_, C::kOrder)));
        for (int axis = 0; axis < 3; ++axis) {
            // e[k] : -2 = b[k] + a[k]*v
            e_[axis] = keep(Row::e_, 0,
                rounded(lifted(b_[axis], C::kCoefBits - 1) + times(a_[axis], v_),
                C::kCoefBits - 1));
            // f[k] : -2 = c[k] + e[k]*v
            f_[axis] = keep(Row::f_, 0,
                rounded(lifted(c_[axis], C::kCoefBits - 1) + times(e_[axis], v_),
                C::kCoefBits - 1));
            // place[k] : -2 = f[k]*v
            place_[axis] = keep(Row::place_, 0, rounded(times(f_[axis], v_), C::kCoefBits - 1));
            // move[k] : -2 = sum(x[k])
            move_[axis] = keep(Row::move_, 0, Coef(sum(x_[axis], C::kOrder)));
        }
        if (C::kSeries) {
            Steps::move_origin(move_);
        } else {
            Steps::place_origin(place_);
        }
    }

    /// Makes the orders of a step's series.
    void orders() {
        Coef DP_[C::kMostOrder + 1] = {};             // CoefBits +1 fraction bits: +-0.25
        Coef DQ_[C::kMostOrder + 1] = {};             // CoefBits -4 fraction bits: +-8
        Coef DV_[3][C::kMostOrder + 1] = {};          // CoefBits +1 fraction bits: +-0.25
        Coef Dphi_[C::kMostOrder + 1] = {};           // CoefBits +0 fraction bits: +-0.5
        Coef Dx_[3][C::kMostOrder + 1] = {};          // CoefBits -2 fraction bits: +-2
        for (int i = 1; i <= C::kOrder; ++i) {
            // q : -2 = phi'/i
            q_[i] = keep(Row::q_, i, rounded(over(phi_[i - 1], i), C::kCoefBits - 1));
            if (!C::kAnchor || i <= C::kOrder - 1) {
                for (int axis = 0; axis < 3; ++axis) {
                    // DV[k] : +1 = W[k]*Dq
                    DV_[axis][i] = keep(Row::DV_, i,
                        rounded(series_times(W_[axis], phi_, i - 1), C::kCoefBits - 2));
                }
                // DP : +1 += V[k]*DV[k]
                DP_[i] = keep(Row::DP_, i,
                    Coef(rounded(stieltjes(V_[0], DV_[0], i), C::kCoefBits - 1) +
                    rounded(stieltjes(V_[1], DV_[1], i), C::kCoefBits - 1) +
                    rounded(stieltjes(V_[2], DV_[2], i), C::kCoefBits - 1)));
            }
            if (!C::kAnchor || i <= C::kOrder - (C::kSeries ? 1 : 2)) {
                for (int axis = 0; axis < 3; ++axis) {
                    // V[k] : -1 = DV[k]/i
                    V_[axis][i] = keep(Row::V_, i,
                        rounded(over(DV_[axis][i], i), C::kCoefBits + 1));
                }
            }
            if (!C::kAnchor || i <= C::kOrder - 2) {
                for (int axis = 0; axis < 3; ++axis) {
                    // W[k] : +1 = six_a[k]*q
                    W_[axis][i] = keep(Row::W_, i,
                        rounded(times(six_a_[axis], q_[i]), C::kCoefBits - 2));
                }
            }
            if (C::kSeries) {
                for (int axis = 0; axis < 3; ++axis) {
                    // Dx[k] : -2 = V[k]*Dq
                    Dx_[axis][i] = keep(Row::Dx_, i,
                        rounded(series_times(V_[axis], phi_, i - 1), C::kCoefBits - 1));
                    // x[k] : -2 = Dx[k]/i
                    x_[axis][i] = keep(Row::x_, i,
                        rounded(over(Dx_[axis][i], i), C::kCoefBits - 1));
                }
            }
            if (!C::kAnchor || i <= C::kOrder - 1) {
                // Dphi : 0 = Q*DP
                Dphi_[i] = keep(Row::Dphi_, i, rounded(stieltjes(Q_, DP_, i), C::kCoefBits - 3));
                // phi : -2 = Dphi/i
                phi_[i] = keep(Row::phi_, i, rounded(over(Dphi_[i], i), C::kCoefBits + 1));
            }
            if (!C::kAnchor || i <= C::kOrder - 2) {
                // DQ : -4 = R*Dphi
                DQ_[i] = keep(Row::DQ_, i, rounded(stieltjes(R_, Dphi_, i), C::kCoefBits - 1));
                // Q : -4 = DQ/i
                Q_[i] = keep(Row::Q_, i, rounded(over(DQ_[i], i), C::kCoefBits - 1));
            }
            if (!C::kAnchor || i <= C::kOrder - 3) {
                // S : -3 = phi*phi
                S_[i] = keep(Row::S_, i, rounded(series_times(phi_, phi_, i), C::kCoefBits - 1));
                // R : -5 = -3 S
                R_[i] = keep(Row::R_, i, rounded(-3 * Product(S_[i]), 2));
            }
        }
    }

    Coef Q_[C::kMostOrder + 1] = {};              // CoefBits -4 fraction bits: +-8
    Coef R_[C::kMostOrder + 1] = {};              // CoefBits -5 fraction bits: +-16
    Coef S_[C::kMostOrder + 1] = {};              // CoefBits -3 fraction bits: +-4
    Coef V_[3][C::kMostOrder + 1] = {};           // CoefBits -1 fraction bits: +-1
    Coef W_[3][C::kMostOrder + 1] = {};           // CoefBits +1 fraction bits: +-0.25
    Coef a_[3] = {};                              // CoefBits -2 fraction bits: +-2
    Coef b_[3] = {};                              // CoefBits -2 fraction bits: +-2
    Coef c_[3] = {};                              // CoefBits -2 fraction bits: +-2
    Coef e_[3] = {};                              // CoefBits -2 fraction bits: +-2
    Coef f_[3] = {};                              // CoefBits -2 fraction bits: +-2
    Coef half_W_[3] = {};                         // CoefBits -1 fraction bits: +-1
    Coef phi_[C::kMostOrder + 1] = {};            // CoefBits -2 fraction bits: +-2
    Coef place_[3] = {};                          // CoefBits -2 fraction bits: +-2
    Coef q_[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2
    Coef six_a_[3] = {};                          // CoefBits +1 fraction bits: +-0.25
    Coef step_a_[3] = {};                         // CoefBits -1 fraction bits: +-1
    Coef three_a_[3] = {};                        // CoefBits -2 fraction bits: +-2
    Coef v_ = 0;                                  // CoefBits -1 fraction bits: +-1
    typename C::FineParameter v_guarded = 0;      // the same, and ParameterGuard more
    Coef x_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2

  private:
    enum class Row { B_, DP_, DQ_, DV_, Dphi_, Dx_, M_, N_, Q_, R_, S_, V_, W_, a_, b_, c_,
                    cube_, d, e_, e2_, f_, f2_, half_W_, m_, move_, moved_, phi_, place_,
                    q_, q_tau_, six_a_, step_a_, three_a_, v_, x_, z_ };
    /// Names and fraction bits of the rows, for a format that notes their ranges.
    static const WordRow* rows() {
        static constexpr WordRow kRows[] = {
            {"B", -2},
            {"DP", 1},
            {"DQ", -4},
            {"DV", 1},
            {"Dphi", 0},
            {"Dx", -2},
            {"M", -2},
            {"N", -1},
            {"Q", -4},
            {"R", -5},
            {"S", -3},
            {"V", -1},
            {"W", 1},
            {"a", -2},
            {"b", -2},
            {"c", -2},
            {"cube", -4},
            {"d", -2},
            {"e", -2},
            {"e2", -1},
            {"f", -2},
            {"f2", -1},
            {"half_W", -1},
            {"m", -1},
            {"move", -2},
            {"moved", -2},
            {"phi", -2},
            {"place", -2},
            {"q", -2},
            {"q_tau", -2},
            {"six_a", 1},
            {"step_a", -1},
            {"three_a", -2},
            {"v", -1},
            {"x", -2},
            {"z", 3},
            {nullptr, 0}};
        return kRows;
    }
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
