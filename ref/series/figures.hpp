// SPDX-License-Identifier: Apache-2.0
// The papers' figures, one table each, in the papers' letters: wiring only, no numbers.
#pragma once

#include "ref/series/network.hpp"

namespace curvecore::ref {

/// Sine and cosine: y = sin x, z = cos x.
///
/// | node | unit | initial value |
/// |------|------|---------------|
/// | y    | 1    | sin x0        |
/// | z    | 1    | cos x0        |
///
/// Invariant: y^2 + z^2. Source: [Chikurov] Fig. 2.
constexpr Network<2, 0> kSineCosine{"Fig. 2",
                                    "x",
                                    {},
                                    {{
                                        riemann("y", "z", "x"),
                                        riemann("z", "y", "x", {-1}),
                                    }}};

/// A great circle: three oscillators (x,F), (y,G), (z,H) that share phi = 1/R.
///
/// | node    | unit | initial value                             |
/// |---------|------|-------------------------------------------|
/// | x, y, z | mm   | start - centre, at the distance R from it |
/// | F, G, H | mm   | B x (x, y, z), B the plane's unit normal  |
/// | phi     | 1/mm | parameter, 1/R                            |
///
/// Counter-clockwise about B. Invariants: |r|, |(F,G,H)|, B . r.
/// Source: [Chikurov] Fig. 8, (19).
constexpr Network<6, 1> kSpherical{"Fig. 8",
                                   "s",
                                   {"phi"},
                                   {{
                                       riemann("x", "F", "s", {1, "phi"}),
                                       riemann("F", "x", "s", {-1, "phi"}),
                                       riemann("y", "G", "s", {1, "phi"}),
                                       riemann("G", "y", "s", {-1, "phi"}),
                                       riemann("z", "H", "s", {1, "phi"}),
                                       riemann("H", "z", "s", {-1, "phi"}),
                                   }}};

static_assert(evaluation_order(kSineCosine).size() == 2);
static_assert(evaluation_order(kSpherical).size() == 6);

}  // namespace curvecore::ref
