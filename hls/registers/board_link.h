/* SPDX-License-Identifier: Apache-2.0 OR GPL-2.0-or-later
 * A host's end of the wire to a board, for C99 and C++, computers and microcontrollers: frames that
 * the board obeys, each once and in order, over a link that loses, doubles and delays (go-back-N).
 * What is not known to be taken is sent again. sysc/wire/README.md explains the wire.
 *
 * Nothing here waits, allocates or knows a device. The caller sends what it is given to send, hands
 * in what came, curvecore_take(), then lets time go on, curvecore_work(); it says what time it is,
 * in ns, which never goes back. A host that does so: hls/examples/stream_words.c.
 */
#ifndef CURVECORE_BOARD_LINK_H
#define CURVECORE_BOARD_LINK_H

#include "board_facts.h"
#include "board_frame.h"

/* Most words that are always read, and most words of a question. */
#define CURVECORE_MOST_ALWAYS 64
#define CURVECORE_MOST_ASKED 8
/* Consecutive questions whose answers are distinguished. */
#define CURVECORE_QUESTIONS 16
/* Epochs of frames, which the length of an answer identifies. Frames sent before the epoch began
 * are taken when that answer comes, or were lost or overtaken: then they are sent again at once,
 * and so are those behind them. An epoch lasts until one of its frames is answered, or goes again;
 * no other begins while answers of as many may still come, or a late one would be taken for one of
 * these. */
#define CURVECORE_EPOCHS 5
/* Frames repeated at once: if many are lost, few are taken before the next missing one. */
#define CURVECORE_MOST_REPEATED 16
/* Frames without a number between two with one: a fast board's clock advances by frames. */
#define CURVECORE_MOST_POLLS 20
/* Least number of frames with a number in the time of WATCHDOG: curvecore_link.live_period. */
#define CURVECORE_SIGNS_OF_LIFE 5
/* Largest lateness of an answer, in numbers; a later one belongs to another session. */
#define CURVECORE_LATE 0x100000
/* Least time, ns, until an unanswered frame is repeated; also while no round trip is known. */
#define CURVECORE_UNANSWERED 25000000
/* The time until something goes again doubles while nothing that was sent since is answered, so
 * often, up to this, ns, or two round trips: else all that waits before a slow board would never
 * get less. */
#define CURVECORE_MOST_DOUBLED 6
#define CURVECORE_AGAIN 250000000

/* A frame under way. */
struct curvecore_sent {
    struct curvecore_frame frame; /* without the words always read */
    int words[2];                 /* words that it carries, of two kinds: the caller's count */
    int64_t sent;
    int repeated;
};

/* Identity of a board, register by register. */
struct curvecore_board {
    uint32_t id, version, capability, core, hertz, widths;
};

/* Phases of a link. Unknown: the board's identity is requested. Known: it is only read. Open: it
 * obeys this host alone. */
enum curvecore_phase { CURVECORE_UNKNOWN, CURVECORE_KNOWN, CURVECORE_OPEN };

/* Kinds of an answer: late, or to no question; with the words always read; to the question; from a
 * board that was restarted, or has another master. */
enum curvecore_news { CURVECORE_OLD, CURVECORE_STATUS, CURVECORE_ANSWER, CURVECORE_FOREIGN };

struct curvecore_link {
    /* The caller may set these at any time, ns. */
    int64_t poll_period; /* period of an idle host's requests */
    int64_t live_period; /* period of frames with a number, for WATCHDOG; 0: none */

    /* Results. */
    enum curvecore_phase phase;
    struct curvecore_board board;
    int same;                              /* 1: the board that was known before */
    uint32_t words[CURVECORE_MOST_ALWAYS]; /* last values of the words always read */
    uint32_t answer[CURVECORE_MOST_ASKED]; /* answer to the last question */
    int asks;                              /* 1: it is not answered yet */
    int count;                             /* frames under way */
    uint32_t frames, repeated;             /* frames sent */
    int64_t round_trip;                    /* 0: not known */

    /* Private. */
    void (*transmit)(void* device, const uint8_t* bytes, int length);
    void* device;
    struct curvecore_sent* sent; /* a ring */
    int window, first;
    struct curvecore_frame always;
    int words_always;
    uint32_t number; /* number of the last frame made */
    uint32_t opens;  /* number of the first frame of a requested session */
    int opening;
    struct curvecore_frame question;
    int words_asked, questions, of_itself;
    int64_t asked, transmitted, numbered, waits_since, deviation;
    int waits, polls, epoch, epochs; /* epochs begun since that of the latest answer */
    int doubled, asked_again; /* doublings: of frames with a number, of questions */
    uint32_t reach[CURVECORE_EPOCHS]; /* numbers up to this were sent before the epoch */
};

