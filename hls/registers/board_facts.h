/* SPDX-License-Identifier: Apache-2.0 OR GPL-2.0-or-later
 * Facts of a board besides its registers' places: limits that follow from its constants, and the
 * digest that words are made for. For C99 and C++. */
#ifndef CURVECORE_BOARD_FACTS_H
#define CURVECORE_BOARD_FACTS_H

#include "registers.h"

/* Largest FOLLOWING_LIMIT. */
#define CURVECORE_MOST_FOLLOWING 2147352576.0 /* 2^31 - 2^17 */

/* Returns whether a board's registers, by its VERSION, are those of registers.h. */
static inline int curvecore_knows(uint32_t version) {
    return CURVECORE_FIELD(version, VERSION_MAP) == CURVECORE_VERSION_MAP_VALUE;
}

/* Returns the longest time of PULSE or DIRECTION in clocks, by WIDTHS: the board counts the sum of
 * two in the same number of bits. */
static inline uint32_t curvecore_most_clocks(uint32_t widths) {
    return ((uint32_t)1 << (CURVECORE_FIELD(widths, WIDTHS_TIME_BITS) - 1)) - 1;
}

/* Returns the upper limit of a scale, exclusive, by WIDTHS. */
static inline uint64_t curvecore_scale_end(uint32_t widths) {
    return (uint64_t)1 << CURVECORE_FIELD(widths, WIDTHS_SCALE_BITS);
}

/* Adds a word's bytes to a digest, the low one first: a CRC of 16 bits, modulo x^16 + x^3 + 1. */
static inline uint16_t curvecore_digest(uint16_t digest, uint32_t word) {
    int n;
    for (n = 0; n < 4; ++n, word >>= 8) {
        const uint32_t top = (uint32_t)digest >> 8;
        digest = (uint16_t)((uint32_t)digest << 8 ^ top << 3 ^ top ^ (word & 0xffu));
    }
    return digest;
}

/* Returns the number of a curve's table, in [1, 1023], of its lines without remarks: field table of
 * CORE. */
static inline uint32_t curvecore_table_number(const char *lines) {
    uint16_t digest = 0;
    for (; *lines != 0; ++lines) digest = curvecore_digest(digest, (unsigned char)*lines);
    return 1 + digest % 1023u;
}

/* Returns the board's part of the digest that words are made for: the fields of CAPABILITY that
 * they depend on, CORE, the clocks of a sample period, and CLOCK. Its exclusive or with DIGEST, the
 * other part, is the digest of the words: rtl/motion_system.sv. */
static inline uint16_t curvecore_board_digest(uint32_t capability, uint32_t core, uint32_t period,
                                              uint32_t clock) {
    const uint32_t fields = CURVECORE_CAPABILITY_AXES_MASK | CURVECORE_CAPABILITY_BUILD_MASK |
                            CURVECORE_CAPABILITY_ENGINE_MASK | CURVECORE_CAPABILITY_SPLINES_MASK;
    uint16_t digest = curvecore_digest(0, capability & fields);
    digest = curvecore_digest(digest, core);
    digest = curvecore_digest(digest, period);
    return curvecore_digest(digest, clock);
}

#endif
