/* SPDX-License-Identifier: Apache-2.0 OR GPL-2.0-or-later
 * Frames of accesses to a board's registers: LBP16 commands, rtl/line/frame_reader.sv. For C99 and
 * C++. Bytes that do not fit into a frame are cut off, which the board reports in STATE.bus. */
#ifndef CURVECORE_BOARD_FRAME_H
#define CURVECORE_BOARD_FRAME_H

#include "registers.h"

/* Bytes of a frame, without its CRC: rtl/line/frame_port.sv. */
#define CURVECORE_LONGEST_FRAME 251
/* Bytes of a command with its address, and of each pushed word. */
#define CURVECORE_COMMAND_BYTES 4
#define CURVECORE_PUSHED_BYTES 8

/* Bits of a command: words of 32 bits, or pairs of them; each to the next address. */
#define CURVECORE_COMMAND_WRITE 0x8000u
#define CURVECORE_COMMAND_ADDRESS 0x4000u
#define CURVECORE_COMMAND_WORDS 0x0200u
#define CURVECORE_COMMAND_PAIRS 0x0300u
#define CURVECORE_COMMAND_NEXT 0x0080u
#define CURVECORE_COMMAND_NUMBER 0x007fu

struct curvecore_frame {
    uint8_t bytes[CURVECORE_LONGEST_FRAME];
    int length;
};

static inline void curvecore_add_byte(struct curvecore_frame* frame, uint32_t byte) {
    if (frame->length < CURVECORE_LONGEST_FRAME) {
        frame->bytes[frame->length++] = (uint8_t)(byte & 0xffu);
    }
}

static inline void curvecore_add_word(struct curvecore_frame* frame, uint32_t word) {
    int n;
    for (n = 0; n < 4; ++n) curvecore_add_byte(frame, word >> 8 * n);
}

/* Adds a command for `number` words or pairs, at most 127; their data follow. */
static inline void curvecore_command(struct curvecore_frame* frame, uint32_t bits, int number,
                                     uint32_t address) {
    curvecore_add_word(frame,
                       bits | CURVECORE_COMMAND_ADDRESS | (uint32_t)number | address << 16);
}

static inline void curvecore_write(struct curvecore_frame* frame, uint32_t address, uint32_t word) {
    curvecore_command(frame, CURVECORE_COMMAND_WRITE | CURVECORE_COMMAND_WORDS, 1, address);
    curvecore_add_word(frame, word);
}

/* Pushes words of 48 bits into the queue at this address. */
static inline void curvecore_push(struct curvecore_frame* frame, uint32_t address,
                                  const uint64_t* words, int number) {
    int n;
    curvecore_command(frame, CURVECORE_COMMAND_WRITE | CURVECORE_COMMAND_PAIRS, number, address);
    for (n = 0; n < number; ++n) {
        curvecore_add_word(frame, (uint32_t)words[n]);
        curvecore_add_word(frame, (uint32_t)(words[n] >> 32));
    }
}

/* Reads words from this address on; the answer has them in this order. */
static inline void curvecore_read(struct curvecore_frame* frame, uint32_t address, int words) {
    curvecore_command(frame, CURVECORE_COMMAND_WORDS | CURVECORE_COMMAND_NEXT, words, address);
}

/* Gives the frame a number: its writes, which follow, are obeyed if SEQUENCE is `before`, and
 * SEQUENCE is `number` then. */
static inline void curvecore_number(struct curvecore_frame* frame, uint32_t before,
                                    uint32_t number) {
    curvecore_command(frame, CURVECORE_COMMAND_WRITE | CURVECORE_COMMAND_PAIRS, 1,
                      CURVECORE_EXPECT);
    curvecore_add_word(frame, before);
    curvecore_add_word(frame, number);
}

static inline void curvecore_append(struct curvecore_frame* frame,
                                    const struct curvecore_frame* other) {
    int n;
    for (n = 0; n < other->length; ++n) curvecore_add_byte(frame, other->bytes[n]);
}

/* Returns word n of an answer. */
static inline uint32_t curvecore_word(const uint8_t* answer, int n) {
    const uint8_t* at = answer + 4 * n;
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

#endif