/* Starts a link: up to `window` frames, kept at `sent`, may be under way. */
static inline void curvecore_start(struct curvecore_link* link,
                                   void (*transmit)(void* device, const uint8_t* bytes, int length),
                                   void* device, struct curvecore_sent* sent, int window) {
    unsigned n;
    for (n = 0; n < sizeof *link; ++n) ((uint8_t*)link)[n] = 0;
    link->transmit = transmit;
    link->device = device;
    link->sent = sent;
    link->window = window;
    link->poll_period = 1000000;
    link->deviation = 50000000;
}

/* Reads words from this address on with each frame; before the first curvecore_work(). */
static inline void curvecore_read_always(struct curvecore_link* link, uint32_t address, int words) {
    curvecore_read(&link->always, address, words);
    link->words_always += words;
}

/* Returns frame n of those under way, the oldest first; that of link->count is the next. */
static inline struct curvecore_sent* curvecore_sent_at(struct curvecore_link* link, int n) {
    return &link->sent[(link->first + n) % link->window];
}

static inline void curvecore_transmit(struct curvecore_link* link,
                                      const struct curvecore_frame* frame, int64_t now) {
    link->transmit(link->device, frame->bytes, frame->length);
    ++link->frames;
    link->transmitted = now;
    if (!link->waits) link->waits_since = now;
    link->waits = 1;
}

/* Marks a frame by the length of its answer, with extra words: answers do not name their frame. */
static inline void curvecore_mark(struct curvecore_frame* frame, int words) {
    curvecore_command(frame, CURVECORE_COMMAND_WORDS, words, CURVECORE_ID);
}

/* Sends commands, or none, and what is always read; before a session marked as of no epoch. */
static inline void curvecore_transmit_reading(struct curvecore_link* link,
                                              const struct curvecore_frame* commands, int64_t now) {
    struct curvecore_frame frame;
    frame.length = 0;
    if (commands) curvecore_append(&frame, commands);
    curvecore_append(&frame, &link->always);
    curvecore_read(&frame, CURVECORE_SEQUENCE, 1);
    curvecore_mark(&frame, 1 + (link->phase == CURVECORE_OPEN ? link->epoch : CURVECORE_EPOCHS));
    curvecore_transmit(link, &frame, now);
}

/* Asks a question, of at most CURVECORE_MOST_ASKED words; while none is unanswered. */
static inline void curvecore_ask(struct curvecore_link* link, const struct curvecore_frame* reads,
                                 int words, int64_t now) {
    const int least = link->words_always + 1 + CURVECORE_EPOCHS + 1 + CURVECORE_MOST_ASKED;
    link->questions = (link->questions + 1) % CURVECORE_QUESTIONS;
    link->words_asked = words;
    link->of_itself = 0;
    link->question = *reads;
    curvecore_mark(&link->question, least + 1 + link->questions - words);
    link->asks = 1;
    link->asked = now;
    curvecore_transmit(link, &link->question, now);
}

/* Asks what the board is; a known board behind the number that opens a session. */
static inline void curvecore_ask_board(struct curvecore_link* link, int64_t now) {
    struct curvecore_frame reads;
    reads.length = 0;
    if (link->phase == CURVECORE_KNOWN) curvecore_number(&reads, link->number, link->opens);
    curvecore_read(&reads, CURVECORE_ID, 5);
    curvecore_read(&reads, CURVECORE_WIDTHS, 1);
    curvecore_read(&reads, CURVECORE_SEQUENCE, 1);
    curvecore_ask(link, &reads, 7, now);
    link->of_itself = 1;
}

/* Begins a session as soon as the board is known. `first` is a random number that no frame under
 * way has: of another host, or of this one before a restart. */
static inline void curvecore_open(struct curvecore_link* link, uint32_t first) {
    if (!link->opening) link->opens = first;
    link->opening = 1;
}

/* Forgets the board, which is gone or has another master: it is asked again what it is. */
static inline void curvecore_lose(struct curvecore_link* link) {
    link->phase = CURVECORE_UNKNOWN;
    link->asks = link->opening = link->waits = link->asked_again = link->doubled = 0;
}

/* Returns the ns for which something is unanswered. */
static inline int64_t curvecore_silence(const struct curvecore_link* link, int64_t now) {
    return link->waits ? now - link->waits_since : 0;
}

static inline int curvecore_may_send(const struct curvecore_link* link) {
    return link->phase == CURVECORE_OPEN && link->count < link->window;
}

/* Begins the next frame, for commands; only if it may be sent. curvecore_send() sends it. */
static inline struct curvecore_frame* curvecore_begin(struct curvecore_link* link) {
    struct curvecore_frame* frame = &curvecore_sent_at(link, link->count)->frame;
    frame->length = 0;
    curvecore_number(frame, link->number, link->number + 1);
    return frame;
}

