// SPDX-License-Identifier: Apache-2.0
#include "tb/formal/search/circuit.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace curvecore::formal {

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
    throw std::runtime_error(fmt::format("{}: {}", path, reason));
}

std::istringstream line_of(std::istream& file, const std::string& path) {
    std::string line;
    if (!std::getline(file, line)) refuse(path, "ends too early");
    return std::istringstream(line);
}

/// A number in groups of seven bits, low ones first.
unsigned delta(std::istream& file, const std::string& path) {
    unsigned value = 0;
    for (unsigned shift = 0; shift < 32; shift += 7) {
        const int byte = file.get();
        if (byte == std::istream::traits_type::eof()) refuse(path, "ends within the gates");
        value |= (static_cast<unsigned>(byte) & 127u) << shift;
        if (byte < 128) return value;
    }
    refuse(path, "has a gate with a number that is too large");
}

/// Reads lines `l<latch> <name> ...` among the symbols.
void read_names(std::istream& file, std::vector<Latch>& latches) {
    for (std::string line; std::getline(file, line) && line != "c";) {
        std::istringstream words(line);
        char kind = 0;
        std::size_t index = 0;
        words >> kind >> index;
        if (kind != 'l' || index >= latches.size()) continue;
        for (std::string name; words >> name;) latches[index].names.push_back(name);
    }
}

}  // namespace

Circuit read_circuit(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse(path, "cannot be read");
    std::istringstream header = line_of(file, path);
    std::string format;
    std::size_t most = 0, inputs = 0, latches = 0, outputs = 0, gates = 0, bad = 0, constraints = 0;
    header >> format >> most >> inputs >> latches >> outputs >> gates;
    if (!header || format != "aig" || most != inputs + latches + gates) {
        refuse(path, "is no circuit in the binary AIGER format");
    }
    header >> bad >> constraints;

    Circuit circuit;
    circuit.inputs = inputs;
    for (std::size_t n = 0; n < latches; ++n) {
        const auto own = static_cast<Literal>(2 * (circuit.first_latch() + n));
        std::istringstream line = line_of(file, path);
        Literal next = 0;
        Literal start = 0;
        line >> next;
        if (!line || next / 2 > most) refuse(path, "has a latch without a next state");
        line >> start;
        if (!line) start = 0;
        if (start > 1 && start != own) refuse(path, "has a latch with an unknown start");
        circuit.latches.push_back(
            {next, start == own ? Start::kAny : (start == 1 ? Start::kOne : Start::kZero), {}});
    }
    const auto literals = [&](std::size_t count) {
        std::vector<Literal> list;
        for (std::size_t n = 0; n < count; ++n) {
            Literal literal = 0;
            std::istringstream line = line_of(file, path);
            line >> literal;
            if (!line || literal / 2 > most) refuse(path, "has a bad output");
            list.push_back(literal);
        }
        return list;
    };
    literals(outputs);
    circuit.bad = literals(bad);
    circuit.constraints = literals(constraints);
    for (std::size_t n = 0; n < gates; ++n) {
        const auto own = static_cast<Literal>(2 * (circuit.first_gate() + n));
        const unsigned down = delta(file, path);
        const unsigned farther = delta(file, path);
        if (down == 0 || down > own || farther > own - down) refuse(path, "has a gate in a loop");
        circuit.gates.push_back({own - down, own - down - farther});
    }
    read_names(file, circuit.latches);
    return circuit;
}

Circuit cone_of_influence(const Circuit& circuit) {
    std::vector<bool> needed(circuit.variables(), false);
    std::vector<std::size_t> open;
    const auto need = [&](Literal literal) {
        if (needed[literal / 2]) return;
        needed[literal / 2] = true;
        open.push_back(literal / 2);
    };
    for (const Literal literal : circuit.bad) need(literal);
    for (const Literal literal : circuit.constraints) need(literal);
    while (!open.empty()) {
        const std::size_t variable = open.back();
        open.pop_back();
        if (variable >= circuit.first_gate()) {
            need(circuit.gates[variable - circuit.first_gate()].left);
            need(circuit.gates[variable - circuit.first_gate()].right);
        } else if (variable >= circuit.first_latch()) {
            need(circuit.latches[variable - circuit.first_latch()].next);
        }
    }
    needed[0] = true;

    Circuit cone;
    std::vector<Literal> place(circuit.variables());
    Literal kept = 0;
    for (std::size_t variable = 0; variable < circuit.variables(); ++variable) {
        if (needed[variable]) place[variable] = 2 * kept++;
    }
    const auto moved = [&](Literal literal) { return place[literal / 2] | (literal & 1u); };
    for (std::size_t n = 0; n < circuit.inputs; ++n) cone.inputs += needed[1 + n];
    for (std::size_t n = 0; n < circuit.latches.size(); ++n) {
        if (!needed[circuit.first_latch() + n]) continue;
        cone.latches.push_back(circuit.latches[n]);
        cone.latches.back().next = moved(circuit.latches[n].next);
    }
    for (std::size_t n = 0; n < circuit.gates.size(); ++n) {
        if (!needed[circuit.first_gate() + n]) continue;
        cone.gates.push_back({moved(circuit.gates[n].left), moved(circuit.gates[n].right)});
    }
    for (const Literal literal : circuit.bad) cone.bad.push_back(moved(literal));
    for (const Literal literal : circuit.constraints) cone.constraints.push_back(moved(literal));
    return cone;
}

}  // namespace curvecore::formal
