// SPDX-License-Identifier: Apache-2.0
// One configuration among those that are compared: what changes the words of a core.
#pragma once

#include <string>

#include "ref/error_bound.hpp"

namespace curvecore::tb {

/// | field  | meaning                                                                      |
/// |--------|------------------------------------------------------------------------------|
/// | format | order, widths and sampler, hls/configuration.hpp; weights, tau and path have |
/// |        | CoefBits-1 fraction bits, a spline's parameter ParameterGuard more           |
/// | anchor | splines: anchored at every step, or all variables propagated as in the paper |
struct Setting {
    ref::WordFormat format;
    bool anchor = true;

    const char* mode() const { return format.polynomial ? "polynomial" : "series"; }
    const char* scheme() const { return anchor ? "anchored" : "propagated"; }
    /// "Order=6 CoefBits=36 GuardBits=10 Mode=1 Anchor=1 TurnBits=0 ParameterGuard=0"
    std::string text() const;
};

bool operator==(const Setting& a, const Setting& b);

/// Widest words there are, of this order and sampler: what exact curves are cut for.
ref::WordFormat widest(const ref::WordFormat& format);

/// A measure of area that knows no device: the bits of all partial products when a
/// sample leaves with every clock.
///
///     W^2 for each product of the sampler (with TurnBits, of each order's own widths), 18^2 for
///     each integrator of the networks
///
/// with CoefBits W; the parallel build's networks work digit by digit, one 18 x 18 multiplier each.
/// A core that draws both kinds shares the sampler of Mode 0 and has both of Mode 1.
struct MultiplierBits {
    int sampler_products = 0;
    int integrators = 0;
    int bits = 0;
};
MultiplierBits multiplier_bits(const Setting& setting, bool arcs, bool splines);

}  // namespace curvecore::tb
