// SPDX-License-Identifier: Apache-2.0
// A circuit of and gates and latches, from a file in the binary AIGER format 1.9
// (fmv.jku.at/aiger).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace curvecore::formal {

/// A literal: twice the variable, plus one for its inverse. Variable 0 is false; then come the
/// inputs, the latches and the gates, in this order.
using Literal = unsigned;

enum class Start { kZero, kOne, kAny };

struct Latch {
    Literal next;
    Start start;
    std::vector<std::string> names;  ///< names of the register's bit: "u_dut.place_q[3]"
};

struct Gate {
    Literal left, right;  ///< literals of variables before the gate's own
};

struct Circuit {
    std::size_t inputs = 0;
    std::vector<Latch> latches;
    std::vector<Gate> gates;
    std::vector<Literal> bad;          ///< assertions that fail, or covers that are reached
    std::vector<Literal> constraints;  ///< must hold in every clock

    std::size_t first_latch() const { return 1 + inputs; }
    std::size_t first_gate() const { return first_latch() + latches.size(); }
    std::size_t variables() const { return first_gate() + gates.size(); }
};

/// Reads a circuit. Throws std::runtime_error if the file is no such circuit.
Circuit read_circuit(const std::string& path);

/// Returns the circuit without parts on which neither a bad literal nor a constraint depends.
Circuit cone_of_influence(const Circuit& circuit);

}  // namespace curvecore::formal
