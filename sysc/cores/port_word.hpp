// SPDX-License-Identifier: Apache-2.0
// Words across the Verilator boundary: the one place where they change sign or width.
//
// A port is unsigned, and its bits above its width must be zero; a vector of more than 64 bits is
// an array of 32-bit words.  All functions take ports of either kind.
#pragma once

#include <verilated.h>

#include <cstdint>
#include <type_traits>

namespace curvecore::sysc {

constexpr uint64_t low_mask(int bits) {
    return bits >= 64 ? ~uint64_t{0} : (uint64_t{1} << bits) - 1;
}

/// The low `bits` bits of a signed value, as a port takes them.
constexpr uint64_t to_port(int64_t value, int bits) {
    return static_cast<uint64_t>(value) & low_mask(bits);
}

/// The signed value of a port of `bits` bits.
constexpr int64_t from_port(uint64_t port, int bits) {
    const uint64_t sign = uint64_t{1} << (bits - 1);
    return static_cast<int64_t>(((port & low_mask(bits)) ^ sign) - sign);
}

/// Bits [low + bits - 1 : low] of a port, bits <= 64.
template <class Port>
uint64_t field(const Port& port, int low, int bits) {
    if constexpr (std::is_integral_v<Port>) {
        return (static_cast<uint64_t>(port) >> low) & low_mask(bits);
    } else {
        uint64_t value = 0;
        for (int bit = 0; bit < bits;) {
            const int word = (low + bit) / 32;
            const int offset = (low + bit) % 32;
            value |= (static_cast<uint64_t>(port[word]) >> offset) << bit;
            bit += 32 - offset;
        }
        return value & low_mask(bits);
    }
}

/// Bits [low + bits - 1 : low] of a port as a signed value.
template <class Port>
int64_t signed_field(const Port& port, int low, int bits) {
    return from_port(field(port, low, bits), bits);
}

/// Overwrites bits [low + bits - 1 : low] of a port, bits <= 64.
template <class Port>
void set_field(Port& port, int low, int bits, int64_t value) {
    uint64_t rest = to_port(value, bits);
    if constexpr (std::is_integral_v<Port>) {
        const uint64_t mask = low_mask(bits) << low;
        port = static_cast<Port>((static_cast<uint64_t>(port) & ~mask) | (rest << low));
    } else {
        for (int bit = 0; bit < bits;) {
            const int word = (low + bit) / 32;
            const int offset = (low + bit) % 32;
            const int count = bits - bit < 32 - offset ? bits - bit : 32 - offset;
            const auto mask = static_cast<uint32_t>(low_mask(count) << offset);
            port[word] = (port[word] & ~mask) | (static_cast<uint32_t>(rest << offset) & mask);
            rest >>= count;
            bit += count;
        }
    }
}

}  // namespace curvecore::sysc
