// SPDX-License-Identifier: GPL-2.0-or-later
component curvecore "a curvecore board in position mode, behind UDP";
description """
Step and direction pins of a board that has rtl/motion_board.sv behind UDP, or of a virtual one
(`curvecore board`), as the step generator of the joints of a machine.

    loadrt curvecore personality=3 address=192.168.1.121:27181
    addf curvecore.read servo-thread
    addf motion-command-handler servo-thread
    addf motion-controller servo-thread
    addf curvecore.write servo-thread
    net on joint.0.amp-enable-out => curvecore.enable
    net fault curvecore.fault => joint.0.amp-fault-in
    net hold curvecore.hold => motion.feed-inhibit

personality is the number of joints, 9 at most, and not more than the board has axes. Each servo
period becomes samples of the board's period; these wait, buffer-time of them, before they are
drawn, so position-fb is as late: FERROR has to allow buffer-time and two servo periods at full
speed. The samples' distance follows the level of the buffer, which keeps the two clocks together.

A servo thread that comes late by less than buffer-time changes no step. If it comes later while
joints move, they wait where they are and go on with the next sample: late counts that, and no
position is lost. Where the board or its link comes late, more samples wait; hold stops the motion
on its path until they are drawn. A thread that is silent for watchdog-time turns the drives off,
and so does a board that does not answer for a second.

A board with inputs of encoders watches the joints that have encoder-counts: a joint whose encoder
is following-limit away from where its steps say turns the drives off.""";

pin in bit enable "drives on; a fault goes when it is off";
pin out bit enabled "drives are on, and joints follow";
pin out bit fault "the board went off by itself, or cannot be reached: amp-fault-in";
pin out u32 faults "what the board says, STATE of hls/registers/registers.rdl";
pin out bit following_fault "a joint was beyond its following-limit";
pin out bit encoder_fault "edges of an encoder came too fast, or both at once";
pin out s32 fault_joint "of these two: of the first; -1: there is none";
pin out bit connected "the board answers";
pin out bit estop_in "level of the board's pin";
pin out bit hold "too many samples wait: to motion.feed-inhibit";
pin out u32 late "samples that were not there in time while joints moved";
pin out float latency "s that a new position waits";

pin in float joint.#.position_cmd[9:personality];
pin out float joint.#.position_fb[9:personality] "steps that were given, in the machine's unit";
pin out s32 joint.#.counts[9:personality] "steps that were given";
pin out s32 joint.#.encoder[9:personality] "edges since the board's reset";
pin out float joint.#.following[9:personality] "steps less edges, in the machine's unit";
pin out bit joint.#.limit[9:personality] "level of the limit switch";

param rw float joint.#.scale[9:personality] = 1 "steps per unit; read when drives come on, as all";
param rw bit joint.#.invert_step[9:personality] "a pulse is low";
param rw bit joint.#.invert_dir[9:personality];
param rw bit joint.#.ignore_limit[9:personality];
param rw u32 joint.#.encoder_counts[9:personality] "so many edges, 65535 at most; 0: no encoder";
param rw s32 joint.#.encoder_steps[9:personality] = 1 "are so many steps; negative: backwards";
param rw float joint.#.following_limit[9:personality] "in the machine's unit; 0: none";
param rw u32 steplen = 2000 "ns, as those below";
param rw u32 stepspace = 2000;
param rw u32 dirsetup = 4000;
param rw u32 dirhold = 4000;
param rw float buffer_time = 0.004 "s that samples wait before they are drawn";
param rw float watchdog_time = 0.1 "s";

modparam dummy address "HOST[:PORT] of the board";

option singleton yes;
option extra_setup yes;
option extra_cleanup yes;
include <rtapi_errno.h>;
include <rtapi_math.h>;
include "udp_link.h";
include "sample_line.h";
function read_ fp "what the board says: before motion";
function write_ fp "where the joints shall go: behind motion";
license "GPL";
author "curvecore";
;;
static char *address = "127.0.0.1:" LINK_PORT;
RTAPI_MP_STRING(address, "HOST[:PORT] of the board");

#define AGAIN 50000000LL /* ns until drives that did not come on are tried again */
#define LONGEST 2000000000LL /* ns until they are a fault */

enum mode { OFF, COMING, ON, FAULT };
static enum mode mode;
static int64_t tried, began;
static struct udp_link link_;
static struct sample_line line;
static int64_t steps[CURVECORE_MOST_AXES];     /* given, as far as it is known */
static int32_t seen[CURVECORE_MOST_AXES];      /* of the board, when they were */
static int joints, was_known, was_late;

