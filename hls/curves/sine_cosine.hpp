// SPDX-License-Identifier: Apache-2.0
// [Chikurov] Fig. 2: two Riemann integrators, dy = z dphi, dz = -y dphi, scaled by a step of theta.
// The spherical network, Fig. 8, is three of these.
// Made by `curvecore curve kernel sine_cosine.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// Sine and cosine.
template <class C>
class SineCosineNetwork : protected CurveSteps<C> {
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

    SineCosineNetwork() = default;
    explicit SineCosineNetwork(const C& format) : Steps(format, "sine_cosine", rows()) {}

    /// Begins with a first step.
    void load(const Coef& theta, const Coef& y, const Coef& z) {
        theta_ = theta;
        y_[0] = y;
        z_[0] = z;
        anchor();
        orders();
    }

    /// Moves on to the next integration step.
    void step() {
        Coef sum_y_ = 0;                              // CoefBits -2 fraction bits: +-2
        Coef sum_z_ = 0;                              // CoefBits -2 fraction bits: +-2
        // sum_y : -2 = sum(y)
        sum_y_ = keep(Row::sum_y_, 0, Coef(sum(y_, C::kOrder)));
        // sum_z : -2 = sum(z)
        sum_z_ = keep(Row::sum_z_, 0, Coef(sum(z_, C::kOrder)));
        // y : -2 = y + theta*sum_y
        y_[0] = keep(Row::y_, 0,
            rounded(lifted(y_[0], C::kCoefBits - 1) + times(theta_, sum_y_), C::kCoefBits - 1));
        // z : -2 = z + theta*sum_z
        z_[0] = keep(Row::z_, 0,
            rounded(lifted(z_[0], C::kCoefBits - 1) + times(theta_, sum_z_), C::kCoefBits - 1));
        anchor();
        orders();
    }

  public:  // the words of a step
    /// Makes what a step begins with.
    void anchor() {
        // y.1 : -2 = z
        y_[1] = keep(Row::y_, 1, Coef(z_[0]));
        // z.1 : -2 = - y
        z_[1] = keep(Row::z_, 1, Coef(-Product(y_[0])));
    }

    /// Makes the orders of a step's series.
    void orders() {
        Coef w_[C::kMostOrder + 1] = {};              // CoefBits -1 fraction bits: +-1
        for (int i = 1; i <= C::kOrder; ++i) {
            // w : -1 = theta/i
            w_[i] = keep(Row::w_, i, rounded(over(theta_, i), C::kCoefBits - 1));
            if (i > 1) {
                // y : -2 = w@z'
                y_[i] = keep(Row::y_, i, rounded(times(w_[i], z_[i - 1]), C::kCoefBits - 1));
                // z : -2 = - w@y'
                z_[i] = keep(Row::z_, i, rounded(-times(w_[i], y_[i - 1]), C::kCoefBits - 1));
            }
        }
    }

    Coef theta_ = 0;                              // CoefBits -1 fraction bits: +-1
    Coef y_[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2
    Coef z_[C::kMostOrder + 1] = {};              // CoefBits -2 fraction bits: +-2

  private:
    enum class Row { sum_y_, sum_z_, theta_, w_, y_, z_ };
    /// Names and fraction bits of the rows, for a format that notes their ranges.
    static const WordRow* rows() {
        static constexpr WordRow kRows[] = {
            {"sum_y", -2},
            {"sum_z", -2},
            {"theta", -1},
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
