// SPDX-License-Identifier: Apache-2.0
// Draws what any network table says, to any order, in any arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "ref/series/network.hpp"

namespace curvecore::ref {

/// Power series of every node about the present state, summed by Horner's scheme.
///
/// | quantity  | symbol     | shape        | remark                                           |
/// |-----------|------------|--------------|--------------------------------------------------|
/// | state     | x_0        | nodes        | the caller makes it consistent (sums included)   |
/// | series    | x_0 .. x_P | P+1 per node | in powers of the independent variable            |
/// | step      | h          |              | unit of the independent variable                 |
///
///     x(s + h) = x_0 + h (x_1 + h (x_2 + ... + h x_P))
///
/// Error per step: the series' remainder, for the circle R h^(P+1) / (P+1)! with h in rad.
/// Real: double, or a Boost.Multiprecision number without expression templates.
///
/// Source: [Chikurov] (8), (15).
template <class Real, std::size_t Nodes, std::size_t Parameters>
class Interpreter {
  public:
    using State = std::array<Real, Nodes>;

    /// @throws std::invalid_argument when order < 1; std::logic_error for a malformed network
    Interpreter(const Network<Nodes, Parameters>& network, int order,
                const std::array<Real, Parameters>& parameters = {})
        : order_(order), evaluation_(evaluation_order(network)) {
        if (order < 1) {
            throw std::invalid_argument("a series has at least order 1");
        }
        for (std::size_t i = 0; i < Nodes; ++i) {
            const Node& node = network.nodes[i];
            Wired& wired = nodes_[i];
            wired.kind = node.kind;
            wired.gain = Real(node.gain.factor);
            if (!node.gain.parameter.empty()) {
                wired.gain *= parameters[network.parameter(node.gain.parameter)];
            }
            if (node.kind == NodeKind::kSum) {
                for (std::size_t k = 0; k < node.addends.size(); ++k) {
                    wired.addends[k] = network.node(node.addends[k]);
                }
                continue;
            }
            if (node.kind != NodeKind::kScaler) {
                wired.integrand = network.node(node.integrand);
            }
            if (node.kind != NodeKind::kRiemann) {
                wired.integrating = network.node(node.integrating);
            }
        }
        for (std::vector<Real>& series : series_) {
            series.resize(static_cast<std::size_t>(order) + 1);
        }
    }

    int order() const { return order_; }

    /// x_0 .. x_P of every node, in the table's order.
    const std::array<std::vector<Real>, Nodes>& expand(const State& state) {
        for (std::size_t n = 0; n < Nodes; ++n) {
            series_[n][0] = state[n];
        }
        for (int i = 1; i <= order_; ++i) {
            for (const std::size_t n : evaluation_) {
                series_[n][static_cast<std::size_t>(i)] = coefficient(nodes_[n], i);
            }
        }
        return series_;
    }

    /// The state a step h farther on.
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
    struct Wired {
        NodeKind kind = NodeKind::kSum;
        std::size_t integrand = 0;
        std::size_t integrating = 0;
        Real gain{};
        std::array<std::size_t, 3> addends{};
    };

    Real coefficient(const Wired& node, int order) const {
        const auto i = static_cast<std::size_t>(order);
        switch (node.kind) {
            case NodeKind::kRiemann:
                return node.gain * series_[node.integrand][i - 1] / Real(order);
            case NodeKind::kScaler:
                return node.gain * series_[node.integrating][i];
            case NodeKind::kSum:
                return series_[node.addends[0]][i] + series_[node.addends[1]][i] +
                       series_[node.addends[2]][i];
            case NodeKind::kStieltjes:
                break;
        }
        Real sum(0);
        for (int j = 0; j < order; ++j) {
            sum += Real(order - j) * series_[node.integrand][static_cast<std::size_t>(j)] *
                   series_[node.integrating][static_cast<std::size_t>(order - j)];
        }
        return node.gain * sum / Real(order);
    }

    int order_;
    std::array<std::size_t, Nodes> evaluation_;
    std::array<Wired, Nodes> nodes_;
    std::array<std::vector<Real>, Nodes> series_;
};

template <class Real, std::size_t Nodes, std::size_t Parameters>
Interpreter<Real, Nodes, Parameters> interpret(
    const Network<Nodes, Parameters>& network, int order,
    const std::array<Real, Parameters>& parameters = {}) {
    return {network, order, parameters};
}

}  // namespace curvecore::ref
