// SPDX-License-Identifier: Apache-2.0
// V' = W phi, W' = X phi, X' = Y phi, Y' = Z phi at constant path speed: phi = 1/|V|, phi' = -phi^3
// V V'.
// Made by `curvecore curve kernel quintic.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// A quintic at constant path speed, by its derivatives in its parameter.
template <class C>
class QuinticCurve : protected CurveSteps<C> {
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
    static constexpr int kFurther = 7;  // words of a segment that are the table's own

    QuinticCurve() = default;
    explicit QuinticCurve(const C& format) : Steps(format, "quintic", rows()) {}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {
        Steps::open(segment);
        phi_[0] = segment.further[6];
        for (int axis = 0; axis < 3; ++axis) {
            X_[axis][0] = segment.advance[axis];
            Y_[axis][0] = segment.further[0 + axis];
            Z_[axis] = segment.further[3 + axis];
            W_[axis][0] = segment.normal[axis];
            V_[axis][0] = segment.tangent[axis];
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
            // V[k] : -2 = V[k] + sum(V[k])
            V_[axis][0] = keep(Row::V_, 0, Coef(Product(V_[axis][0]) + sum(V_[axis], C::kOrder)));
            // W[k] : -2 = W[k] + sum(W[k])
            W_[axis][0] = keep(Row::W_, 0, Coef(Product(W_[axis][0]) + sum(W_[axis], C::kOrder)));
            // X[k] : 0 = X[k] + sum(X[k])
            X_[axis][0] = keep(Row::X_, 0, Coef(Product(X_[axis][0]) + sum(X_[axis], C::kOrder)));
            // Y[k] : 0 = Y[k] + sum(Y[k])
            Y_[axis][0] = keep(Row::Y_, 0, Coef(Product(Y_[axis][0]) + sum(Y_[axis], C::kOrder)));
        }
        // phi : -2 = phi + sum(phi)
        phi_[0] = keep(Row::phi_, 0, Coef(Product(phi_[0]) + sum(phi_, C::kOrder)));
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
        // S : -4 = phi*phi
        S_[0] = keep(Row::S_, 0, rounded(times(phi_[0], phi_[0]), C::kCoefBits));
        // Q : -4 = - S*phi
        Q_[0] = keep(Row::Q_, 0, rounded(-times(S_[0], phi_[0]), C::kCoefBits - 2));
        for (int axis = 0; axis < 3; ++axis) {
            // T[k] : -2 = V[k]*phi
            T_[axis][0] = keep(Row::T_, 0, rounded(times(V_[axis][0], phi_[0]), C::kCoefBits - 2));
        }
    }

