// SPDX-License-Identifier: Apache-2.0
// Start values of the spline network that agree with each other, and the restoration of agreement.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "ref/curve/cubic.hpp"
#include "ref/series/figures.hpp"

namespace curvecore::ref {

template <class Real>
using SplineState = std::array<Real, kSpline.size()>;

/// Nodes of an axis in a SplineState: axis k is the k-th node from the first.
namespace spline_node {
constexpr std::size_t kU = kSpline.node("u");
constexpr std::size_t kW = kSpline.node("Wx");
constexpr std::size_t kV = kSpline.node("Vx");
constexpr std::size_t kX = kSpline.node("x");
constexpr std::size_t kHalfSquare = kSpline.node("Px");
constexpr std::size_t kSum = kSpline.node("P");
constexpr std::size_t kPhi = kSpline.node("phi");
constexpr std::size_t kQ = kSpline.node("Q");
constexpr std::size_t kR = kSpline.node("R");
}  // namespace spline_node

/// The network's parameters, 6 a.
template <class Real>
std::array<Real, 3> spline_parameters(const Cubic& cubic) {
    return {6 * Real(cubic.a[0]), 6 * Real(cubic.a[1]), 6 * Real(cubic.a[2])};
}

/// Sets W, V, x, Px.. and P from u: the part of the state that the polynomial determines.
template <class Real>
void anchor_to_curve(const Cubic& cubic, SplineState<Real>& state) {
    namespace node = spline_node;
    const Real u = state[node::kU];
    state[node::kSum] = Real(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const Real a(cubic.a[axis]), b(cubic.b[axis]), c(cubic.c[axis]), d(cubic.d[axis]);
        const Real v = (3 * a * u + 2 * b) * u + c;
        state[node::kW + k] = 6 * a * u + 2 * b;
        state[node::kV + k] = v;
        state[node::kX + k] = ((a * u + b) * u + c) * u + d;
        state[node::kHalfSquare + k] = v * v / 2;
        state[node::kSum] += v * v / 2;
    }
}

/// Sets Q and R from phi: the invariants Q + phi^3 and R + 3 phi^2 become 0.
template <class Real>
void derive_from_phi(SplineState<Real>& state) {
    namespace node = spline_node;
    const Real phi = state[node::kPhi];
    state[node::kQ] = -phi * phi * phi;
    state[node::kR] = -3 * phi * phi;
}

/// All nodes at u0: the state from which the network draws the cubic at unit path speed. Infinite
/// where V = 0.
template <class Real>
SplineState<Real> spline_state(const Cubic& cubic, const Real& u0) {
    using std::sqrt;
    SplineState<Real> state{};
    state[spline_node::kU] = u0;
    anchor_to_curve(cubic, state);
    state[spline_node::kPhi] = 1 / sqrt(2 * state[spline_node::kSum]);
    derive_from_phi(state);
    return state;
}

/// Restores agreement after a step: the curve's part from the polynomial, phi by one Newton step
/// for 1 / |V|, Q and R from it. A relative error e of phi becomes -1.5 e^2; beyond 0 < phi^2 2 P <
/// 3 it grows instead.
///
///     phi := phi (3/2 - P phi^2)
template <class Real>
void renormalise(const Cubic& cubic, SplineState<Real>& state) {
    namespace node = spline_node;
    anchor_to_curve(cubic, state);
    Real& phi = state[node::kPhi];
    phi *= Real(1.5) - state[node::kSum] * phi * phi;
    derive_from_phi(state);
}

}  // namespace curvecore::ref
