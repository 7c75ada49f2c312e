// SPDX-License-Identifier: Apache-2.0
// [Chikurov] (19), Fig. 8: six Riemann integrators, of the unit vectors n = r/R (the paper's x y z)
// and t = B x r/R (F G H): dn = phi t ds, dt = -phi n ds. A step of h = 2^k units has theta = h
// phi. Orders i >= 1 are scaled by the step, not by the radius (N_i = n_i / theta), so that none
// exceeds 1 and the displacement's series in tau = s/h has just these, in units of 2^k. In
// polynomial mode r = n cos + t sin from the two series of the angle in tau^2.
// Made by `curvecore curve kernel arc.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// A line, an arc in any plane or a helix.
template <class C>
class ArcCurve : protected CurveSteps<C> {
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

    ArcCurve() = default;
    explicit ArcCurve(const C& format) : Steps(format, "arc", rows()) {}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {
        Steps::open(segment);
        theta_ = segment.theta;
        for (int axis = 0; axis < 3; ++axis) {
            advance_[axis] = segment.advance[axis];
            n_[axis] = segment.normal[axis];
            t_[axis] = segment.tangent[axis];
        }
        anchor();
        orders();
    }

    /// Moves on to the next integration step.
    void step() {
        Coef move_[3] = {};                           // CoefBits -2 fraction bits: +-2
        Coef sum_N_[3] = {};                          // CoefBits -2 fraction bits: +-2
        Coef sum_T_[3] = {};                          // CoefBits -2 fraction bits: +-2
        for (int axis = 0; axis < 3; ++axis) {
            // sum_N[k] : -2 = sum(N[k])
            sum_N_[axis] = keep(Row::sum_N_, 0, Coef(sum(N_[axis], C::kOrder)));
            // sum_T[k] : -2 = sum(T[k])
            sum_T_[axis] = keep(Row::sum_T_, 0, Coef(sum(T_[axis], C::kOrder)));
            // n[k] : -2 = n[k] + theta*sum_N[k]
            n_[axis] = keep(Row::n_, 0,
                rounded(lifted(n_[axis], C::kCoefBits - 1) + times(theta_, sum_N_[axis]),
                C::kCoefBits - 1));
            // t[k] : -2 = t[k] + theta*sum_T[k]
            t_[axis] = keep(Row::t_, 0,
                rounded(lifted(t_[axis], C::kCoefBits - 1) + times(theta_, sum_T_[axis]),
                C::kCoefBits - 1));
            // move[k] : -2 = sum(c[k])
            move_[axis] = keep(Row::move_, 0, Coef(sum(c_[axis], C::kOrder)));
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
        if (C::kSeries) {
            for (int axis = 0; axis < 3; ++axis) {
                d[axis] = Steps::in_tau(Row::c_, c_[axis], tau);
            }
        } else {
            Coef inward_[3] = {};                         // CoefBits -2 fraction bits: +-2
            Coef rate_[3] = {};                           // CoefBits -2 fraction bits: +-2
            Coef sine_ = 0;                               // CoefBits -2 fraction bits: +-2
            Coef tau2_ = 0;                               // CoefBits -1 fraction bits: +-1
            Coef versine_ = 0;                            // CoefBits -2 fraction bits: +-2
            // tau2 : -1 = tau*tau
            tau2_ = keep(Row::tau2_, 0, rounded(times(tau, tau), C::kCoefBits - 1));
            // sine : -2 = odd(y, tau2)
            sine_ = keep(Row::sine_, 0, odd(Row::y_, y_, tau2_, C::kCoefBits - 1));
            // versine : -2 = even(z, tau2)
            versine_ = keep(Row::versine_, 0, even(Row::z_, z_, tau2_, C::kCoefBits - 1));
            for (int axis = 0; axis < 3; ++axis) {
                // rate[k] : -2 = advance[k] + t[k]*sine
                rate_[axis] = keep(Row::rate_, 0,
                    rounded(lifted(advance_[axis], C::kCoefBits - 2) + times(t_[axis], sine_),
                    C::kCoefBits - 2));
                // inward[k] : -2 = n[k]*versine
                inward_[axis] = keep(Row::inward_, 0,
                    rounded(times(n_[axis], versine_), C::kCoefBits - 2));
                // d[k] : -2 = inward[k] + rate[k]*tau
                d[axis] = keep(Row::d, 0,
                    rounded(lifted(inward_[axis], C::kCoefBits - 1) + times(rate_[axis], tau),
                    C::kCoefBits - 1));
            }
        }
        Steps::draw(d, tau, out);
    }

  protected:  // the words of a step
    /// Makes what a step begins with.
    void anchor() {
        for (int axis = 0; axis < 3; ++axis) {
            // N[k].1 : -2 = t[k]
            N_[axis][1] = keep(Row::N_, 1, Coef(t_[axis]));
            // T[k].1 : -2 = - n[k]
            T_[axis][1] = keep(Row::T_, 1, Coef(-Product(n_[axis])));
            // c[k].1 : -2 = t[k] + advance[k]
            c_[axis][1] = keep(Row::c_, 1, Coef(Product(t_[axis]) + Product(advance_[axis])));
        }
        // y.1 : -2 = 1                            # sine and versine of the angle, Fig. 2
        y_[1] = keep(Row::y_, 1, Coef(lifted(1, C::kCoefBits - 2)));
        // z.1 : -2 = 0
        z_[1] = keep(Row::z_, 1, Coef(lifted(0, C::kCoefBits - 2)));
    }

    /// Makes the orders of a step's series.
    void orders() {
        Coef w_[C::kMostOrder + 1] = {};              // CoefBits -1 fraction bits: +-1
        for (int i = 1; i <= C::kOrder; ++i) {
            // w : -1 = theta/i
            w_[i] = keep(Row::w_, i, rounded(over(theta_, i), C::kCoefBits - 1));
            if (i > 1) {
                for (int axis = 0; axis < 3; ++axis) {
                    // N[k] : -2 = w@T[k]'
                    N_[axis][i] = keep(Row::N_, i,
                        rounded(times(w_[i], T_[axis][i - 1]), C::kCoefBits - 1));
                    // T[k] : -2 = - w@N[k]'
                    T_[axis][i] = keep(Row::T_, i,
                        rounded(-times(w_[i], N_[axis][i - 1]), C::kCoefBits - 1));
                    // c[k] : -2 = N[k]
                    c_[axis][i] = keep(Row::c_, i, Coef(N_[axis][i]));
                }
            }
            if (i > 1 && !C::kSeries) {
                // y : -2 = w@z'
                y_[i] = keep(Row::y_, i, rounded(times(w_[i], z_[i - 1]), C::kCoefBits - 1));
                // z : -2 = - w@y'
                z_[i] = keep(Row::z_, i, rounded(-times(w_[i], y_[i - 1]), C::kCoefBits - 1));
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

  private:
    enum class Row { N_, T_, advance_, c_, d, inward_, move_, n_, rate_, sine_, sum_N_,
                    sum_T_, t_, tau2_, theta_, versine_, w_, y_, z_ };
    /// Names and fraction bits of the rows, for a format that notes their ranges.
    static const WordRow* rows() {
        static constexpr WordRow kRows[] = {
            {"N", -2},
            {"T", -2},
            {"advance", -2},
            {"c", -2},
            {"d", -2},
            {"inward", -2},
            {"move", -2},
            {"n", -2},
            {"rate", -2},
            {"sine", -2},
            {"sum_N", -2},
            {"sum_T", -2},
            {"t", -2},
            {"tau2", -1},
            {"theta", -1},
            {"versine", -2},
            {"w", -1},
            {"y", -2},
            {"z", -2},
            {nullptr, 0}};
        return kRows;
    }
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
