// SPDX-License-Identifier: Apache-2.0
// Methods that draw a cubic at constant path speed step by step, the paper's among them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "ref/series/interpreter.hpp"
#include "ref/series/spline_state.hpp"

namespace curvecore::ref {

/// | method        | integrates, step by step                      | by                         |
/// |---------------|-----------------------------------------------|----------------------------|
/// | kRungeKutta   | all sixteen variables of Fig. 10              | Runge-Kutta of order 4     |
/// | kPropagated   | all sixteen variables                         | Taylor's series of `order` |
/// | kRenormalised | u; all others recomputed from it after a step | the same, a 1 / |V| a step |
/// | kNewton       | u and phi; all others recomputed from them    | the same, one Newton step  |
/// |               |                                               | for phi = 1 / |V| per step |
/// | kScalar       | u alone, du/ds = 1 / |V(u)|                   | Runge-Kutta of order 4     |
///
/// Source: [Chikurov] (30); the last three are what the paper's way is measured against.
enum class SplineMethod { kRungeKutta, kPropagated, kRenormalised, kNewton, kScalar };

/// Real: float, double, or a Boost.Multiprecision number without expression templates.
template <class Real>
class SplineFollower {
  public:
    using State = SplineState<Real>;

    /// Starts at u0; `order` is that of the series, Runge-Kutta's is 4.
    SplineFollower(const Cubic& cubic, SplineMethod method, int order, const Real& u0)
        : cubic_(cubic),
          method_(method),
          six_a_(spline_parameters<Real>(cubic)),
          network_(kSpline, order, six_a_),
          state_(spline_state(cubic, u0)) {}

    const State& state() const { return state_; }

    std::array<Real, 3> position() const {
        return {state_[spline_node::kX], state_[spline_node::kX + 1], state_[spline_node::kX + 2]};
    }

    /// Makes a step h along the path.
    void step(const Real& h) {
        switch (method_) {
            case SplineMethod::kRungeKutta:
                runge_kutta(h, [this](const State& at) { return rates(at); });
                break;
            case SplineMethod::kScalar:
                runge_kutta(h, [this](const State& at) { return rate_of_u(at); });
                state_ = spline_state(cubic_, state_[spline_node::kU]);
                break;
            case SplineMethod::kPropagated:
                state_ = network_.step(state_, h);
                break;
            case SplineMethod::kRenormalised:
                state_ = spline_state(cubic_, network_.step(state_, h)[spline_node::kU]);
                break;
            case SplineMethod::kNewton:
                state_ = network_.step(state_, h);
                renormalise(cubic_, state_);
                break;
        }
    }

  private:
    static State sum(const State& state, const State& rate, const Real& h) {
        State next;
        for (std::size_t n = 0; n < next.size(); ++n) {
            next[n] = state[n] + h * rate[n];
        }
        return next;
    }

    template <class Rates>
    void runge_kutta(const Real& h, const Rates& rates_at) {
        const State k1 = rates_at(state_);
        const State k2 = rates_at(sum(state_, k1, h / 2));
        const State k3 = rates_at(sum(state_, k2, h / 2));
        const State k4 = rates_at(sum(state_, k3, h));
        for (std::size_t n = 0; n < state_.size(); ++n) {
            state_[n] += h * (k1[n] + 2 * k2[n] + 2 * k3[n] + k4[n]) / 6;
        }
    }

    /// Returns d/ds of every node: each integrand times the rate of its integrating variable.
    State rates(const State& at) const {
        namespace node = spline_node;
        State rate{};
        const Real& du = at[node::kPhi];
        rate[node::kU] = du;
        for (std::size_t k = 0; k < 3; ++k) {
            rate[node::kW + k] = six_a_[k] * du;
            rate[node::kV + k] = at[node::kW + k] * du;
            rate[node::kX + k] = at[node::kV + k] * du;
            rate[node::kHalfSquare + k] = at[node::kV + k] * rate[node::kV + k];
            rate[node::kSum] += rate[node::kHalfSquare + k];
        }
        rate[node::kPhi] = at[node::kQ] * rate[node::kSum];
        rate[node::kQ] = at[node::kR] * rate[node::kPhi];
        rate[node::kR] = -6 * at[node::kPhi] * rate[node::kPhi];
        return rate;
    }

    State rate_of_u(const State& at) const {
        State rate{};
        rate[spline_node::kU] = spline_state(cubic_, at[spline_node::kU])[spline_node::kPhi];
        return rate;
    }

    Cubic cubic_;
    SplineMethod method_;
    std::array<Real, 3> six_a_;
    NetworkInterpreter<Real, kSpline.size(), 3> network_;
    State state_;
};

}  // namespace curvecore::ref