/* Returns the bytes of commands, with their data, that a frame has room for. */
static inline int curvecore_room(const struct curvecore_link* link,
                                 const struct curvecore_frame* frame) {
    return CURVECORE_LONGEST_FRAME - frame->length - link->always.length -
           2 * CURVECORE_COMMAND_BYTES;
}

/* Returns the words of 48 bits that one more push may have. */
static inline int curvecore_room_for_words(const struct curvecore_link* link,
                                           const struct curvecore_frame* frame) {
    return (curvecore_room(link, frame) - CURVECORE_COMMAND_BYTES) / CURVECORE_PUSHED_BYTES;
}

/* Sends the frame begun, with the words that it carries: curvecore_under_way(). */
static inline void curvecore_send(struct curvecore_link* link, int words, int others, int64_t now) {
    struct curvecore_sent* sent = curvecore_sent_at(link, link->count);
    sent->words[0] = words;
    sent->words[1] = others;
    sent->sent = link->numbered = now;
    sent->repeated = 0;
    link->polls = 0;
    ++link->number;
    ++link->count;
    curvecore_transmit_reading(link, &sent->frame, now);
}

/* Returns the words of this kind, 0 or 1, in frames under way: they take as much of the room that
 * the board reports. */
static inline int curvecore_under_way(struct curvecore_link* link, int kind) {
    int words = 0, n;
    for (n = 0; n < link->count; ++n) words += curvecore_sent_at(link, n)->words[kind];
    return words;
}

static inline void curvecore_begin_epoch(struct curvecore_link* link) {
    if (link->epochs == CURVECORE_EPOCHS - 1) return;
    ++link->epochs;
    link->epoch = (link->epoch + 1) % CURVECORE_EPOCHS;
    link->reach[link->epoch] = link->number;
}

static inline void curvecore_repeat(struct curvecore_link* link, int64_t now) {
    int n;
    for (n = 0; n < link->count; ++n) {
        struct curvecore_sent* sent = curvecore_sent_at(link, n);
        sent->repeated = 1;
        if (n >= CURVECORE_MOST_REPEATED) continue;
        curvecore_transmit_reading(link, &sent->frame, now);
        sent->sent = now;
        ++link->repeated;
    }
    /* Answers to earlier frames say nothing of these. */
    for (n = 0; n < CURVECORE_EPOCHS; ++n) link->reach[n] = link->number - (uint32_t)link->count;
    curvecore_begin_epoch(link);
}

/* Jacobson's and Karels' estimate. */
static inline void curvecore_measure(struct curvecore_link* link, int64_t seen) {
    const int64_t mean = link->round_trip == 0 ? seen : link->round_trip;
    const int64_t off = seen < mean ? mean - seen : seen - mean;
    link->deviation += (off - link->deviation) / 4;
    link->round_trip = mean + (seen - mean) / 8;
}

static inline int64_t curvecore_longer(int64_t a, int64_t b) { return a > b ? a : b; }

/* Returns the time until something goes again, after so many doublings. */
static inline int64_t curvecore_doubled(int64_t time, int doublings) {
    const int64_t more = time << doublings;
    return more < CURVECORE_AGAIN ? more : curvecore_longer(time, CURVECORE_AGAIN);
}

/* Time until another question: two round trips at first. */
static inline int64_t curvecore_unanswered(const struct curvecore_link* link) {
    const int64_t trip = curvecore_longer(link->round_trip, link->poll_period);
    return curvecore_doubled(link->round_trip == 0 ? CURVECORE_UNANSWERED : 2 * trip,
                             link->asked_again);
}

/* Notes that a question goes again. */
static inline void curvecore_ask_again(struct curvecore_link* link) {
    if (link->asked_again < CURVECORE_MOST_DOUBLED) ++link->asked_again;
}

/* Notes an answer to something of late. */
static inline void curvecore_answered(struct curvecore_link* link) {
    link->waits = link->asked_again = 0;
}

/* Time until the same frame goes again. */
static inline int64_t curvecore_patience(const struct curvecore_link* link) {
    const int64_t wait = link->round_trip + 4 * link->deviation;
    const int64_t least = curvecore_longer(2 * link->poll_period, CURVECORE_UNANSWERED);
    return curvecore_doubled(curvecore_longer(wait, least), link->doubled);
}

/* Asks, reports that the host is alive, repeats what is overdue: now and then, when all answers
 * that came are taken. */
