// SPDX-License-Identifier: Apache-2.0
// Instructions of the engine: operations, formats, clocks, hazards. hls/engine.hpp executes them.
// Twin: rtl/engine/engine_pkg.sv.
//
// A word has 4 limbs: the sum of limb[i] 2^(15 i), each limb a signed digit of 16 bits. A result of
// n limbs, n = 1..4, has digits of 0..32767 and a signed top one; limbs above it stay. So a word
// that is always written with the same n, and is 0 above, may be read as a longer one. Factors have
// 3 limbs. A wide word is an even word and the odd one behind it: 6 limbs, the latter's 2 the top.
//
//   31..28 27..26 25 24   23..16 15..8 7..0
//   op     n - 1  p  flag F0     F1    F2      p: the number of ones is odd
//
//   op   | result                                    | flag                       | clocks
//   ADD  | F2 = F0 + F1                              |                            | 2 n + 4
//   SUB  | F2 = F0 - F1                              |                            | 2 n + 4
//   MULL | F2 = F0 F1 modulo 2^(15 n)                |                            | 5 7 10 12
//   MULR | F2 = round(F0 F1 / 2^45)                  | floor in place of round    | 12 13 14 15
//   MADR | F2 = F0 + round(F2 F1 / 2^45)             | floor in place of round    | 13 15 16 17
//   SHR  | F2 = round(F0 F1 / 2^45), F0 wide         | floor in place of round    | 13 16 19 21
//   MAC  | F2 += F0 F1, F2 wide                      | F2 = F0 F1                 | 19, flag 14
//   IN   | F2 = port F0, limb by limb                |                            | n + 4
//   OUT  | port F1 = F0, limb by limb                |                            | n + 1
//   BR   | go to {F1, F2}, if F0 says so             | first wait for the tick    | 3, and the wait
//
// Clocks are of n = 1, 2, 3, 4, and fewer where F1 is a power of two: one term a column. Rounded is
// to nearest, ties upwards. ADD and SUB are exact in 15 n + 1 bits, where top digits have 16; other
// results are modulo 2^(15 n), signed. Other codes of an operation do as BR with F0 = 0: nothing.
//
//   field     | F0, F2                      | F1
//   0..127    | word of that number         | the same
//   128..191  | 1 - y .....: word of page X, of page Y with y, place of 5 bits
//   192..255  | the same                    | 11 qq rrrr: 2^(15 q + r), of r = 15: -2^(15 q)
//
// A page has 32 words; pages 0 to 3 are words 0 to 127. Words 0 to 7 are never written: 0 to 3 hold
// 2^r limb by limb, -1 at r = 15; 4 is zero; 5 to 7 are free for constants. So F2 < 8 asks for the
// flags alone. Every instruction with a result sets them: negative, of ADD and SUB the exact sum's,
// and zero, of the limbs.
//
// Two programs, each with flags, pages X and Y, and a link: the foreground, which due starts, and
// the background. Ports 0, 1, 2 of OUT are X, Y and the link, which take the last limb; IN's 2 is
// the link; others are the board's. BR's F0 is {end, return, call, not, condition of 4 bits}. If
// the condition holds (with `not`: does not), it goes to the place, with `return` to the link;
// `call` puts the next place into the link, so both together change places; `end` ends the
// foreground there, till due. Conditions: 0 never, 1 negative, 2 zero, 3 to 15 the board's.
//
// Clock by clock, of a term in clock s: operands are read in s, the sum is there in s + 3, its limb
// is written in s + 4 and read from s + 5 on. OUT's limb is at the board in s + 2. IN asks in s + 1
// and takes the answer in s + 3. BR looks at conditions and tick in s. The next instruction has its
// first term when the clocks of the table are over: what one writes, the next one reads, flags,
// pages and links too. It is of the foreground if due came 3 clocks before or earlier; due is late
// in the clock of the end of the run before, or earlier. Reset: the first term is in clock 4, of
// the background at place 0; the foreground begins at place 1; flags, pages and links are 0.
//
// A changed instruction, one with an even number of ones, does what it says, but from its first
// term until a reset nothing is put out. A store's places without an instruction are such.
//
// Hazard: in MULL, MAC and SHR of a factor that is no power, limbs of F2 are written while operands
// are read. overlaps() tells which must not share a word; Engine::hazard() sees pages that do.
// Limbs 4 and 5 of a wide word are in word F2 | 1: of an odd F2 they would be its own 0 and 1.
#pragma once

#include <cstdint>

