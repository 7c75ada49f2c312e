// SPDX-License-Identifier: Apache-2.0
#include "sysc/cost/multiplier_bits.hpp"

namespace curvecore::sysc {

MultiplierBits multiplier_bits(const ref::CoreParameters& parameters, bool arcs, bool splines) {
    constexpr int kArcIntegrators = 6;
    constexpr int kSplineIntegrators = 16;
    const int order = parameters.order;
    MultiplierBits cost;
    if (!parameters.polynomial()) {
        cost.sampler_products = 3 * order;
    } else {
        // tau^2, the sine's and the versine's stages, the versine's q, three products an axis.
        const int sine = (order - 1) / 2;
        const int versine = order / 2 - 1;
        cost.sampler_products = (arcs ? sine + versine + 11 : 0) + (splines ? order + 9 : 0);
    }
    cost.integrators = (arcs ? kArcIntegrators : 0) + (splines ? kSplineIntegrators : 0);
    const int width = parameters.coef_bits;
    cost.bits = cost.sampler_products * width * width + cost.integrators * 18 * 18;
    return cost;
}

}  // namespace curvecore::sysc
