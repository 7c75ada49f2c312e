/* SPDX-License-Identifier: Apache-2.0 OR GPL-2.0-or-later
 * Frames on a stream of bytes, UART or SPI: SLIP (RFC 1055) around a frame and its CRC-32, low
 * byte first. The other end: rtl/line/slip_receiver.sv, slip_sender.sv. Two escapes are no byte:
 * rtl/line/spi_line.sv sends them inside a frame that has to wait. For C99 and C++. */
#ifndef CURVECORE_BOARD_LINE_H
#define CURVECORE_BOARD_LINE_H

#include <stdint.h>

/* Bytes of an answer, without its CRC: 128 words. */
#define CURVECORE_LONGEST_ANSWER 512
/* Ends a frame; alone it has no meaning. */
#define CURVECORE_LINE_END 0xc0
#define CURVECORE_LINE_ESCAPE 0xdb
#define CURVECORE_LINE_ESCAPED_END 0xdc
#define CURVECORE_LINE_ESCAPED_ESCAPE 0xdd

/* CRC-32 of zlib and Ethernet, byte by byte, from all ones; its complement is appended. */
static inline uint32_t curvecore_crc(uint32_t crc, uint8_t byte) {
    int n;
    crc ^= byte;
    for (n = 0; n < 8; ++n) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    return crc;
}
/* CRC of bytes with their CRC behind them. */
#define CURVECORE_CRC_UNBROKEN 0xdebb20e3u

/* Writes a frame's bytes to a line, which has room for 2 * length + 9; returns their number. */
static inline int curvecore_to_line(uint8_t* line, const uint8_t* frame, int length) {
    uint32_t crc = 0xffffffffu;
    int size = 0, n;
    for (n = 0; n < length + 4; ++n) {
        const uint8_t byte =
            n < length ? frame[n] : (uint8_t)(~crc >> 8 * (n - length) & 0xffu);
        if (n < length) crc = curvecore_crc(crc, byte);
        line[size++] = byte;
        if (byte != CURVECORE_LINE_END && byte != CURVECORE_LINE_ESCAPE) continue;
        line[size - 1] = CURVECORE_LINE_ESCAPE;
        line[size++] = byte == CURVECORE_LINE_END ? CURVECORE_LINE_ESCAPED_END
                                                  : CURVECORE_LINE_ESCAPED_ESCAPE;
    }
    line[size++] = CURVECORE_LINE_END;
    return size;
}

/* Answer that is being received; all 0 at first. */
struct curvecore_line {
    uint8_t bytes[CURVECORE_LONGEST_ANSWER + 4];
    int length, escaped, broken;
};

/* Takes a byte; returns the length of the answer that it ends, whole and unbroken, else 0. The
 * answer is at line->bytes until the next byte. */
static inline int curvecore_from_line(struct curvecore_line* line, uint8_t byte) {
    const int escaped = line->escaped;
    if (byte == CURVECORE_LINE_END) {
        const int length = line->length - 4;
        uint32_t crc = 0xffffffffu;
        int n, whole = !line->broken && !escaped && length > 0;
        for (n = 0; n < line->length; ++n) crc = curvecore_crc(crc, line->bytes[n]);
        line->length = line->escaped = line->broken = 0;
        return whole && crc == CURVECORE_CRC_UNBROKEN ? length : 0;
    }
    line->escaped = byte == CURVECORE_LINE_ESCAPE && !escaped;
    if (byte == CURVECORE_LINE_ESCAPE) return 0;
    if (escaped) {
        if (byte != CURVECORE_LINE_ESCAPED_END && byte != CURVECORE_LINE_ESCAPED_ESCAPE) {
            line->broken = 1;
        }
        byte = byte == CURVECORE_LINE_ESCAPED_END ? CURVECORE_LINE_END : CURVECORE_LINE_ESCAPE;
    }
    if (line->length < (int)sizeof line->bytes) {
        line->bytes[line->length++] = byte;
    } else {
        line->broken = 1;
    }
    return 0;
}

#endif
