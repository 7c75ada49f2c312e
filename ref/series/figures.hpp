// SPDX-License-Identifier: Apache-2.0
// Figures 2, 3, 8 and 10 of [Chikurov], a table each, in its letters: wiring only, no numbers.
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

/// A hyperbola: y = 1 / (k (t0 + t)).
///
/// | node | unit    | initial value                             |
/// |------|---------|-------------------------------------------|
/// | y    | 1       | 1 / (k t0)                                |
/// | z    | 1 / t   | -k y^2, exactly: nothing pulls it back    |
/// | k    | 1 / t   | parameter                                 |
///
/// Invariant: C = z + k y^2 = 0; with C != 0 the network draws y' = C - k y^2, which ends on
/// sqrt(C/k) or leaves for minus infinity. The series converges for steps below t0 + t.
/// Source: [Chikurov] Fig. 3.
constexpr Network<2, 1> kHyperbola{"Fig. 3",
                                   "t",
                                   {"k"},
                                   {{
                                       riemann("y", "z", "t"),
                                       stieltjes("z", "y", "y", {-2, "k"}),
                                   }}};

/// A cubic r(u) = a u^3 + b u^2 + c u + d by its path length s. Start: spline_state().
///
/// | node       | unit      | initial value                                  |
/// |------------|-----------|------------------------------------------------|
/// | u          | 1         | u0, 0 .. 1                                     |
/// | Wx, Wy, Wz | mm        | 6 a u0 + 2 b, the curve's second derivative    |
/// | Vx, Vy, Vz | mm        | its first derivative                           |
/// | x, y, z    | mm        | r(u0)                                          |
/// | Px, Py, Pz | mm^2      | V^2 / 2, by axis                               |
/// | P          | mm^2      | |V|^2 / 2                                      |
/// | phi        | 1/mm      | du/ds = 1 / |V|                                |
/// | Q          | mm^-3     | dphi/dP = -phi^3                               |
/// | R          | mm^-2     | dQ/dphi = -3 phi^2, hence the gain 6 of its    |
/// |            |           | integrator, which [Chikurov]'s R_i lacks       |
/// | 6ax ..     | mm        | parameters, 6 a                                |
///
/// Invariants: Q + phi^3, R + 3 phi^2, 2 P phi^2 - 1, all 0; nothing pulls them back.
/// Source: [Chikurov] Fig. 10, (30); the sum P is not printed there.
constexpr Network<17, 3> kSpline{"Fig. 10",
                                 "s",
                                 {"6ax", "6ay", "6az"},
                                 {{
                                     riemann("u", "phi", "s"),
                                     scaler("Wx", "u", {1, "6ax"}),
                                     scaler("Wy", "u", {1, "6ay"}),
                                     scaler("Wz", "u", {1, "6az"}),
                                     stieltjes("Vx", "Wx", "u"),
                                     stieltjes("Vy", "Wy", "u"),
                                     stieltjes("Vz", "Wz", "u"),
                                     stieltjes("x", "Vx", "u"),
                                     stieltjes("y", "Vy", "u"),
                                     stieltjes("z", "Vz", "u"),
                                     stieltjes("Px", "Vx", "Vx"),
                                     stieltjes("Py", "Vy", "Vy"),
                                     stieltjes("Pz", "Vz", "Vz"),
                                     sum("P", "Px", "Py", "Pz"),
                                     stieltjes("phi", "Q", "P"),
                                     stieltjes("Q", "R", "phi"),
                                     stieltjes("R", "phi", "phi", {-6}),
                                 }}};

static_assert(evaluation_order(kSineCosine).size() == 2);
static_assert(evaluation_order(kSpherical).size() == 6);
static_assert(evaluation_order(kHyperbola).size() == 2);
static_assert(evaluation_order(kSpline).size() == 17);

constexpr Wiring<17> kSplineWiring = wire(kSpline);

}  // namespace curvecore::ref
