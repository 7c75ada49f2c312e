/* SPDX-License-Identifier: GPL-2.0-or-later
 * hls/registers/board_link.h behind UDP, from a thread that never waits: what the component reads
 * of a board with every frame. */
#ifndef CURVECORE_UDP_LINK_H
#define CURVECORE_UDP_LINK_H

#include <arpa/inet.h>
#include <fcntl.h>
#include <netdb.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "../../hls/registers/board_link.h"

#define LINK_FRAMES 8           /* under way at once */
#define LINK_SILENT 1000000000L /* ns: the board is gone */
#define LINK_PORT "27181"

/* Contents of an answer. */
struct board_status {
    uint32_t state, axes, samples;
    int32_t steps[CURVECORE_MOST_AXES];
    int32_t edges[CURVECORE_MOST_AXES], following[CURVECORE_MOST_AXES]; /* of encoders */
};

struct udp_link {
    int socket, axes;
    int heard;     /* it is known which board it is, and what it says */
    struct board_status status;
    struct curvecore_link wire;
    struct curvecore_sent sent[LINK_FRAMES];
};

/* A frame that does not go out is as one that is lost. */
static void link_transmit(void* device, const uint8_t* bytes, int length) {
    (void)!send(((struct udp_link*)device)->socket, bytes, (size_t)length, 0);
}

/* HOST[:PORT]; 0: there it is. It may wait: not in the thread. */
static int link_open(struct udp_link* link, const char* where, int axes) {
    char host[256], *port;
    struct addrinfo hints, *found;
    unsigned axis;
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
    curvecore_start(&link->wire, link_transmit, link, link->sent, LINK_FRAMES);
    link->wire.poll_period = 0; /* the thread's */
    /* Order of link_understand(); without inputs of encoders these are 0. */
    curvecore_read_always(&link->wire, CURVECORE_STATE, 2);
    curvecore_read_always(&link->wire, CURVECORE_SAMPLES, 1);
    for (axis = 0; axis < (unsigned)axes; ++axis) {
        curvecore_read_always(&link->wire, CURVECORE_AXIS_STEPS + axis * CURVECORE_AXIS_STRIDE,
                              1);
    }
    curvecore_read_always(&link->wire, CURVECORE_ENCODER0, axes);
    curvecore_read_always(&link->wire, CURVECORE_FOLLOWING0, axes);
    return link->socket >= 0 ? 0 : -1;
}

static void link_understand(struct udp_link* link) {
    const uint32_t* word = link->wire.words;
    int axis;
    link->status.state = *word++;
    link->status.axes = *word++;
    link->status.samples = *word++;
    for (axis = 0; axis < link->axes; ++axis) link->status.steps[axis] = (int32_t)*word++;
    for (axis = 0; axis < link->axes; ++axis) link->status.edges[axis] = (int32_t)*word++;
    for (axis = 0; axis < link->axes; ++axis) link->status.following[axis] = (int32_t)*word++;
}

/* Takes the answers. A board that is silent, or obeys another host, has to be known anew. */
static void link_receive(struct udp_link* link, int64_t now) {
    uint8_t bytes[1024];
    ssize_t got;
    while ((got = recv(link->socket, bytes, sizeof bytes, 0)) >= 0) {
        if (curvecore_take(&link->wire, bytes, (int)got, now) != CURVECORE_STATUS) continue;
        link_understand(link);
        link->heard = 1;
    }
    if (curvecore_silence(&link->wire, now) > LINK_SILENT) {
        curvecore_lose(&link->wire);
        link->heard = 0;
    }
}

/* The next frame; null: none may go out yet. */
static struct curvecore_frame* link_begin(struct udp_link* link, int64_t now) {
    if (curvecore_may_send(&link->wire)) return curvecore_begin(&link->wire);
    if (link->wire.phase == CURVECORE_KNOWN) {
        curvecore_open(&link->wire, (uint32_t)now * 2654435761u);
    }
    return NULL;
}

#endif
