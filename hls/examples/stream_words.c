/* SPDX-License-Identifier: Apache-2.0
 * A host in C: draws what `curvecore words PART --to udp:ADDRESS:PORT -o FOLDER` wrote for a board.
 * The wire: hls/registers/board_link.h; the order: sysc/wire/README.md, "From power-on ..".
 *
 *     stream_words FOLDER ADDRESS PORT STEPS_PER_MM
 */
#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "../registers/board_link.h"

#define SILENCE_S 0.5 /* of this host, that is a hold */
enum { MOST_WORDS = 1000000 };
enum { STATE, PATH_LO, PATH_HI, RATE, ROOM }; /* that are read with each frame */

static uint64_t words[2][MOST_WORDS]; /* of segments and profile */
static int counts[2], gone[2];
static char json[65536];
static struct curvecore_sent frames[32];
static struct curvecore_link board;
static int wire;

static void fail(const char* what, const char* why) {
    fprintf(stderr, "stream_words: %s%s\n", what, why);
    exit(1);
}
static int64_t now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (int64_t)time.tv_sec * 1000000000 + time.tv_nsec;
}
static void transmit(void* device, const uint8_t* bytes, int length) {
    (void)!send(*(int*)device, bytes, (size_t)length, 0); /* what is lost goes again */
}
static int is(uint32_t mask) { return (board.words[STATE] & mask) != 0; }

/* Takes what comes within a millisecond; asks and repeats. */
static void turn(void) {
    struct pollfd comes = {wire, POLLIN, 0};
    uint8_t bytes[1024];
    ssize_t length;
    poll(&comes, 1, 1);
    while ((length = recv(wire, bytes, sizeof bytes, MSG_DONTWAIT)) >= 0)
        if (curvecore_take(&board, bytes, (int)length, now()) == CURVECORE_FOREIGN)
            fail("the board has another master", "");
    curvecore_work(&board, now());
    if (curvecore_silence(&board, now()) > 10000000000) fail("the board does not answer", "");
    if (board.board.id && board.phase == CURVECORE_UNKNOWN) fail("it is another kind of board", "");
    for (uint32_t fault = 1; fault && board.live_period; fault <<= 1) /* since it was prepared */
        if (is(CURVECORE_FAULTS & fault)) fail("", curvecore_fault_text(fault));
}
static void set(uint32_t address, uint32_t word) {
    curvecore_write(curvecore_begin(&board), address, word);
    curvecore_send(&board, 0, 0, now());
    while (board.count > 0) turn();
}

static int min(int a, int b) { return a < b ? a : b; }

/* Words, as many as a frame and the queue, less those under way, have room for. */
static void push(int kind, uint32_t queue, int room) {
    const int left = min(room - curvecore_under_way(&board, kind), counts[kind] - gone[kind]);
    if (!curvecore_may_send(&board)) return;
    struct curvecore_frame* frame = curvecore_begin(&board);
    const int most = curvecore_room_for_words(&board, frame);
    const int count = min(left, most);
    if (left <= 0 || (left < most && board.count > 0)) return; /* short ones wait for others */
    curvecore_push(frame, queue, &words[kind][gone[kind]], count);
    gone[kind] += count;
    curvecore_send(&board, kind ? 0 : count, kind ? count : 0, now());
}

static double number_of(const char* name) {
    char key[64], *at;
    snprintf(key, sizeof key, "\"%s\":", name);
    if (!(at = strstr(json, key))) fail("words.json has no ", name);
    return strtod(at + strlen(key), NULL);
}
/* A time in clocks, in both halves of a word. */
static uint32_t two(double s) { return (uint32_t)ceil(s * board.board.hertz) * 0x10001u; }