#define FIELD CURVECORE_FIELD
#define BOARD link_.wire.board
#define WATCHED (CURVECORE_STATE_ENCODER_MASK | CURVECORE_STATE_FOLLOWING_MASK)
#define STATE_HAS(name) ((link_.status.state & CURVECORE_STATE_##name##_MASK) != 0)

static double sample_seconds(void) {
    return (double)(1u << FIELD(BOARD.capability, CAPABILITY_PERIOD_LOG2)) / BOARD.hertz;
}
static int has_encoders(void) { return FIELD(BOARD.capability, CAPABILITY_ENCODERS) != 0; }
/* Times are rounded up. */
static uint64_t clocks(uint32_t ns) {
    return ((uint64_t)ns * BOARD.hertz + 999999999u) / 1000000000u;
}

EXTRA_SETUP() {
    joints = personality;
    if (joints < 1 || joints > CURVECORE_MOST_AXES) {
        rtapi_print_msg(RTAPI_MSG_ERR, "curvecore: personality is the number of joints, 1 to %d\n",
                        CURVECORE_MOST_AXES);
        return -EINVAL;
    }
    if (link_open(&link_, address, joints) != 0) {
        rtapi_print_msg(RTAPI_MSG_ERR, "curvecore: no such address: %s\n", address);
        return -EINVAL;
    }
    return 0;
}
EXTRA_CLEANUP() { close(link_.socket); }

FUNCTION(read_) {
    const int64_t now = rtapi_get_time();
    const uint32_t mask = (1u << joints) - 1;
    int n;
    link_receive(&link_, now);
    connected = link_.heard && joints <= (int)FIELD(BOARD.capability, CAPABILITY_AXES);
    if (connected) {
        const uint32_t limits = FIELD(link_.status.axes, AXES_LIMIT) & mask;
        for (n = 0; n < joints; ++n) {
            /* A board that was restarted counts anew. */
            if (was_known || link_.wire.same) {
                steps[n] += (int32_t)(link_.status.steps[n] - seen[n]);
            }
            seen[n] = link_.status.steps[n];
            joint_counts(n) = (int32_t)steps[n];
            joint_position_fb(n) = steps[n] / joint_scale(n);
            joint_limit(n) = limits >> n & 1;
            joint_encoder(n) = link_.status.edges[n];
            joint_following(n) =
                joint_encoder_counts(n) == 0
                    ? 0
                    : link_.status.following[n] / (joint_scale(n) * joint_encoder_counts(n));
        }
        faults = link_.status.state & CURVECORE_FAULTS;
        following_fault = STATE_HAS(FOLLOWING);
        encoder_fault = STATE_HAS(ENCODER);
        fault_joint = (faults & WATCHED) ? (int)FIELD(link_.status.state, STATE_FAULT_AXIS) : -1;
        estop_in = STATE_HAS(ESTOP_PIN);
        if (STATE_HAS(LATE) && !was_late) ++late;
        was_late = STATE_HAS(LATE);
    }
    was_known = connected;
    if (mode == ON && !(connected && STATE_HAS(ENABLED))) mode = FAULT;
    if (mode == FAULT && !enable) mode = OFF;
    fault = mode == FAULT;
    enabled = mode == ON;
}

/* Of a joint that the board shall watch; not 0: it cannot. */
static int encoder_of(struct __comp_state *__comp_inst, int n, uint32_t *ratio, uint32_t *limit) {
    const uint32_t counts_ = joint_encoder_counts(n);
    const int32_t steps_ = joint_encoder_steps(n);
    const double units = floor(joint_following_limit(n) * fabs(joint_scale(n)) * counts_);
    *ratio = *limit = 0;
    if (counts_ == 0) return 0;
    if (!has_encoders() || counts_ > CURVECORE_MOST(ENCODER_RATIO0_COUNTS) || steps_ == 0 ||
        steps_ < -32767 || steps_ > 32767 || !(units >= 0 && units <= CURVECORE_MOST_FOLLOWING) ||
        (joint_following_limit(n) > 0 && units < 1)) {
        return -1;
    }
    *ratio = counts_ | CURVECORE_PUT(ENCODER_RATIO0_STEPS, steps_);
    *limit = (uint32_t)units;
    return 0;
}
static int watchable(struct __comp_state *__comp_inst) {
    uint32_t ratio, limit;
    int n;
    for (n = 0; n < joints; ++n) {
        if (encoder_of(__comp_inst, n, &ratio, &limit) == 0) continue;
        rtapi_print_msg(RTAPI_MSG_ERR, "curvecore: joint.%d: %s\n", n,
                        !has_encoders()
                            ? "encoder-counts, and the board has no inputs of encoders"
                            : "encoder-counts, encoder-steps or following-limit beyond the board");
        return 0;
    }
    return 1;
}

