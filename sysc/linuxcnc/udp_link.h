/* SPDX-License-Identifier: GPL-2.0-or-later
 * Frames of register accesses to a board behind UDP, LBP16 commands with a number each, from a
 * thread that never waits.
 *
 * Each frame with writes says which number the board must have had (EXPECT) and gives it the next
 * (SEQUENCE): lost, doubled or overtaken frames change nothing. Frames go out again until an
 * answer, which every frame asks for, says that they were obeyed. */
#ifndef CURVECORE_UDP_LINK_H
#define CURVECORE_UDP_LINK_H

#include <arpa/inet.h>
#include <fcntl.h>
#include <netdb.h>
#include <stdint.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "../../hls/registers/board_link.h"

#define LINK_LONGEST CURVECORE_LONGEST_FRAME
#define LINK_FRAMES 8                 /* under way at once */
#define LINK_REPEAT 10000000LL        /* ns beyond two round trips without an answer: once more */
#define LINK_LONGEST_WAIT 300000000LL /* ns */
#define LINK_SILENT 1000000000LL      /* ns: the board is gone */
#define LINK_PORT "27181"

enum { WRITE = 0x8000, ADDRESS = 0x4000, WORDS = 0x0200, INCREMENT = 0x0080, PAIR = 0x0100 };

struct link_frame {
    uint8_t bytes[LINK_LONGEST];
    int length;
    uint32_t number;
    int samples;  /* that it carries */
    int64_t sent; /* when, ns; 0: more than once */
};

/* Contents of an answer. */
struct board_status {
    uint32_t state, axes, samples;
    int32_t steps[CURVECORE_MOST_AXES];
    int32_t edges[CURVECORE_MOST_AXES], following[CURVECORE_MOST_AXES]; /* of encoders */
};
/* Contents of the first answer only. */
struct board_kind {
    uint32_t id, version, capability, core, hertz, widths;
};

struct board_link {
    int socket, axes;
    int watched;     /* axes of which encoders are asked for */
    int known;       /* which board it is */
    int same;        /* it is the one that was known before */
    uint32_t number; /* of the last frame that was made */
    uint32_t chance; /* by how much more the next one goes on */
    uint32_t obeyed; /* of the last one that is known to be obeyed */
    struct link_frame frames[LINK_FRAMES];
    int first, count;                /* frames that are not known to be obeyed */
    int64_t answered, sent, went_on; /* when, ns */
    int64_t wait;                    /* until frames are repeated */
    struct board_status status;
    struct board_kind kind;
};

/* HOST[:PORT]; 0: there it is. It may wait: not in the thread. */
static int link_open(struct board_link* link, const char* where, int axes) {
    char host[256], *port;
    struct addrinfo hints, *found;
    memset(link, 0, sizeof *link);
    link->axes = axes;
    strncpy(host, where, sizeof host - 1);
    host[sizeof host - 1] = 0;
    port = strrchr(host, ':');
    if (port) *port++ = 0;
    memset(&hints, 0, sizeof hints);
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_DGRAM;
    if (getaddrinfo(host, port ? port : LINK_PORT, &hints, &found) != 0) return -1;
    link->socket = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (link->socket >= 0 && connect(link->socket, found->ai_addr, found->ai_addrlen) != 0) {
        close(link->socket);
        link->socket = -1;
    }
    freeaddrinfo(found);
    return link->socket >= 0 ? 0 : -1;
}

static void link_half(struct link_frame* frame, unsigned half) {
    frame->bytes[frame->length++] = (uint8_t)half;
    frame->bytes[frame->length++] = (uint8_t)(half >> 8);
}
static void link_word(struct link_frame* frame, uint32_t word) {
    link_half(frame, word & 0xffff);
    link_half(frame, word >> 16);
}
static void link_command(struct link_frame* frame, unsigned flags, unsigned number, unsigned at) {
    link_half(frame, flags | ADDRESS | number);
    link_half(frame, at);
}
static void link_write(struct link_frame* frame, unsigned at, uint32_t word) {
    link_command(frame, WRITE | WORDS, 1, at);
    link_word(frame, word);
}
static unsigned link_steps(int axis) {
    return CURVECORE_AXIS_STEPS + (unsigned)axis * CURVECORE_AXIS_STRIDE;
}

/* Bytes that every frame requests at its end, and bytes of the answer. */
static int link_asked(const struct board_link* link) {
    return 4 * (3 + link->axes + (link->watched > 0 ? 2 : 0));
}
static int link_answered(const struct board_link* link) {
    return 4 * (3 + link->axes + 2 * link->watched);
}
static void link_ask(const struct board_link* link, struct link_frame* frame) {
    int axis;
    link_command(frame, WORDS, 1, CURVECORE_SEQUENCE);
    link_command(frame, WORDS | INCREMENT, 2, CURVECORE_STATE);
    link_command(frame, WORDS, 1, CURVECORE_SAMPLES);
    for (axis = 0; axis < link->axes; ++axis) link_command(frame, WORDS, 1, link_steps(axis));
    if (link->watched == 0) return;
    link_command(frame, WORDS | INCREMENT, (unsigned)link->watched, CURVECORE_ENCODER0);
    link_command(frame, WORDS | INCREMENT, (unsigned)link->watched, CURVECORE_FOLLOWING0);
}
static int link_room(const struct board_link* link, const struct link_frame* frame) {
    return LINK_LONGEST - link_asked(link) - frame->length;
}