/* Writes what drives and words need, and ends what another host has left. */
static void prepare(double steps_per_mm) {
    const uint32_t axes = CURVECORE_FIELD(board.board.capability, CAPABILITY_AXES);
    const uint32_t period = 1u << CURVECORE_FIELD(board.board.capability, CAPABILITY_PERIOD_LOG2);
    const int bits = (int)CURVECORE_FIELD(board.board.core, CORE_POSITION_BITS) + 16;
    const uint64_t scale = (uint64_t)llround(ldexp(steps_per_mm * number_of("unit_mm"), bits));
    set(CURVECORE_CONTROL, 0);
    while (!is(CURVECORE_STATE_CLEAN_MASK)) turn();
    set(CURVECORE_STATE, CURVECORE_FAULTS);
    for (uint32_t at = 0; at < axes * CURVECORE_AXIS_STRIDE; at += CURVECORE_AXIS_STRIDE) {
        set(CURVECORE_AXIS_SCALE_LO + at, (uint32_t)scale);
        set(CURVECORE_AXIS_SCALE_HI + at, (uint32_t)(scale >> 32));
    }
    for (uint32_t at = 0; at < axes; ++at) set(CURVECORE_FOLLOWING_LIMIT0 + 4 * at, 0);
    set(CURVECORE_PULSE, two(2e-6));
    set(CURVECORE_DIRECTION, two(4e-6));
    set(CURVECORE_PINS, 0);
    set(CURVECORE_PROBE, 0);
    set(CURVECORE_TIMING, (uint32_t)number_of("samples_per_tick_log2"));
    set(CURVECORE_HOLD_ACCELERATION, (uint32_t)number_of("hold_acceleration"));
    set(CURVECORE_HOLD_SLOPE, (uint32_t)(uint64_t)number_of("hold_slope"));
    set(CURVECORE_STOP_TICKS, (uint32_t)number_of("stop_ticks"));
    set(CURVECORE_DIGEST, (uint32_t)number_of("digest_register"));
    set(CURVECORE_OVERRIDE, 65536);
    set(CURVECORE_WATCHDOG, (uint32_t)(SILENCE_S * board.board.hertz / period));
    set(CURVECORE_REFERENCE, (1u << axes) - 1);
    set(CURVECORE_CONTROL, CURVECORE_CONTROL_ENABLE_MASK);
    board.live_period = (int64_t)(SILENCE_S * 1e9 / CURVECORE_SIGNS_OF_LIFE);
    while (!is(CURVECORE_STATE_READY_MASK)) turn();
}

int main(int count, char** given) {
    static const char* const files[] = {"segments.hex", "profile.hex", "words.json"};
    char line[256];
    if (count != 5 || chdir(given[1]) != 0) fail("FOLDER ADDRESS PORT STEPS_PER_MM", "");
    for (int n = 0; n < 3; ++n) {
        FILE* file = fopen(files[n], "r");
        if (!file) fail("no file ", files[n]);
        if (n == 2 && fread(json, 1, sizeof json - 1, file) == 0) fail("nothing in ", files[n]);
        while (n < 2 && counts[n] < MOST_WORDS && fgets(line, sizeof line, file))
            if (line[0] != '/') words[n][counts[n]++] = strtoull(line, NULL, 16);
    }
    struct sockaddr_in there = {.sin_family = AF_INET, .sin_port = htons((uint16_t)atoi(given[3]))};
    wire = socket(AF_INET, SOCK_DGRAM, 0);
    if (inet_pton(AF_INET, given[2], &there.sin_addr) != 1 ||
        connect(wire, (struct sockaddr*)&there, sizeof there) != 0) fail("no address ", given[2]);
    curvecore_start(&board, transmit, &wire, frames, sizeof frames / sizeof *frames);
    curvecore_read_always(&board, CURVECORE_STATE, 1);
    curvecore_read_always(&board, CURVECORE_PATH_LO, 4);
    curvecore_open(&board, (uint32_t)now() * 2654435761u);
    while (board.phase != CURVECORE_OPEN) turn();
    prepare(strtod(given[4], NULL));
    do {
        push(0, CURVECORE_SEGMENT_LO, (int)CURVECORE_FIELD(board.words[ROOM], ROOM_SEGMENT));
        push(1, CURVECORE_PROFILE_LO, (int)CURVECORE_FIELD(board.words[ROOM], ROOM_PROFILE));
        turn();
    } while ((board.words[PATH_LO] | (uint64_t)board.words[PATH_HI] << 32) !=
             (uint64_t)number_of("path_quanta") || is(CURVECORE_STATE_ACTIVE_MASK));
    for (int64_t n = 0, t = now() + 200000000; n < 200 || now() < t; ++n) set(CURVECORE_PROBE, 0);
    set(CURVECORE_CONTROL, 0); /* the last steps are out, also where time goes on with frames */
    return 0;
}