/* 2^-16 steps in the whole range of positions, of LINE_UNITS in a step each. */
static uint64_t scale_of_joints(void) {
    return (uint64_t)1 << (FIELD(BOARD.core, CORE_POSITION_BITS) + 16 - LINE_UNIT_BITS);
}
/* Whether the board has room for them: what does not fit would be cut there. */
static int fits(struct __comp_state *__comp_inst) {
    const uint32_t most = curvecore_most_clocks(BOARD.widths);
    const uint32_t times[4] = {steplen, stepspace, dirsetup, dirhold};
    static const char *const names[4] = {"steplen", "stepspace", "dirsetup", "dirhold"};
    int n;
    for (n = 0; n < 4; ++n) {
        if (clocks(times[n]) <= most) continue;
        rtapi_print_msg(RTAPI_MSG_ERR,
                        "curvecore: %s: %u ns are more than %u clocks of the board\n", names[n],
                        (unsigned)times[n], (unsigned)most);
        return 0;
    }
    if (scale_of_joints() < curvecore_scale_end(BOARD.widths)) return 1;
    rtapi_print_msg(RTAPI_MSG_ERR, "curvecore: the board's scales have %u bits, too few\n",
                    (unsigned)FIELD(BOARD.widths, WIDTHS_SCALE_BITS));
    return 0;
}

/* Drives off, then all that stands still while they are on. */
static int settings(struct __comp_state *__comp_inst, int64_t now) {
    struct curvecore_frame *frame = link_begin(&link_, now);
    const double silence = watchdog_time / sample_seconds();
    uint32_t step = 0, direction = 0, masked = 0, ratio, limit;
    int n;
    if (!frame) return -1;
    curvecore_write(frame, CURVECORE_CONTROL, 0);
    for (n = 0; n < joints; ++n) {
        const unsigned axis = (unsigned)n * CURVECORE_AXIS_STRIDE;
        const uint64_t scale = scale_of_joints();
        curvecore_write(frame, CURVECORE_AXIS_SCALE_LO + axis, (uint32_t)scale);
        curvecore_write(frame, CURVECORE_AXIS_SCALE_HI + axis, (uint32_t)(scale >> 32));
        step |= (uint32_t)(joint_invert_step(n) != 0) << n;
        direction |= (uint32_t)(joint_invert_dir(n) != 0) << n;
        masked |= (uint32_t)(joint_ignore_limit(n) != 0) << n;
    }
    curvecore_send(&link_.wire, 0, 0, now);
    for (n = 0; n < (has_encoders() ? joints : 0); ++n) {
        if (n % 4 == 0 && !(frame = link_begin(&link_, now))) return -1;
        encoder_of(__comp_inst, n, &ratio, &limit);
        curvecore_write(frame, CURVECORE_ENCODER_RATIO0 + 4 * (unsigned)n, ratio);
        curvecore_write(frame, CURVECORE_FOLLOWING_LIMIT0 + 4 * (unsigned)n, limit);
        if (n % 4 == 3 || n == joints - 1) curvecore_send(&link_.wire, 0, 0, now);
    }
    frame = link_begin(&link_, now);
    if (!frame) return -1;
    curvecore_write(frame, CURVECORE_PULSE,
                    CURVECORE_PUT(PULSE_STEPLEN, clocks(steplen)) |
                        CURVECORE_PUT(PULSE_STEPSPACE, clocks(stepspace)));
    curvecore_write(frame, CURVECORE_DIRECTION,
                    CURVECORE_PUT(DIRECTION_DIRSETUP, clocks(dirsetup)) |
                        CURVECORE_PUT(DIRECTION_DIRHOLD, clocks(dirhold)));
    curvecore_write(frame, CURVECORE_PINS,
                    CURVECORE_PUT(PINS_STEP_INVERTED, step) |
                        CURVECORE_PUT(PINS_DIRECTION_INVERTED, direction) |
                        CURVECORE_PUT(PINS_LIMIT_MASKED, masked));
    curvecore_write(frame, CURVECORE_WATCHDOG,
                    silence < CURVECORE_MOST(WATCHDOG_SAMPLES) ? (uint32_t)silence
                                                               : CURVECORE_MOST(WATCHDOG_SAMPLES));
    curvecore_write(frame, CURVECORE_STATE, CURVECORE_FAULTS);
    curvecore_write(frame, CURVECORE_REFERENCE, CURVECORE_REFERENCE_AXES_MASK);
    curvecore_write(frame, CURVECORE_CONTROL,
                    CURVECORE_CONTROL_ENABLE_MASK | CURVECORE_CONTROL_POSITION_MASK);
    curvecore_send(&link_.wire, 0, 0, now);
    return 0;
}

