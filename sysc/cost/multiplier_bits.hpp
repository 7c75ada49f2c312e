// SPDX-License-Identifier: Apache-2.0
// A measure of area that knows no device.
#pragma once

#include "ref/format/parameters.hpp"

namespace curvecore::sysc {

/// The bits of all partial products when a sample leaves with every clock:
///
///     W^2 for each product of the sampler, 18^2 for each integrator of the networks
///
/// with CoefBits W; the parallel build's networks work digit by digit, one 18 x 18 multiplier each.
/// A core that draws both kinds shares the sampler of Mode 0 and has both of Mode 1.
struct MultiplierBits {
    int sampler_products = 0;
    int integrators = 0;
    int bits = 0;
};
MultiplierBits multiplier_bits(const ref::CoreParameters& parameters, bool arcs, bool splines);

}  // namespace curvecore::sysc