static void link_send(struct board_link* link, const struct link_frame* frame, int64_t now) {
    link->sent = now;
    /* A frame that does not go out is as one that is lost. */
    (void)!send(link->socket, frame->bytes, (size_t)frame->length, 0);
}

/* A question without writes; of a board that is not known, which one it is. */
static void link_question(struct board_link* link, int64_t now) {
    struct link_frame frame;
    frame.length = 0;
    if (!link->known) {
        link_command(&frame, WORDS | INCREMENT, 5, CURVECORE_ID);
        link_command(&frame, WORDS, 1, CURVECORE_WIDTHS);
    }
    link_ask(link, &frame);
    link_send(link, &frame, now);
}

/* The next frame with writes; null while as many as may are under way. */
static struct link_frame* link_begin(struct board_link* link) {
    struct link_frame* frame;
    if (link->count == LINK_FRAMES) return NULL;
    frame = &link->frames[(link->first + link->count) % LINK_FRAMES];
    frame->length = 0;
    frame->samples = 0;
    frame->number = link->number + 1 + link->chance;
    link->chance = 0;
    link_command(frame, WRITE | WORDS | PAIR, 1, CURVECORE_EXPECT);
    link_word(frame, link->number);
    link_word(frame, frame->number);
    return frame;
}
static void link_end(struct board_link* link, struct link_frame* frame, int64_t now) {
    link_ask(link, frame);
    link->number = frame->number;
    frame->sent = now;
    if (link->count++ == 0) link->went_on = now;
    link_send(link, frame, now);
}

static uint32_t link_get(const uint8_t** bytes) {
    const uint8_t* at = *bytes;
    *bytes += 4;
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static void link_take(struct board_link* link, const uint8_t* bytes, int64_t now) {
    struct board_status* status = &link->status;
    const uint32_t sequence = link_get(&bytes);
    int64_t went;
    int axis, n;
    if (sequence != link->obeyed) {
        for (n = 0; n < link->count; ++n) {
            if (link->frames[(link->first + n) % LINK_FRAMES].number == sequence) break;
        }
        /* An answer that was overtaken, or the board has another master. */
        if (n == link->count) return;
        went = link->frames[(link->first + n) % LINK_FRAMES].sent;
        if (went != 0) link->wait = LINK_REPEAT + 2 * (now - went);
        link->first = (link->first + n + 1) % LINK_FRAMES;
        link->count -= n + 1;
        link->obeyed = sequence;
        link->went_on = now;
    }
    status->state = link_get(&bytes);
    status->axes = link_get(&bytes);
    status->samples = link_get(&bytes);
    for (axis = 0; axis < link->axes; ++axis) status->steps[axis] = (int32_t)link_get(&bytes);
    for (n = 0; n < link->watched; ++n) status->edges[n] = (int32_t)link_get(&bytes);
    for (n = 0; n < link->watched; ++n) status->following[n] = (int32_t)link_get(&bytes);
    link->answered = now;
}

/* The board as it is now; its first frame has a number that no frame under way can expect. */
static void link_know(struct board_link* link, const uint8_t* bytes, int64_t now) {
    struct board_kind* kind = &link->kind;
    const uint8_t* status;
    int n;
    kind->id = link_get(&bytes);
    kind->version = link_get(&bytes);
    kind->capability = link_get(&bytes);
    kind->core = link_get(&bytes);
    kind->hertz = link_get(&bytes);
    kind->widths = link_get(&bytes);
    status = bytes;
    link->number = link_get(&bytes);
    link->same = link->number == link->obeyed;
    for (n = 0; n < link->count; ++n) {
        link->same |= link->number == link->frames[(link->first + n) % LINK_FRAMES].number;
    }
    link->obeyed = link->number;
    link->first = link->count = 0;
    link->wait = LINK_REPEAT;
    link->chance = (uint32_t)now * 2654435761u;
    link->known = kind->id == CURVECORE_ID_ID_VALUE && curvecore_knows(kind->version);
    link_take(link, status, now);
    link->watched = kind->capability & CURVECORE_CAPABILITY_ENCODERS_MASK ? link->axes : 0;
}

/* Takes the answers. A board that is silent, or no longer obeys, has to be identified again. */
static void link_receive(struct board_link* link, int64_t now) {
    uint8_t bytes[LINK_LONGEST + 64];
    ssize_t got;
    while ((got = recv(link->socket, bytes, sizeof bytes, 0)) >= 0) {
        const int answered = link_answered(link) + 4;
        if (!link->known && got == answered + 24) {
            link_know(link, bytes, now);
        } else if (link->known && got == answered) {
            link_take(link, bytes, now);
        }
    }
    if (now - link->answered > LINK_SILENT) link->known = link->watched = 0;
}

/* Once more what is not answered. A question, where nothing is under way: a board that is slow gets
 * no more of them than it answers. With a number, if the board is to know that its host is alive:
 * any program may ask without one. */
static void link_keep(struct board_link* link, int64_t now, int alive) {
    int n;
    if (link->count > 0 && now - link->went_on > link->wait) {
        link->went_on = now;
        if (link->wait < LINK_LONGEST_WAIT) link->wait *= 2;
        for (n = 0; n < link->count; ++n) {
            struct link_frame* frame = &link->frames[(link->first + n) % LINK_FRAMES];
            frame->sent = 0;
            link_send(link, frame, now);
        }
    }
    if (link->count == 0 && (link->answered >= link->sent || now - link->sent > link->wait)) {
        if (alive && link->known) {
            link_end(link, link_begin(link), now);
        } else {
            link_question(link, now);
        }
    }
}

#endif