static void turn_off(int64_t now) {
    struct curvecore_frame *frame = link_begin(&link_, now);
    if (!frame) return;
    curvecore_write(frame, CURVECORE_CONTROL, 0);
    curvecore_send(&link_.wire, 0, 0, now);
    tried = now;
}

/* Samples that were sent and are not known to be taken. */
static int under_way(void) { return curvecore_under_way(&link_.wire, 0); }

static void push(int64_t now) {
    int room = (int)FIELD(link_.status.samples, SAMPLES_ROOM) - under_way();
    struct curvecore_frame *frame;
    while (line.count > 0 && room > 0 && (frame = link_begin(&link_, now))) {
        int n, k, axis;
        if (was_late) curvecore_write(frame, CURVECORE_STATE, CURVECORE_STATE_LATE_MASK);
        n = (curvecore_room(&link_.wire, frame) - CURVECORE_COMMAND_BYTES) / (4 * joints);
        if (n > room) n = room;
        if (n > line.count) n = line.count;
        room -= n;
        curvecore_command(frame, CURVECORE_COMMAND_WRITE | CURVECORE_COMMAND_WORDS, n * joints,
                          CURVECORE_SAMPLE);
        for (k = 0; k < n; ++k) {
            const int32_t *sample = line_next(&line);
            for (axis = 0; axis < joints; ++axis) {
                curvecore_add_word(frame, (uint32_t)sample[axis]);
            }
        }
        curvecore_send(&link_.wire, n, 0, now);
    }
}

FUNCTION(write_) {
    const int64_t now = rtapi_get_time();
    double units[CURVECORE_MOST_AXES];
    double samples, wanted, most;
    int n, waiting;
    if (!connected) {
        curvecore_work(&link_.wire, now);
        return;
    }
    samples = period * 1e-9 / sample_seconds();
    wanted = buffer_time / sample_seconds();
    switch (mode) {
    case OFF:
        if (!enable) break;
        mode = COMING;
        began = now;
        tried = now - AGAIN;
        /* fall through */
    case COMING:
        if (!enable) {
            turn_off(now);
            mode = OFF;
        } else if (link_.wire.count > 0) {
        } else if (STATE_HAS(ENABLED) && STATE_HAS(READY) && tried >= began) {
            for (n = 0; n < joints; ++n) units[n] = steps[n] * LINE_UNITS;
            line_begin(&line, units, joints, (int)wanted);
            mode = ON;
        } else if (now - began > LONGEST) {
            mode = FAULT;
        } else if (!watchable(__comp_inst) || !fits(__comp_inst)) {
            mode = FAULT;
        } else if (now - tried >= AGAIN) {
            if (settings(__comp_inst, now) == 0) tried = now;
        }
        break;
    case ON:
        if (!enable) {
            turn_off(now);
            if (tried == now) mode = OFF;
            break;
        }
        waiting = line.count + under_way() + (int)FIELD(link_.status.samples, SAMPLES_QUEUED);
        latency = waiting * sample_seconds();
        hold = waiting > (hold ? 1 : LINE_HOLDS) * wanted;
        most = ldexp(1, (int)FIELD(BOARD.core, CORE_POSITION_BITS) - 1);
        for (n = 0; n < joints; ++n) {
            units[n] = joint_position_cmd(n) * joint_scale(n) * LINE_UNITS;
            if (!(fabs(units[n]) < most)) mode = FAULT;
        }
        if (mode == FAULT || line_go_on(&line, units, samples, waiting, wanted) != 0) mode = FAULT;
        else push(now);
        break;
    case FAULT:
        if (STATE_HAS(ENABLED) && now - tried >= AGAIN) turn_off(now);
        break;
    }
    link_.wire.live_period =
        mode == COMING || mode == ON ? (int64_t)(watchdog_time * 1e9 / CURVECORE_SIGNS_OF_LIFE) : 0;
    curvecore_work(&link_.wire, now);
}
