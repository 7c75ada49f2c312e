// SPDX-License-Identifier: Apache-2.0
// A circuit in three values, 0, 1 and unknown, in 64 lanes at a time. An unknown value stands for
// both: a fact about it holds for either.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tb/formal/search/circuit.hpp"

namespace curvecore::formal {

/// One bit for every lane.
using Lanes = std::uint64_t;
constexpr unsigned kLanes = 64;

/// A bit as two rails: it may be 1, it may be 0.
using State = std::vector<std::uint64_t>;  // 32 latches a word, low bits first

class Simulation {
  public:
    explicit Simulation(const Circuit& circuit) : circuit_(circuit), may_(2 * circuit.variables()) {
        may_[1] = ~Lanes{0};
    }

    std::size_t words() const { return (circuit_.latches.size() + 31) / 32; }

    /// Puts all lanes into one state.
    void load(const std::uint64_t* state) {
        const std::size_t first = 2 * circuit_.first_latch();
        for (std::size_t rail = 0; rail < 2 * circuit_.latches.size(); ++rail) {
            may_[first + rail] = Lanes{0} - ((state[rail / 64] >> (rail % 64)) & 1u);
        }
    }
    /// Sets every lane's inputs to the bits of its number, and the higher inputs to those of
    /// `block`.
    void set_inputs(std::uint64_t block) {
        constexpr Lanes kBitOfNumber[6] = {0xaaaaaaaaaaaaaaaa, 0xcccccccccccccccc,
                                           0xf0f0f0f0f0f0f0f0, 0xff00ff00ff00ff00,
                                           0xffff0000ffff0000, 0xffffffff00000000};
        for (std::size_t n = 0; n < circuit_.inputs; ++n) {
            const Lanes high = n < 6 ? kBitOfNumber[n] : Lanes{0} - ((block >> (n - 6)) & 1u);
            may_[2 * (1 + n)] = high;
            may_[2 * (1 + n) + 1] = ~high;
        }
    }
    void evaluate() {
        Lanes* out = &may_[2 * circuit_.first_gate()];
        for (const Gate& gate : circuit_.gates) {
            *out++ = may_[gate.left] & may_[gate.right];
            *out++ = may_[gate.left ^ 1u] | may_[gate.right ^ 1u];
        }
    }

    Lanes may(Literal literal) const { return may_[literal]; }
    Lanes must(Literal literal) const { return ~may_[literal ^ 1u]; }

  private:
    const Circuit& circuit_;
    std::vector<Lanes> may_;  // by literal
};

/// Transposes 64 words of 64 bits: bit c of word r becomes bit r of word c.
inline void transpose(std::array<std::uint64_t, 64>& block) {
    std::uint64_t low = 0x00000000ffffffff;
    for (unsigned half = 32; half != 0; half /= 2) {
        for (unsigned row = 0; row < 64; row = ((row | half) + 1) & ~half) {
            const std::uint64_t change = ((block[row] >> half) ^ block[row | half]) & low;
            block[row] ^= change << half;
            block[row | half] ^= change;
        }
        low ^= low << (half / 2);
    }
}

}  // namespace curvecore::formal
