// SPDX-License-Identifier: Apache-2.0
// A network of Shannon integrators as a table: what the interpreter and the program generator read.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace curvecore::ref {

/// | kind      | equation                    | series, i >= 1                                  |
/// |-----------|-----------------------------|-------------------------------------------------|
/// | riemann   | dx = g u ds                 | x_i = (g/i) u_{i-1}                             |
/// | stieltjes | dx = g u dv                 | x_i = (g/i) sum_{j=0..i-1} (i-j) u_j v_{i-j}    |
/// | scaler    | dx = g dv                   | x_i = g v_i                                     |
/// | sum       | dx = dp + dq + dr           | x_i = p_i + q_i + r_i                           |
///
/// s is the network's independent variable, u the integrand, v the integrating variable: another
/// node's output. The gain g is a number times a parameter of the network, or the number alone.
///
/// Source: [Chikurov] (8), (15).
enum class NodeKind { kRiemann, kStieltjes, kScaler, kSum };

struct Gain {
    int factor = 1;
    std::string_view parameter{};
};

struct Node {
    std::string_view output;
    NodeKind kind;
    std::string_view integrand;
    std::string_view integrating;
    Gain gain{};
    std::array<std::string_view, 3> addends{};  // outputs that a sum adds
};

constexpr Node riemann(std::string_view x, std::string_view u, std::string_view s, Gain gain = {}) {
    return {x, NodeKind::kRiemann, u, s, gain, {}};
}
constexpr Node stieltjes(std::string_view x, std::string_view u, std::string_view v,
                         Gain gain = {}) {
    return {x, NodeKind::kStieltjes, u, v, gain, {}};
}
constexpr Node scaler(std::string_view x, std::string_view v, Gain gain) {
    return {x, NodeKind::kScaler, {}, v, gain, {}};
}
constexpr Node sum(std::string_view x, std::string_view p, std::string_view q, std::string_view r) {
    return {x, NodeKind::kSum, {}, {}, {}, {p, q, r}};
}

template <std::size_t Nodes, std::size_t Parameters>
struct Network {
    std::string_view figure;
    std::string_view independent;
    std::array<std::string_view, Parameters> parameters;
    std::array<Node, Nodes> nodes;

    static constexpr std::size_t size() { return Nodes; }

    /// @throws std::logic_error when no node has this output
    constexpr std::size_t node(std::string_view output) const {
        for (std::size_t i = 0; i < Nodes; ++i) {
            if (nodes[i].output == output) {
                return i;
            }
        }
        throw std::logic_error("a node's input is no output of its network");
    }

    /// @throws std::logic_error when the network has no such parameter
    constexpr std::size_t parameter(std::string_view name) const {
        for (std::size_t i = 0; i < Parameters; ++i) {
            if (parameters[i] == name) {
                return i;
            }
        }
        throw std::logic_error("a gain names no parameter of its network");
    }
};

/// Returns true if `node` reads order i of `output` to make its own order i. Integrands are read up
/// to order i-1 only, so they close no loop.
constexpr bool needs_same_order(const Node& node, std::string_view output) {
    switch (node.kind) {
        case NodeKind::kRiemann:
            return false;
        case NodeKind::kStieltjes:
        case NodeKind::kScaler:
            return node.integrating == output;
        case NodeKind::kSum:
            return node.addends[0] == output || node.addends[1] == output ||
                   node.addends[2] == output;
    }
    return false;
}

/// Returns the nodes in an order in which every order i of the series can be computed: a
/// topological sort on the integrating variables and addends, stable in the table's order.
/// @throws std::logic_error for a network that no wiring can realise: an output twice, an input
///         that nothing drives, a Riemann integrator off the independent variable, a loop
template <std::size_t Nodes, std::size_t Parameters>
constexpr std::array<std::size_t, Nodes> evaluation_order(
    const Network<Nodes, Parameters>& network) {
    for (std::size_t i = 0; i < Nodes; ++i) {
        const Node& node = network.nodes[i];
        if (network.node(node.output) != i) {
            throw std::logic_error("two nodes drive the same output");
        }
        if (!node.gain.parameter.empty()) {
            network.parameter(node.gain.parameter);
        }
        if (node.kind == NodeKind::kRiemann && node.integrating != network.independent) {
            throw std::logic_error("a Riemann integrator runs on the independent variable");
        }
        if (node.kind == NodeKind::kStieltjes || node.kind == NodeKind::kScaler) {
            network.node(node.integrating);
        }
        if (node.kind == NodeKind::kRiemann || node.kind == NodeKind::kStieltjes) {
            network.node(node.integrand);
        }
        if (node.kind == NodeKind::kSum) {
            for (const std::string_view addend : node.addends) {
                network.node(addend);
            }
        }
    }
    std::array<std::size_t, Nodes> order{};
    std::array<bool, Nodes> placed{};
    for (std::size_t position = 0; position < Nodes; ++position) {
        std::size_t chosen = Nodes;
        for (std::size_t i = 0; i < Nodes && chosen == Nodes; ++i) {
            bool ready = !placed[i];
            for (std::size_t j = 0; j < Nodes && ready; ++j) {
                ready = placed[j] || !needs_same_order(network.nodes[i], network.nodes[j].output);
            }
            if (ready) {
                chosen = i;
            }
        }
        if (chosen == Nodes) {
            throw std::logic_error("the network has an algebraic loop");
        }
        order[position] = chosen;
        placed[chosen] = true;
    }
    return order;
}

/// A network by numbers: indices of nodes and parameters instead of names.
template <std::size_t Nodes>
struct Wiring {
    static constexpr std::size_t kNone = Nodes;

    struct Node {
        NodeKind kind = NodeKind::kSum;
        bool square = false;  // it integrates its own integrand
        int factor = 1;
        std::size_t parameter = kNone;
        std::size_t integrand = kNone;
        std::size_t integrating = kNone;
        std::array<std::size_t, 3> addends{};
    };
    std::array<Node, Nodes> nodes{};
    std::array<std::size_t, Nodes> order{};  // evaluation_order()
};

/// @throws std::logic_error for a malformed network
template <std::size_t Nodes, std::size_t Parameters>
constexpr Wiring<Nodes> wire(const Network<Nodes, Parameters>& network) {
    Wiring<Nodes> wiring{};
    wiring.order = evaluation_order(network);
    for (std::size_t i = 0; i < Nodes; ++i) {
        const Node& node = network.nodes[i];
        auto& wired = wiring.nodes[i];
        wired.kind = node.kind;
        wired.square = node.kind == NodeKind::kStieltjes && node.integrand == node.integrating;
        wired.factor = node.gain.factor;
        if (!node.gain.parameter.empty()) {
            wired.parameter = network.parameter(node.gain.parameter);
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
    return wiring;
}

}  // namespace curvecore::ref
