// SPDX-License-Identifier: Apache-2.0
// The latches of a circuit by the names of their registers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tb/formal/search/circuit.hpp"

namespace curvecore::formal {

/// A rule to forget latches: they become unknown while the guard is 0. Unknown covers their values,
/// so a wrong rule can only let a proof fail.
struct Forget {
    std::vector<std::size_t> latches;
    std::size_t guard;
};

class Registers {
  public:
    explicit Registers(const Circuit& circuit);

    /// Parses "REGISTER ... unless GUARD", a register as a whole or one bit of it
    /// ("u_dut.land_q[2]"). A register missing in the circuit needs no rule and is ignored.
    Forget rule(const std::string& text) const;

    /// Returns a line "name value ..." of the registers that differ from the state before (all if
    /// null), 'x' for unknown bits.
    std::string changes(const std::uint64_t* before, const std::uint64_t* state) const;

  private:
    std::vector<std::size_t> find(const std::string& name) const;

    std::map<std::string, std::map<unsigned, std::size_t>> bits_;  // latches of each register
};

}  // namespace curvecore::formal
