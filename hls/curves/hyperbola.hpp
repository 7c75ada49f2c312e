// SPDX-License-Identifier: Apache-2.0
// [Chikurov] Fig. 3, y = 1 / (k (t0 + t)): one Riemann and one Stieltjes integrator, dy = z dt, dz
// = -2 k y dy. In a step of h, y is carried as h k y = h / (t0 + t), z as h^2 k z, time as tau = t
// / h, so that the equations have no number but the start word: dy = z dtau, dz = -2 y dy. Legal: 0
// < y < 1/2 at the start, t0 > 2 h; then y falls, y_i is at most 2^-(i+1), z_i at most 1/4. A y
// below 2^-b loses b bits, and y^2 loses 2 b: y stops when its square rounds to 0. (15)'s integral
// of y dy is half the square: z_i has no product by 1/i. With Anchor 0 nothing pulls C = z + y^2
// back to 0: y falls through 0 in the end, and leaves its range.
// Made by `curvecore curve kernel hyperbola.net`: each line stands above its statement.
#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// The hyperbola y = 1 / (k (t0 + t)).
template <class C>
class HyperbolaNetwork : protected CurveSteps<C> {
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

    HyperbolaNetwork() = default;
    explicit HyperbolaNetwork(const C& format) : Steps(format, "hyperbola", rows()) {}

    /// Begins with a first step.
    void load(const Coef& y) {
        y_[0] = y;
        anchor();
        orders();
    }

    /// Moves on to the next integration step.
    void step() {
        // y : 0 = y + sum(y)
        y_[0] = keep(Row::y_, 0, Coef(Product(y_[0]) + sum(y_, C::kOrder)));
        if (C::kAnchor) {
            anchor();
        } else {
            carry();
        }
        orders();
    }

  public:  // the words of a step
    /// Makes what a step begins with.
    void anchor() {
        // square : 0 = y*y
        square_[0] = keep(Row::square_, 0, rounded(times(y_[0], y_[0]), C::kCoefBits));
        // z : 0 = - square
        z_[0] = keep(Row::z_, 0, Coef(-Product(square_[0])));
    }
    /// The same with Anchor 0, of the step before.
    void carry() {
        // z : 0 = z + sum(z)
        z_[0] = keep(Row::z_, 0, Coef(Product(z_[0]) + sum(z_, C::kOrder)));
    }

    /// Makes the orders of a step's series.
    void orders() {
        for (int i = 1; i <= C::kOrder; ++i) {
            // y : 0 = z'/i
            y_[i] = keep(Row::y_, i, rounded(over(z_[i - 1], i), C::kCoefBits - 1));
            if (!C::kAnchor || i <= C::kOrder - 1) {
                // square : 0 = y*y
                square_[i] = keep(Row::square_, i, rounded(series_times(y_, y_, i), C::kCoefBits));
                // z : 0 = - square
                z_[i] = keep(Row::z_, i, Coef(-Product(square_[i])));
            }
        }
    }

    Coef square_[C::kMostOrder + 1] = {};         // CoefBits +0 fraction bits: +-0.5
    Coef y_[C::kMostOrder + 1] = {};              // CoefBits +0 fraction bits: +-0.5
    Coef z_[C::kMostOrder + 1] = {};              // CoefBits +0 fraction bits: +-0.5

  private:
    enum class Row { square_, y_, z_ };
    /// Names and fraction bits of the rows, for a format that notes their ranges.
    static const WordRow* rows() {
        static constexpr WordRow kRows[] = {
            {"square", 0},
            {"y", 0},
            {"z", 0},
            {nullptr, 0}};
        return kRows;
    }
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
