// SPDX-License-Identifier: Apache-2.0
#include "tb/formal/search/registers.hpp"

#include <fmt/format.h>

#include <set>
#include <sstream>
#include <stdexcept>

namespace curvecore::formal {

namespace {

char value(const std::uint64_t* state, std::size_t latch) {
    const std::uint64_t rails = state[latch / 32] >> (2 * (latch % 32)) & 3u;
    return "?10x"[rails];
}

}  // namespace

Registers::Registers(const Circuit& circuit) {
    for (std::size_t latch = 0; latch < circuit.latches.size(); ++latch) {
        for (const std::string& name : circuit.latches[latch].names) {
            const std::size_t bracket = name.back() == ']' ? name.rfind('[') : std::string::npos;
            const bool one = bracket == std::string::npos;
            const unsigned bit =
                one ? 0 : static_cast<unsigned>(std::stoul(name.substr(bracket + 1)));
            bits_[name.substr(0, bracket)][bit] = latch;
        }
    }
}

std::vector<std::size_t> Registers::find(const std::string& name) const {
    std::vector<std::size_t> latches;
    for (const auto& [register_name, bits] : bits_) {
        for (const auto& [bit, latch] : bits) {
            if (register_name == name || fmt::format("{}[{}]", register_name, bit) == name) {
                latches.push_back(latch);
            }
        }
    }
    return latches;
}

Forget Registers::rule(const std::string& text) const {
    std::istringstream words(text);
    Forget rule{};
    std::string name;
    while (words >> name && name != "unless") {
        const std::vector<std::size_t> latches = find(name);
        rule.latches.insert(rule.latches.end(), latches.begin(), latches.end());
    }
    if (!(words >> name)) throw std::runtime_error("no guard: " + text);
    const std::vector<std::size_t> guard = find(name);
    if (guard.size() > 1) throw std::runtime_error("a guard of several bits: " + text);
    if (guard.empty()) return {};
    rule.guard = guard.front();
    return rule;
}

std::string Registers::changes(const std::uint64_t* before, const std::uint64_t* state) const {
    std::string line;
    std::set<std::size_t> shown;  // a latch under one of its names
    for (const auto& [name, bits] : bits_) {
        std::string now;
        std::string then;
        bool fresh = false;
        for (auto bit = bits.rbegin(); bit != bits.rend(); ++bit) {
            now += value(state, bit->second);
            if (before != nullptr) then += value(before, bit->second);
            fresh |= shown.insert(bit->second).second;
        }
        if (fresh && now != then) line += fmt::format(" {} {}", name, now);
    }
    return line;
}

}  // namespace curvecore::formal