namespace curvecore {
namespace engine {

enum class Op : std::uint8_t {
    kBr = 0,
    kOut = 1,
    kIn = 2,
    kAdd = 4,
    kSub = 5,
    kMull = 8,
    kMulr = 9,
    kMadr = 10,
    kMac = 11,
    kShr = 12
};

struct Instruction {
    Op op = Op::kBr;
    int limbs = 1;      // 1..4
    bool flag = false;  // the table's
    int f0 = 0, f1 = 0, f2 = 0;
};

/// Returns whether an instruction is as it was made: the number of its ones is odd.
constexpr bool is_whole(std::uint32_t word) {
    for (int half = 16; half > 0; half /= 2) word ^= word >> half;
    return (word & 1) != 0;
}

constexpr std::uint32_t kParity = std::uint32_t(1) << 25;

constexpr std::uint32_t encode(const Instruction& i) {
    const std::uint32_t word = std::uint32_t(i.op) << 28 | std::uint32_t(i.limbs - 1) << 26 |
                               std::uint32_t(i.flag) << 24 | std::uint32_t(i.f0) << 16 |
                               std::uint32_t(i.f1) << 8 | std::uint32_t(i.f2);
    return is_whole(word) ? word : word ^ kParity;
}

constexpr Instruction decode(std::uint32_t word) {
    Instruction i;
    i.op = Op(word >> 28);
    i.limbs = int(word >> 26 & 3) + 1;
    i.flag = (word >> 24 & 1) != 0;
    i.f0 = int(word >> 16 & 0xff);
    i.f1 = int(word >> 8 & 0xff);
    i.f2 = int(word & 0xff);
    return i;
}

// Fields
constexpr int kLimbBits = 15;
constexpr int kWordLimbs = 4;
constexpr int kPageWords = 32;
constexpr int kConstantWords = 8;  // never written
constexpr int kMinusOne = 15;      // limbs that stand in words 0 to 4
constexpr int kZero = 16;
enum Page { kX = 0x80, kY = 0xa0 };  // + place: words of a page
enum Port { kPortX = 0, kPortY = 1, kPortLink = 2 };
enum Condition { kNever = 0, kNegative = 1, kIsZero = 2, kBoard = 3 };
enum Branch { kNot = 0x10, kCall = 0x20, kReturn = 0x40, kEnd = 0x80 };

/// F1 of 2^exponent, exponent in [0, 59].
constexpr int power(int exponent) {
    return 0xc0 | exponent / kLimbBits << 4 | exponent % kLimbBits;
}
/// F1 of -2^(15 limb), limb in [0, 3].
constexpr int minus_power(int limb) { return 0xc0 | limb << 4 | kMinusOne; }
constexpr bool is_power(int f1) { return f1 >= 0xc0; }

/// Limb of the constants, words 0 to 4, by its place in memory.
constexpr std::int16_t constant_limb(int place) {
    return std::int16_t(place < kMinusOne ? 1 << place : place == kMinusOne ? -1 : 0);
}

// Terms, column by column: column c gathers the products of limbs i of one factor and c - i of the
// other, then the limb of what is added.
constexpr bool is_product(Op op) { return op >= Op::kMull && op <= Op::kShr; }
constexpr bool is_high(Op op) { return op == Op::kMulr || op == Op::kMadr || op == Op::kShr; }
constexpr bool is_sum(Op op) { return op == Op::kAdd || op == Op::kSub; }
constexpr bool is_branch(Op op) {
    return !is_product(op) && !is_sum(op) && op != Op::kIn && op != Op::kOut;
}

/// First column that is a limb of the result, and last one.
constexpr int first_column(const Instruction& i) { return is_high(i.op) ? 3 : 0; }
constexpr int last_column(const Instruction& i) {
    return i.op == Op::kMac ? 5 : first_column(i) + i.limbs - 1;
}
/// First limb of F0 (of MADR: F2) in a column, and the last there is.
constexpr int first_limb(const Instruction& i, int column) {
    const int other = is_power(i.f1) ? i.f1 >> 4 & 3 : 2;
    return column > other ? column - other : 0;
}
constexpr int last_limb(const Instruction& i) { return i.op == Op::kShr ? 5 : 2; }
/// Number of products in a column, and whether a limb is added.
constexpr int products(const Instruction& i, int column) {
    const int first = first_limb(i, column);
    const int last = is_power(i.f1) ? first : column;
    return (last < last_limb(i) ? last : last_limb(i)) - first + 1 > 0
               ? (last < last_limb(i) ? last : last_limb(i)) - first + 1
               : 0;
}
constexpr bool adds(const Instruction& i, int column) {
    return i.op == Op::kMac ? !i.flag : i.op == Op::kMadr && column >= 3;
}
/// Number of terms of a column: an empty one takes a clock, too.
constexpr int terms(const Instruction& i, int column) {
    const int sum = products(i, column) + int(adds(i, column));
    return is_sum(i.op) ? 2 : !is_product(i.op) || sum == 0 ? 1 : sum;
}

/// Clocks from the first term to that of the next instruction, without a wait for the tick.
constexpr int clocks(const Instruction& i) {
    if (is_branch(i.op)) return 3;
    int sum = i.op == Op::kOut ? 1 : 4;
    for (int column = 0; column <= last_column(i); ++column) sum += terms(i, column);
    return sum;
}

/// Returns whether an operand may be read after the result has overwritten it.
constexpr bool overlaps(const Instruction& i) {
    if (!is_product(i.op) || i.op == Op::kMulr || i.op == Op::kMadr) return false;
    const bool wide = i.op == Op::kMac;
    if (wide && i.f2 % 2 != 0) return true;
    const bool f0 = wide               ? (i.f0 | 1) == (i.f2 | 1)
                    : i.op == Op::kShr ? (i.f0 | 1) == i.f2
                                       : i.limbs == 4 && i.f0 == i.f2;
    const bool f1 = wide ? (i.f1 | 1) == (i.f2 | 1) : i.f1 == i.f2;
    return is_power(i.f1) ? wide && f0 : f0 || f1;
}

}  // namespace engine
}  // namespace curvecore