    /// Makes the orders of a step's series.
    void orders() {
        Coef DG_[C::kMostOrder + 1] = {};             // CoefBits -2 fraction bits: +-2
        Coef DV_[3][C::kMostOrder + 1] = {};          // CoefBits +0 fraction bits: +-0.5
        Coef DW_[3][C::kMostOrder + 1] = {};          // CoefBits +0 fraction bits: +-0.5
        Coef DX_[3][C::kMostOrder + 1] = {};          // CoefBits +0 fraction bits: +-0.5
        Coef DY_[3][C::kMostOrder + 1] = {};          // CoefBits +0 fraction bits: +-0.5
        Coef Dphi_[C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
        for (int i = 1; i <= C::kOrder; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                // DV[k] : 0 = W[k]*Du
                DV_[axis][i] = keep(Row::DV_, i,
                    rounded(series_times(W_[axis], phi_, i - 1), C::kCoefBits - 4));
                // DW[k] : 0 = X[k]*Du
                DW_[axis][i] = keep(Row::DW_, i,
                    rounded(series_times(X_[axis], phi_, i - 1), C::kCoefBits - 2));
                // DX[k] : 0 = Y[k]*Du
                DX_[axis][i] = keep(Row::DX_, i,
                    rounded(series_times(Y_[axis], phi_, i - 1), C::kCoefBits - 2));
                // DY[k] : 0 = Z[k]*phi'
                DY_[axis][i] = keep(Row::DY_, i,
                    rounded(times(Z_[axis], phi_[i - 1]), C::kCoefBits - 2));
                // V[k] : -2 = DV[k]/i
                V_[axis][i] = keep(Row::V_, i, rounded(over(DV_[axis][i], i), C::kCoefBits + 1));
                // W[k] : -2 = DW[k]/i
                W_[axis][i] = keep(Row::W_, i, rounded(over(DW_[axis][i], i), C::kCoefBits + 1));
                // X[k] : 0 = DX[k]/i
                X_[axis][i] = keep(Row::X_, i, rounded(over(DX_[axis][i], i), C::kCoefBits - 1));
                // Y[k] : 0 = DY[k]/i
                Y_[axis][i] = keep(Row::Y_, i, rounded(over(DY_[axis][i], i), C::kCoefBits - 1));
            }
            // DG : -2 += V[k]*DV[k]
            DG_[i] = keep(Row::DG_, i,
                Coef(rounded(stieltjes(V_[0], DV_[0], i), C::kCoefBits) +
                rounded(stieltjes(V_[1], DV_[1], i), C::kCoefBits) +
                rounded(stieltjes(V_[2], DV_[2], i), C::kCoefBits)));
            // Dphi : -2 = Q*DG
            Dphi_[i] = keep(Row::Dphi_, i, rounded(stieltjes(Q_, DG_, i), C::kCoefBits - 4));
            // phi : -2 = Dphi/i
            phi_[i] = keep(Row::phi_, i, rounded(over(Dphi_[i], i), C::kCoefBits - 1));
            if (i <= C::kOrder - 1) {
                // S : -4 = phi*phi
                S_[i] = keep(Row::S_, i, rounded(series_times(phi_, phi_, i), C::kCoefBits));
                // Q : -4 = - S*phi
                Q_[i] = keep(Row::Q_, i, rounded(-series_times(S_, phi_, i), C::kCoefBits - 2));
                for (int axis = 0; axis < 3; ++axis) {
                    // T[k] : -2 = V[k]*phi
                    T_[axis][i] = keep(Row::T_, i,
                        rounded(series_times(V_[axis], phi_, i), C::kCoefBits - 2));
                }
            }
            for (int axis = 0; axis < 3; ++axis) {
                // x[k] : -2 = T[k]'/i
                x_[axis][i] = keep(Row::x_, i, rounded(over(T_[axis][i - 1], i), C::kCoefBits - 1));
            }
        }
    }

    Coef Q_[C::kMostOrder + 1] = {};              // CoefBits -4 fraction bits: +-8
    Coef S_[C::kMostOrder + 1] = {};              // CoefBits -4 fraction bits: +-8
    Coef T_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
    Coef V_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
    Coef W_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2
    Coef X_[3][C::kMostOrder + 1] = {};           // CoefBits +0 fraction bits: +-0.5
    Coef Y_[3][C::kMostOrder + 1] = {};           // CoefBits +0 fraction bits: +-0.5
    Coef Z_[3] = {};                              // CoefBits +0 fraction bits: +-0.5
    Coef phi_[C::kMostOrder + 1] = {};            // CoefBits -2 fraction bits: +-2
    Coef x_[3][C::kMostOrder + 1] = {};           // CoefBits -2 fraction bits: +-2

  private:
    enum class Row { DG_, DV_, DW_, DX_, DY_, Dphi_, Q_, S_, T_, V_, W_, X_, Y_, Z_, move_,
                    phi_, x_ };
    /// Names and fraction bits of the rows, for a format that notes their ranges.
    static const WordRow* rows() {
        static constexpr WordRow kRows[] = {
            {"DG", -2},
            {"DV", 0},
            {"DW", 0},
            {"DX", 0},
            {"DY", 0},
            {"Dphi", -2},
            {"Q", -4},
            {"S", -4},
            {"T", -2},
            {"V", -2},
            {"W", -2},
            {"X", 0},
            {"Y", 0},
            {"Z", 0},
            {"move", -2},
            {"phi", -2},
            {"x", -2},
            {nullptr, 0}};
        return kRows;
    }
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
