// SPDX-License-Identifier: Apache-2.0
// The interpreter of network tables, to any order, in any arithmetic.
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <stdexcept>

#include "ref/series/network.hpp"

namespace curvecore::ref {

/// Coefficients x_0 .. x_P of a node; no memory is allocated up to such an order.
template <class Real>
using Series = boost::container::small_vector<Real, 20>;

/// Numbers as they are: the default treatment of rates and coefficients by expand().
struct Exact {
    bool asks(std::size_t /*node*/, int /*order*/) const { return true; }
    template <class Real>
    const Real& rate(std::size_t /*node*/, int /*order*/, const Real& value) const {
        return value;
    }
    template <class Real>
    const Real& coefficient(std::size_t /*node*/, int /*order*/, const Real& value) const {
        return value;
    }
};

/// Power series of every node about the present state, summed by Horner's scheme.
///
/// | quantity  | symbol     | shape        | remark                                           |
/// |-----------|------------|--------------|--------------------------------------------------|
/// | state     | x_0        | nodes        | the caller makes it consistent (sums included)   |
/// | series    | x_0 .. x_P | P+1 per node | in powers of the independent variable            |
/// | rates     | D_1 .. D_P | P+1 per node | D_i = i x_i, by which Stieltjes nodes integrate  |
/// | step      | h          |              | unit of the independent variable                 |
///
///     x(s + h) = x_0 + h (x_1 + h (x_2 + ... + h x_P))
///
/// A node that integrates its own integrand is half a square: its series comes from its root's.
///
/// Error per step: the series' remainder, for the circle R h^(P+1) / (P+1)! with h in rad.
/// Real: double, a Boost.Multiprecision number without expression templates, or Enclosed.
///
/// Source: [Chikurov] (8), (15).
template <class Real, std::size_t Nodes, std::size_t Parameters>
class NetworkInterpreter {
  public:
    using State = std::array<Real, Nodes>;

    /// @throws std::invalid_argument when order < 1
    NetworkInterpreter(const Wiring<Nodes>& wiring, int order,
                       const std::array<Real, Parameters>& parameters = {})
        : order_(order), wiring_(wiring) {
        if (order < 1) {
            throw std::invalid_argument("a series has at least order 1");
        }
        for (std::size_t n = 0; n < Nodes; ++n) {
            const std::size_t parameter = wiring.nodes[n].parameter;
            gains_[n] = Real(wiring.nodes[n].factor);
            if (parameter != Wiring<Nodes>::kNone) gains_[n] = gains_[n] * parameters[parameter];
            series_[n].resize(static_cast<std::size_t>(order) + 1);
            rates_[n].resize(static_cast<std::size_t>(order) + 1);
        }
    }

    /// @throws also std::logic_error for a malformed network
    NetworkInterpreter(const Network<Nodes, Parameters>& network, int order,
                       const std::array<Real, Parameters>& parameters = {})
        : NetworkInterpreter(wire(network), order, parameters) {}

    int order() const { return order_; }

    /// x_0 .. x_P of every node, in the table's order. Each rate and each coefficient passes
    /// through `words`, after it is made and before it is read; those that `words` does not ask for
    /// stay.
    template <class Words = Exact>
    const std::array<Series<Real>, Nodes>& expand(const State& state, Words&& words = {}) {
        for (std::size_t n = 0; n < Nodes; ++n) {
            series_[n][0] = state[n];
        }
        for (int i = 1; i <= order_; ++i) {
            for (const std::size_t n : wiring_.order) {
                if (!words.asks(n, i)) continue;
                const auto at = static_cast<std::size_t>(i);
                rates_[n][at] = words.rate(n, i, rate(n, i));
                series_[n][at] = words.coefficient(n, i, coefficient(n, i));
            }
        }
        return series_;
    }

    /// Series of the last expand().
    const std::array<Series<Real>, Nodes>& series() const { return series_; }

    /// Returns the state a step h farther on.
    State step(const State& state, const Real& h) {
        expand(state);
        State next;
        for (std::size_t n = 0; n < Nodes; ++n) {
            Real value = series_[n].back();
            for (std::size_t i = static_cast<std::size_t>(order_); i-- > 0;) {
                value = series_[n][i] + value * h;
            }
            next[n] = value;
        }
        return next;
    }

  private:
    /// Rate D_i, from rates of other nodes up to i and series up to i - 1.
    Real rate(std::size_t n, int order) const {
        const auto& node = wiring_.nodes[n];
        const auto i = static_cast<std::size_t>(order);
        switch (node.kind) {
            case NodeKind::kRiemann:
                return gains_[n] * series_[node.integrand][i - 1];
            case NodeKind::kScaler:
                return gains_[n] * rates_[node.integrating][i];
            case NodeKind::kSum:
                return rates_[node.addends[0]][i] + rates_[node.addends[1]][i] +
                       rates_[node.addends[2]][i];
            case NodeKind::kStieltjes:
                break;
        }
        const Real* const u = series_[node.integrand].data();
        const Real* const dv = rates_[node.integrating].data() + i;
        Real sum(0);
        for (std::size_t j = 0; j < i; ++j) {
            sum += u[j] * *(dv - j);
        }
        return gains_[n] * sum;
    }

    /// Coefficient x_i.
    Real coefficient(std::size_t n, int order) const {
        const auto& node = wiring_.nodes[n];
        const auto i = static_cast<std::size_t>(order);
        if (node.kind == NodeKind::kScaler) {
            return gains_[n] * series_[node.integrating][i];
        }
        if (node.kind == NodeKind::kSum) {
            return series_[node.addends[0]][i] + series_[node.addends[1]][i] +
                   series_[node.addends[2]][i];
        }
        if (node.square) {
            const Series<Real>& root = series_[node.integrand];
            Real sum(0);
            for (std::size_t j = 0; j <= i; ++j) {
                sum += root[j] * root[i - j];
            }
            return gains_[n] * sum / 2;
        }
        return rates_[n][i] / order;
    }

    int order_;
    Wiring<Nodes> wiring_;
    std::array<Real, Nodes> gains_;
    std::array<Series<Real>, Nodes> series_;
    std::array<Series<Real>, Nodes> rates_;
};

template <class Real, std::size_t Nodes, std::size_t Parameters>
NetworkInterpreter<Real, Nodes, Parameters> interpret(
    const Network<Nodes, Parameters>& network, int order,
    const std::array<Real, Parameters>& parameters = {}) {
    return {network, order, parameters};
}

}  // namespace curvecore::ref