static inline void curvecore_work(struct curvecore_link* link, int64_t now) {
    const int64_t since = now - link->transmitted;
    if (link->asks) {
        if (now - link->asked >= curvecore_unanswered(link)) {
            link->asked = now;
            curvecore_ask_again(link);
            curvecore_transmit(link, &link->question, now);
        }
    } else if (link->phase == CURVECORE_UNKNOWN || link->opening) {
        if (link->phase == CURVECORE_KNOWN || link->frames == 0 || since >= CURVECORE_UNANSWERED) {
            curvecore_ask_board(link, now);
        }
    }
    if (link->phase == CURVECORE_OPEN && link->count == 0 && link->live_period > 0 &&
        (link->polls >= CURVECORE_MOST_POLLS || now - link->numbered >= link->live_period)) {
        curvecore_begin(link);
        curvecore_send(link, 0, 0, now);
    } else if (!link->asks && link->phase != CURVECORE_UNKNOWN && !link->opening &&
               since >= (link->waits ? curvecore_unanswered(link) : link->poll_period)) {
        if (link->waits) curvecore_ask_again(link);
        curvecore_transmit_reading(link, 0, now);
        ++link->polls;
    }
    if (link->phase == CURVECORE_OPEN && link->count > 0 &&
        now - curvecore_sent_at(link, 0)->sent >= curvecore_patience(link)) {
        curvecore_repeat(link, now);
        if (link->doubled < CURVECORE_MOST_DOUBLED) ++link->doubled;
    }
}

/* Handles the answer of a board that was asked what it is. */
static inline void curvecore_know(struct curvecore_link* link) {
    const uint32_t *said = link->answer, number = said[6];
    const struct curvecore_board board = {said[0], said[1], said[2], said[3], said[4], said[5]};
    int n;
    if (link->phase == CURVECORE_UNKNOWN) {
        link->same = link->number - number <= (uint32_t)link->count;
        link->board = board;
        link->count = link->first = 0;
        link->phase = board.id == CURVECORE_ID_ID_VALUE && curvecore_knows(board.version)
                          ? CURVECORE_KNOWN
                          : CURVECORE_UNKNOWN;
    } else if (number == link->opens) {
        link->phase = CURVECORE_OPEN;
        link->opening = 0;
        for (n = 0; n < CURVECORE_EPOCHS; ++n) link->reach[n] = number;
    }
    link->number = number;
}

/* Handles the board's number: frames up to it are taken. */
static inline enum curvecore_news curvecore_obeyed(struct curvecore_link* link, uint32_t number,
                                                   int epoch, int64_t now) {
    const int32_t taken = (int32_t)(number - (link->number - (uint32_t)link->count));
    const int back = (link->epoch - epoch + CURVECORE_EPOCHS) % CURVECORE_EPOCHS;
    int n;
    if (taken < 0 && taken > -CURVECORE_LATE) return CURVECORE_OLD;
    if (taken < 0 || taken > link->count) return CURVECORE_FOREIGN;
    for (n = 0; n < taken; ++n) {
        const struct curvecore_sent* sent = curvecore_sent_at(link, 0);
        if (!sent->repeated) { /* Karn: of the others, nobody knows which was answered */
            curvecore_measure(link, now - sent->sent);
            link->doubled = 0;
        }
        link->first = (link->first + 1) % link->window;
        --link->count;
    }
    if (back > link->epochs) return CURVECORE_STATUS; /* it was overtaken */
    link->epochs = back;
    if (back == 0) curvecore_answered(link);
    /* The answer's request followed the first remaining frame, and did not meet it. */
    if (link->count > 0 && (int32_t)(link->reach[epoch] - number) > 0) {
        curvecore_repeat(link, now);
    } else if (back == 0) {
        curvecore_begin_epoch(link);
    }
    return CURVECORE_STATUS;
}

/* Takes an answer of the board. */
static inline enum curvecore_news curvecore_take(struct curvecore_link* link, const uint8_t* bytes,
                                                 int length, int64_t now) {
    const int marks = length / 4 - link->words_always - 1;
    const int of_question =
        CURVECORE_EPOCHS + 1 + CURVECORE_MOST_ASKED + 1 + link->questions;
    enum curvecore_news news = CURVECORE_STATUS;
    int n;
    if (length % 4 != 0) return CURVECORE_OLD;
    if (link->asks && marks == of_question) {
        for (n = 0; n < link->words_asked; ++n) link->answer[n] = curvecore_word(bytes, n);
        link->asks = 0;
        curvecore_answered(link);
        if (link->of_itself) curvecore_know(link);
        return CURVECORE_ANSWER;
    }
    if (link->phase == CURVECORE_OPEN && marks >= 1 && marks <= CURVECORE_EPOCHS) {
        if (link->waits) link->waits_since = now;
        news = curvecore_obeyed(link, curvecore_word(bytes, link->words_always), marks - 1, now);
    } else if (link->phase == CURVECORE_KNOWN && marks == CURVECORE_EPOCHS + 1) {
        link->number = curvecore_word(bytes, link->words_always);
        curvecore_answered(link);
    } else {
        return CURVECORE_OLD;
    }
    for (n = 0; news == CURVECORE_STATUS && n < link->words_always; ++n) {
        link->words[n] = curvecore_word(bytes, n);
    }
    return news;
}

#endif
