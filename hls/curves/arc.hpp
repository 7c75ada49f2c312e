// SPDX-License-Identifier: Apache-2.0
// Fig. 8, coefficients scaled by the step: hls/spherical_kernel.hpp.
// Made by `curvecore curve kernel arc.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// A line, an arc in any plane or a helix.
template <class C>
class ArcCurve : private CurveSteps<C> {
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

    ArcCurve() = default;
    explicit ArcCurve(const C& format) : Steps(format) {}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {
        Steps::open(segment);
        theta_ = segment.theta;
        for (int axis = 0; axis < 3; ++axis) {
            advance_[axis] = segment.advance[axis];
            n_[axis] = segment.normal[axis];
            t_[axis] = segment.tangent[axis];
        }
        expand();
    }

    /// Moves on to the next integration step.
    void step() {
        Coef move_[3] = {};                           // CoefBits -2 fraction bits: +-2
        Coef sum_N_[3] = {};                          // CoefBits -2 fraction bits: +-2
        Coef sum_T_[3] = {};                          // CoefBits -2 fraction bits: +-2
        for (int axis = 0; axis < 3; ++axis) {
            // sum_N[k] : -2 = sum(N[k])
            sum_N_[axis] = Coef(sum(N_[axis], C::kOrder));
            // sum_T[k] : -2 = sum(T[k])
            sum_T_[axis] = Coef(sum(T_[axis], C::kOrder));
            // n[k] : -2 = n[k] + theta*sum_N[k]
            n_[axis] = rounded(lifted(n_[axis], C::kCoefBits - 1) +
                times(theta_, sum_N_[axis]), C::kCoefBits - 1);
            // t[k] : -2 = t[k] + theta*sum_T[k]
            t_[axis] = rounded(lifted(t_[axis], C::kCoefBits - 1) +
                times(theta_, sum_T_[axis]), C::kCoefBits - 1);
            // move[k] : -2 = sum(c[k])
            move_[axis] = Coef(sum(c_[axis], C::kOrder));
        }
        Steps::move_origin(move_);
        Steps::move_auxiliary();
        expand();
    }

    /// Sets the fine position at an offset of quanta into the present step.
    void sample(const Word<kLengthBits + 1>& offset, Fine* out) const {
        const Coef tau = Steps::tau_of(offset);
        Coef d[3];
        if (C::kSeries) {
            for (int axis = 0; axis < 3; ++axis) {
                d[axis] = Steps::in_tau(c_[axis], tau);
            }
        } else {
            Coef inward_[3] = {};                         // CoefBits -2 fraction bits: +-2
            Coef rate_[3] = {};                           // CoefBits -2 fraction bits: +-2
            Coef sine_ = 0;                               // CoefBits -2 fraction bits: +-2
            Coef tau2_ = 0;                               // CoefBits -1 fraction bits: +-1
            Coef versine_ = 0;                            // CoefBits -2 fraction bits: +-2
            // tau2 : -1 = tau*tau
            tau2_ = rounded(times(tau, tau), C::kCoefBits - 1);
            // sine : -2 = odd(y, tau2)
            sine_ = odd(y_, tau2_, C::kCoefBits - 1);
            // versine : -2 = even(z, tau2)
            versine_ = even(z_, tau2_, C::kCoefBits - 1);
            for (int axis = 0; axis < 3; ++axis) {
                // rate[k] : -2 = advance[k] + t[k]*sine
                rate_[axis] = rounded(lifted(advance_[axis], C::kCoefBits - 2) +
                    times(t_[axis], sine_), C::kCoefBits - 2);
                // inward[k] : -2 = n[k]*versine
                inward_[axis] = rounded(times(n_[axis], versine_), C::kCoefBits - 2);
                // d[k] : -2 = inward[k] + rate[k]*tau
                d[axis] = rounded(lifted(inward_[axis], C::kCoefBits - 1) +
                    times(rate_[axis], tau), C::kCoefBits - 1);
            }
        }
        Steps::draw(d, tau, out);
    }

  private:
    void expand() {
        Coef w_[C::kMostOrder + 1] = {};              // CoefBits -1 fraction bits: +-1
        for (int axis = 0; axis < 3; ++axis) {
            // N[k].1 : -2 = t[k]
            N_[axis][1] = Coef(t_[axis]);
            // T[k].1 : -2 = - n[k]
            T_[axis][1] = Coef(-Product(n_[axis]));
            // c[k].1 : -2 = t[k] + advance[k]
            c_[axis][1] = Coef(Product(t_[axis]) + Product(advance_[axis]));
        }
        // y.1 : -2 = 1                            # sine and versine of the angle, Fig. 2
        y_[1] = Coef(lifted(1, C::kCoefBits - 2));
        // z.1 : -2 = 0
        z_[1] = Coef(lifted(0, C::kCoefBits - 2));
        for (int i = 1; i <= C::kOrder; ++i) {
            // w : -1 = theta/i
            w_[i] = rounded(over(theta_, i), C::kCoefBits - 1);
            if (i > 1) {
                for (int axis = 0; axis < 3; ++axis) {
                    // N[k] : -2 = w@T[k]'
                    N_[axis][i] = rounded(times(w_[i], T_[axis][i - 1]), C::kCoefBits - 1);
                    // T[k] : -2 = - w@N[k]'
                    T_[axis][i] = rounded(-times(w_[i], N_[axis][i - 1]), C::kCoefBits - 1);
                    // c[k] : -2 = N[k]
                    c_[axis][i] = Coef(N_[axis][i]);
                }
            }
            if (i > 1 && !C::kSeries) {
                // y : -2 = w@z'
                y_[i] = rounded(times(w_[i], z_[i - 1]), C::kCoefBits - 1);
                // z : -2 = - w@y'
                z_[i] = rounded(-times(w_[i], y_[i - 1]), C::kCoefBits - 1);
            }
        }
    }

    Coef N_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
    Coef T_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
    Coef advance_[3] = {};                        // CoefBits -2 fraction bits: +-2
    Coef c_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
    Coef n_[3] = {};                              // CoefBits -2 fraction bits: +-2
    Coef t_[3] = {};                              // CoefBits -2 fraction bits: +-2
    Coef theta_ = 0;                              // CoefBits -1 fraction bits: +-1
    Coef y_[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2
    Coef z_[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
