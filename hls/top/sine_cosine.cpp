// SPDX-License-Identifier: Apache-2.0
// Top of the HLS of hls::Oscillator (hls/spherical_kernel.hpp), as a function without a state:
// every call is an integration step.
//
//     theta, sine, cosine             angle of the step, and the state at its start
//     sine_coef, cosine_coef          orders 1 .. Order
//     next_sine, next_cosine          the state a step farther on
#include "hls/spherical_kernel.hpp"
#include "hls/top/top_configuration.hpp"

namespace curvecore {
namespace hls {

using Coef = TopConfiguration::Coef;
using Series = Coef[CFG_Order];

extern "C" void sine_cosine_hls(const Coef& theta, const Coef& sine, const Coef& cosine,
                                Series& sine_coef, Series& cosine_coef, Coef& next_sine,
                                Coef& next_cosine) {
    using C = TopConfiguration;
    const C c;
    Coef weight[C::kOrder + 1];
    weight[1] = theta;  // read before the first result is written: they might share a place
    for (int i = 2; i <= C::kOrder; ++i) {
        weight[i] =
            rounded_product<C::Product>(weight[1], Coef(reciprocal(i, C::kUnitFrac)), C::kUnitFrac);
    }
    Oscillator<C> node;
    node.y = sine;
    node.z = cosine;
    node.expand(c, weight, Variable::kSine, Variable::kVersine);
    for (int i = 1; i <= C::kOrder; ++i) {
        sine_coef[i - 1] = node.y_coef[i];
        cosine_coef[i - 1] = node.z_coef[i];
    }
    node.advance(c, weight[1]);
    next_sine = node.y;
    next_cosine = node.z;
}

}  // namespace hls
}  // namespace curvecore
