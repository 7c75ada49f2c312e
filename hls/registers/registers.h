/* SPDX-License-Identifier: Apache-2.0 OR GPL-2.0-or-later
 * Made by hls/registers/make_registers.py from registers.rdl, which explains the registers.
 * Addresses in bytes; of each field its lowest bit and its mask in place. */
#ifndef CURVECORE_REGISTERS_H
#define CURVECORE_REGISTERS_H

#include <stdint.h>

/* A field of a register's word, by the register's and the field's name; its bits in place, which
 * are added up; the most that it holds. */
#define CURVECORE_FIELD(word, name) \
    (((uint32_t)(word)&CURVECORE_##name##_MASK) >> CURVECORE_##name##_LOW)
#define CURVECORE_PUT(name, value) ((uint32_t)(value) << CURVECORE_##name##_LOW)
#define CURVECORE_MOST(name) (CURVECORE_##name##_MASK >> CURVECORE_##name##_LOW)

#define CURVECORE_MOST_AXES 9
#define CURVECORE_AXIS_STRIDE 0x10

/* Identity of the block. */
#define CURVECORE_ID 0x000
#define CURVECORE_ID_ID_LOW 0
#define CURVECORE_ID_ID_MASK 0xffffffffu
#define CURVECORE_ID_ID_VALUE 0x43564d31u

/* Versions. */
#define CURVECORE_VERSION 0x004
#define CURVECORE_VERSION_MAP_LOW 0
#define CURVECORE_VERSION_MAP_MASK 0x000000ffu
#define CURVECORE_VERSION_MAP_VALUE 0x2u
#define CURVECORE_VERSION_WORDS_LOW 8
#define CURVECORE_VERSION_WORDS_MASK 0x0000ff00u

/* Build of the block. */
#define CURVECORE_CAPABILITY 0x008
#define CURVECORE_CAPABILITY_AXES_LOW 0
#define CURVECORE_CAPABILITY_AXES_MASK 0x0000000fu
#define CURVECORE_CAPABILITY_PERIOD_LOG2_LOW 4
#define CURVECORE_CAPABILITY_PERIOD_LOG2_MASK 0x000001f0u
#define CURVECORE_CAPABILITY_BUILD_LOW 9
#define CURVECORE_CAPABILITY_BUILD_MASK 0x00000200u
#define CURVECORE_CAPABILITY_SPLINES_LOW 10
#define CURVECORE_CAPABILITY_SPLINES_MASK 0x00000400u
#define CURVECORE_CAPABILITY_SEGMENT_QUEUE_LOG2_LOW 11
#define CURVECORE_CAPABILITY_SEGMENT_QUEUE_LOG2_MASK 0x0000f800u
#define CURVECORE_CAPABILITY_PROFILE_QUEUE_LOG2_LOW 16
#define CURVECORE_CAPABILITY_PROFILE_QUEUE_LOG2_MASK 0x001f0000u
#define CURVECORE_CAPABILITY_SAMPLE_BUFFER_LOG2_LOW 21
#define CURVECORE_CAPABILITY_SAMPLE_BUFFER_LOG2_MASK 0x01e00000u
#define CURVECORE_CAPABILITY_ENCODERS_LOW 25
#define CURVECORE_CAPABILITY_ENCODERS_MASK 0x02000000u
#define CURVECORE_CAPABILITY_ENGINE_LOW 26
#define CURVECORE_CAPABILITY_ENGINE_MASK 0x04000000u
#define CURVECORE_CAPABILITY_OUTPUTS_LOG2_LOW 27
#define CURVECORE_CAPABILITY_OUTPUTS_LOG2_MASK 0x78000000u

/* Widths that words are planned for: hls/configuration.hpp. */
#define CURVECORE_CORE 0x00c
#define CURVECORE_CORE_ORDER_LOW 0
#define CURVECORE_CORE_ORDER_MASK 0x0000000fu
#define CURVECORE_CORE_MODE_LOW 4
#define CURVECORE_CORE_MODE_MASK 0x00000010u
#define CURVECORE_CORE_COEF_BITS_LOW 6
#define CURVECORE_CORE_COEF_BITS_MASK 0x00000fc0u
#define CURVECORE_CORE_POSITION_BITS_LOW 12
#define CURVECORE_CORE_POSITION_BITS_MASK 0x0003f000u
#define CURVECORE_CORE_GUARD_BITS_LOW 18
#define CURVECORE_CORE_GUARD_BITS_MASK 0x003c0000u
#define CURVECORE_CORE_TABLE_LOW 22
#define CURVECORE_CORE_TABLE_MASK 0xffc00000u

/* The clock, for times and the sample period. */
#define CURVECORE_CLOCK 0x010
#define CURVECORE_CLOCK_HERTZ_LOW 0
#define CURVECORE_CLOCK_HERTZ_MASK 0xffffffffu

/* Commands of the machine; each write states all of them. */
#define CURVECORE_CONTROL 0x014
#define CURVECORE_CONTROL_ENABLE_LOW 0
#define CURVECORE_CONTROL_ENABLE_MASK 0x00000001u
#define CURVECORE_CONTROL_HOLD_LOW 1
#define CURVECORE_CONTROL_HOLD_MASK 0x00000002u
#define CURVECORE_CONTROL_FLUSH_LOW 2
#define CURVECORE_CONTROL_FLUSH_MASK 0x00000004u
#define CURVECORE_CONTROL_ESTOP_LOW 3
#define CURVECORE_CONTROL_ESTOP_MASK 0x00000008u
#define CURVECORE_CONTROL_POSITION_LOW 4
#define CURVECORE_CONTROL_POSITION_MASK 0x00000010u
#define CURVECORE_CONTROL_KEEP_LOW 5
#define CURVECORE_CONTROL_KEEP_MASK 0x00000020u

/* Faults, each kept until a one is written to it, and the present state. */
#define CURVECORE_STATE 0x018
#define CURVECORE_STATE_BUS_LOW 0
#define CURVECORE_STATE_BUS_MASK 0x00000001u
#define CURVECORE_STATE_WATCHDOG_LOW 1
#define CURVECORE_STATE_WATCHDOG_MASK 0x00000002u
#define CURVECORE_STATE_ESTOP_LOW 2
#define CURVECORE_STATE_ESTOP_MASK 0x00000004u
#define CURVECORE_STATE_ESTOP_INPUT_LOW 3
#define CURVECORE_STATE_ESTOP_INPUT_MASK 0x00000008u
#define CURVECORE_STATE_LIMIT_LOW 4
#define CURVECORE_STATE_LIMIT_MASK 0x00000010u
#define CURVECORE_STATE_OVERRUN_LOW 5
#define CURVECORE_STATE_OVERRUN_MASK 0x00000020u
#define CURVECORE_STATE_REFUSED_LOW 6
#define CURVECORE_STATE_REFUSED_MASK 0x00000040u
#define CURVECORE_STATE_LATE_LOW 7
#define CURVECORE_STATE_LATE_MASK 0x00000080u
#define CURVECORE_STATE_MOTION_LOW 8
#define CURVECORE_STATE_MOTION_MASK 0x0000ff00u
#define CURVECORE_STATE_MOTION_SEGMENT_WORD 0x1u
#define CURVECORE_STATE_MOTION_SEGMENT_ORDER 0x2u
#define CURVECORE_STATE_MOTION_PIECE_WORD 0x4u
#define CURVECORE_STATE_MOTION_PIECE_ORDER 0x8u
#define CURVECORE_STATE_MOTION_APART 0x10u
#define CURVECORE_STATE_MOTION_SHORT_QUEUE 0x20u
#define CURVECORE_STATE_MOTION_SETTINGS 0x40u
#define CURVECORE_STATE_MOTION_NO_SAMPLE 0x80u
#define CURVECORE_STATE_ENABLED_LOW 16
#define CURVECORE_STATE_ENABLED_MASK 0x00010000u
#define CURVECORE_STATE_HOLDING_LOW 17
#define CURVECORE_STATE_HOLDING_MASK 0x00020000u
#define CURVECORE_STATE_ACTIVE_LOW 18
#define CURVECORE_STATE_ACTIVE_MASK 0x00040000u
#define CURVECORE_STATE_STANDING_LOW 19
#define CURVECORE_STATE_STANDING_MASK 0x00080000u
#define CURVECORE_STATE_UNDERRUN_LOW 20
#define CURVECORE_STATE_UNDERRUN_MASK 0x00100000u
#define CURVECORE_STATE_FLUSHING_LOW 21
#define CURVECORE_STATE_FLUSHING_MASK 0x00200000u
#define CURVECORE_STATE_CLEAN_LOW 22
#define CURVECORE_STATE_CLEAN_MASK 0x00400000u
#define CURVECORE_STATE_READY_LOW 23
#define CURVECORE_STATE_READY_MASK 0x00800000u
#define CURVECORE_STATE_ESTOP_PIN_LOW 24
#define CURVECORE_STATE_ESTOP_PIN_MASK 0x01000000u
#define CURVECORE_STATE_ENCODER_LOW 25
#define CURVECORE_STATE_ENCODER_MASK 0x02000000u
#define CURVECORE_STATE_FOLLOWING_LOW 26
#define CURVECORE_STATE_FOLLOWING_MASK 0x04000000u
#define CURVECORE_STATE_FAULT_AXIS_LOW 27
#define CURVECORE_STATE_FAULT_AXIS_MASK 0x78000000u
#define CURVECORE_STATE_CAUGHT_LOW 31
#define CURVECORE_STATE_CAUGHT_MASK 0x80000000u

/* Axes, bit n of each field is axis n. */
#define CURVECORE_AXES 0x01c
#define CURVECORE_AXES_REFERENCED_LOW 0
#define CURVECORE_AXES_REFERENCED_MASK 0x000001ffu
#define CURVECORE_AXES_UNCERTAIN_LOW 9
#define CURVECORE_AXES_UNCERTAIN_MASK 0x0003fe00u
#define CURVECORE_AXES_LIMIT_LOW 18
#define CURVECORE_AXES_LIMIT_MASK 0x07fc0000u

/* Axes that the first sample of the next program, or of the host, references. Refused unless STATE.clean. */
#define CURVECORE_REFERENCE 0x020
#define CURVECORE_REFERENCE_AXES_LOW 0
#define CURVECORE_REFERENCE_AXES_MASK 0x000001ffu

/* Rate of time. While nothing is under way it applies at once: a program begins at it. This and the settings below: rtl/motion_interpolator.sv. */
#define CURVECORE_OVERRIDE 0x024
#define CURVECORE_OVERRIDE_RATE_LOW 0
#define CURVECORE_OVERRIDE_RATE_MASK 0x0001ffffu

/* Longest silence of the host while a program is under way, or in position mode. Only an obeyed write ends it: one without an error, and in frames one behind the number that SEQUENCE has. Reads never do; a host that has nothing to write writes SEQUENCE. */
#define CURVECORE_WATCHDOG 0x028
#define CURVECORE_WATCHDOG_SAMPLES_LOW 0
#define CURVECORE_WATCHDOG_SAMPLES_MASK 0x0000ffffu

/* Ticks of the profile. */
#define CURVECORE_TIMING 0x02c
#define CURVECORE_TIMING_SAMPLES_PER_TICK_LOG2_LOW 0
#define CURVECORE_TIMING_SAMPLES_PER_TICK_LOG2_MASK 0x0000000fu

/* Second difference of time, 2^-32, for holds without a stop branch and overrides. */
#define CURVECORE_HOLD_ACCELERATION 0x030
#define CURVECORE_HOLD_ACCELERATION_ACCELERATION_LOW 0
#define CURVECORE_HOLD_ACCELERATION_ACCELERATION_MASK 0xffffffffu

/* First difference of time, 2^-32. */
#define CURVECORE_HOLD_SLOPE 0x034
#define CURVECORE_HOLD_SLOPE_SLOPE_LOW 0
#define CURVECORE_HOLD_SLOPE_SLOPE_MASK 0xffffffffu

/* Ticks of the profile that a stop needs. */
#define CURVECORE_STOP_TICKS 0x038
#define CURVECORE_STOP_TICKS_TICKS_LOW 0
#define CURVECORE_STOP_TICKS_TICKS_MASK 0x1fffffffu

/* Times of the drives, in clocks, 0 counts as 1: rtl/pulse/step_generator.sv. */
#define CURVECORE_PULSE 0x03c
#define CURVECORE_PULSE_STEPLEN_LOW 0
#define CURVECORE_PULSE_STEPLEN_MASK 0x0000ffffu
#define CURVECORE_PULSE_STEPSPACE_LOW 16
#define CURVECORE_PULSE_STEPSPACE_MASK 0xffff0000u

/* Times of the drives, in clocks, 0 counts as 1. */
#define CURVECORE_DIRECTION 0x040
#define CURVECORE_DIRECTION_DIRSETUP_LOW 0
#define CURVECORE_DIRECTION_DIRSETUP_MASK 0x0000ffffu
#define CURVECORE_DIRECTION_DIRHOLD_LOW 16
#define CURVECORE_DIRECTION_DIRHOLD_MASK 0xffff0000u

/* Pins, bit n of each field is axis n. A write that changes a polarity is refused while STATE.enabled. */
#define CURVECORE_PINS 0x044
#define CURVECORE_PINS_STEP_INVERTED_LOW 0
#define CURVECORE_PINS_STEP_INVERTED_MASK 0x000001ffu
#define CURVECORE_PINS_DIRECTION_INVERTED_LOW 9
#define CURVECORE_PINS_DIRECTION_INVERTED_MASK 0x0003fe00u
#define CURVECORE_PINS_LIMIT_MASKED_LOW 18
#define CURVECORE_PINS_LIMIT_MASKED_MASK 0x07fc0000u

/* Widths of settings, which limit what a host may write: hls/registers/board_facts.h. */
#define CURVECORE_WIDTHS 0x048
#define CURVECORE_WIDTHS_TIME_BITS_LOW 0
#define CURVECORE_WIDTHS_TIME_BITS_MASK 0x0000001fu
#define CURVECORE_WIDTHS_SCALE_BITS_LOW 5
#define CURVECORE_WIDTHS_SCALE_BITS_MASK 0x000007e0u
#define CURVECORE_WIDTHS_SAMPLES_AHEAD_LOW 11
#define CURVECORE_WIDTHS_SAMPLES_AHEAD_MASK 0x00007800u
#define CURVECORE_WIDTHS_SHAPER_LOG2_LOW 15
#define CURVECORE_WIDTHS_SHAPER_LOG2_MASK 0x00078000u

/* Configuration that the words of the next program must be made for, besides that of the board (CORE, CLOCK, and axes, period, build, engine and splines of CAPABILITY): unit, samples per tick and machine. Words made for another configuration raise the faults motion 0 and 2, and none of them is drawn. */
#define CURVECORE_DIGEST 0x04c
#define CURVECORE_DIGEST_DIGEST_LOW 0
#define CURVECORE_DIGEST_DIGEST_MASK 0x0000ffffu

/* Low 32 bits of the next word; both addresses write the same. */
#define CURVECORE_SEGMENT_LO 0x050
#define CURVECORE_SEGMENT_LO_WORD_LOW 0
#define CURVECORE_SEGMENT_LO_WORD_MASK 0xffffffffu

/* High 16 bits of a segment's word: pushes it. */
#define CURVECORE_SEGMENT_HI 0x054
#define CURVECORE_SEGMENT_HI_WORD_LOW 0
#define CURVECORE_SEGMENT_HI_WORD_MASK 0x0000ffffu

/* Low 32 bits of the next word; both addresses write the same. */
#define CURVECORE_PROFILE_LO 0x058
#define CURVECORE_PROFILE_LO_WORD_LOW 0
#define CURVECORE_PROFILE_LO_WORD_MASK 0xffffffffu

/* High 16 bits of a piece's word: pushes it. */
#define CURVECORE_PROFILE_HI 0x05c
#define CURVECORE_PROFILE_HI_WORD_LOW 0
#define CURVECORE_PROFILE_HI_WORD_MASK 0x0000ffffu

/* Path of all programs since the last flush, 2^-16 length unit. Reading it keeps PATH_HI and RATE for their next reading. */
#define CURVECORE_PATH_LO 0x060
#define CURVECORE_PATH_LO_PATH_LOW 0
#define CURVECORE_PATH_LO_PATH_MASK 0xffffffffu

/* Path at the last reading of PATH_LO. */
#define CURVECORE_PATH_HI 0x064
#define CURVECORE_PATH_HI_PATH_LOW 0
#define CURVECORE_PATH_HI_PATH_MASK 0xffffffffu

/* Rate of time in the last requested sample, at the last reading of PATH_LO. */
#define CURVECORE_RATE 0x068
#define CURVECORE_RATE_RATE_LOW 0
#define CURVECORE_RATE_RATE_MASK 0x0001ffffu

/* Words that still fit into the queues, or with CAPABILITY.engine into their entry, which has 128 words; of the profile as many as changes of outputs fit, too. A program's words do not enter before the other stream has ended the program before. */
#define CURVECORE_ROOM 0x06c
#define CURVECORE_ROOM_SEGMENT_LOW 0
#define CURVECORE_ROOM_SEGMENT_MASK 0x0000ffffu
#define CURVECORE_ROOM_PROFILE_LOW 16
#define CURVECORE_ROOM_PROFILE_MASK 0xffff0000u

/* Expected number of SEQUENCE: writes behind this one, in its frame, are obeyed if it is equal. Buses without frames only keep it. */
#define CURVECORE_EXPECT 0x070
#define CURVECORE_EXPECT_FRAME_LOW 0
#define CURVECORE_EXPECT_FRAME_MASK 0xffffffffu

/* Number of the last frame whose writes were obeyed, as that frame wrote it here. Buses without frames only keep it. */
#define CURVECORE_SEQUENCE 0x074
#define CURVECORE_SEQUENCE_FRAME_LOW 0
#define CURVECORE_SEQUENCE_FRAME_MASK 0xffffffffu

/* Position of the next axis in position mode, axis 0 first; the last one completes the sample. One sample is taken in each period. Without room at the first position, all positions of the sample are refused. */
#define CURVECORE_SAMPLE 0x078
#define CURVECORE_SAMPLE_POSITION_LOW 0
#define CURVECORE_SAMPLE_POSITION_MASK 0xffffffffu

/* Samples of position mode. */
#define CURVECORE_SAMPLES 0x07c
#define CURVECORE_SAMPLES_ROOM_LOW 0
#define CURVECORE_SAMPLES_ROOM_MASK 0x0000ffffu
#define CURVECORE_SAMPLES_QUEUED_LOW 16
#define CURVECORE_SAMPLES_QUEUED_MASK 0xffff0000u

/* Switch that the motion waits for. When it has the requested level, on one rising edge of the clock behind the synchroniser, path and steps are noted and the motion holds, on the path. */
#define CURVECORE_PROBE 0x080
#define CURVECORE_PROBE_SWITCH_LOW 0
#define CURVECORE_PROBE_SWITCH_MASK 0x0000000fu
#define CURVECORE_PROBE_HIGH_LOW 4
#define CURVECORE_PROBE_HIGH_MASK 0x00000010u
#define CURVECORE_PROBE_ARMED_LOW 5
#define CURVECORE_PROBE_ARMED_MASK 0x00000020u

/* Levels of switches, some clocks old. */
#define CURVECORE_SWITCHES 0x084
#define CURVECORE_SWITCHES_HOME_LOW 0
#define CURVECORE_SWITCHES_HOME_MASK 0x000001ffu
#define CURVECORE_SWITCHES_PROBE_LOW 9
#define CURVECORE_SWITCHES_PROBE_MASK 0x00000200u
#define CURVECORE_SWITCHES_HOMED_LOW 10
#define CURVECORE_SWITCHES_HOMED_MASK 0x0007fc00u

/* Path when PROBE caught, in the last requested sample. */
#define CURVECORE_CAUGHT_PATH 0x088
#define CURVECORE_CAUGHT_PATH_PATH_LOW 0
#define CURVECORE_CAUGHT_PATH_PATH_MASK 0xffffffffu

/* Axes whose ORIGIN is valid. A cut pulse of an axis clears its bit. */
#define CURVECORE_HOMED 0x08c
#define CURVECORE_HOMED_AXES_LOW 0
#define CURVECORE_HOMED_AXES_MASK 0x000001ffu

/* STEPS of axis n at its machine coordinate 0. For hosts: the board only keeps it. */
#define CURVECORE_ORIGIN0 0x090
#define CURVECORE_ORIGIN0_STEPS_LOW 0
#define CURVECORE_ORIGIN0_STEPS_MASK 0xffffffffu

/* Edges of the encoder of axis n since the reset, signed. Its use: rtl/bus/following_error.sv. */
#define CURVECORE_ENCODER0 0x0b4
#define CURVECORE_ENCODER0_COUNT_LOW 0
#define CURVECORE_ENCODER0_COUNT_MASK 0xffffffffu

/* FOLLOWING of axis n at its largest distance from 0 since the last reference. */
#define CURVECORE_FOLLOWING_WORST0 0x0d8
#define CURVECORE_FOLLOWING_WORST0_ERROR_LOW 0
#define CURVECORE_FOLLOWING_WORST0_ERROR_MASK 0xffffffffu

/* Outputs, which changes in the stream of the profile switch along the path (hls/path_outputs.hpp). Without STATE.enabled all are off. */
#define CURVECORE_OUTPUTS 0x0fc
#define CURVECORE_OUTPUTS_POWER_LOW 8
#define CURVECORE_OUTPUTS_POWER_MASK 0x000fff00u
#define CURVECORE_OUTPUTS_BITS_LOW 24
#define CURVECORE_OUTPUTS_BITS_MASK 0xff000000u

/* Low 32 bits of the scale, to be written before the others. Of axis 0. */
#define CURVECORE_AXIS_SCALE_LO 0x100
#define CURVECORE_AXIS_SCALE_LO_SCALE_LOW 0
#define CURVECORE_AXIS_SCALE_LO_SCALE_MASK 0xffffffffu

/* High bits of the scale, 2^-16 steps in the whole range of positions. Takes both. Refused while STATE.enabled. Of axis 0. */
#define CURVECORE_AXIS_SCALE_HI 0x104
#define CURVECORE_AXIS_SCALE_HI_SCALE_LOW 0
#define CURVECORE_AXIS_SCALE_HI_SCALE_MASK 0x00ffffffu

/* Steps given since the reset, signed. Of axis 0. */
#define CURVECORE_AXIS_STEPS 0x108
#define CURVECORE_AXIS_STEPS_COUNT_LOW 0
#define CURVECORE_AXIS_STEPS_COUNT_MASK 0xffffffffu

/* STEPS when PROBE caught; those of axis n are 3 + n to 5 + 3 n clocks behind the pin. Of axis 0. */
#define CURVECORE_AXIS_CAUGHT 0x10c
#define CURVECORE_AXIS_CAUGHT_COUNT_LOW 0
#define CURVECORE_AXIS_CAUGHT_COUNT_MASK 0xffffffffu

/* Following error of axis n, signed: steps x ENCODER_RATIO.counts - edges x ENCODER_RATIO.steps, both since the axis was referenced; it stays when it is no more. The unit is 1 / ENCODER_RATIO.counts of a step. */
#define CURVECORE_FOLLOWING0 0x190
#define CURVECORE_FOLLOWING0_ERROR_LOW 0
#define CURVECORE_FOLLOWING0_ERROR_MASK 0xffffffffu

/* Ratio of axis n's encoder: a number of its edges equals a number of steps. */
#define CURVECORE_ENCODER_RATIO0 0x1b4
#define CURVECORE_ENCODER_RATIO0_COUNTS_LOW 0
#define CURVECORE_ENCODER_RATIO0_COUNTS_MASK 0x0000ffffu
#define CURVECORE_ENCODER_RATIO0_STEPS_LOW 16
#define CURVECORE_ENCODER_RATIO0_STEPS_MASK 0xffff0000u

/* Largest magnitude of FOLLOWING; beyond it is the fault of that name. 0: no limit. */
#define CURVECORE_FOLLOWING_LIMIT0 0x1d8
#define CURVECORE_FOLLOWING_LIMIT0_LIMIT_LOW 0
#define CURVECORE_FOLLOWING_LIMIT0_LIMIT_MASK 0xffffffffu

/* A word of the shaper of an axis: rtl/pulse/input_shaper.sv. Refused while STATE.enabled. Who writes one writes all, three of each axis and the outputs' delay, or 0: they count until the drives are off again; without any, steps follow samples. */
#define CURVECORE_SHAPER 0x1fc
#define CURVECORE_SHAPER_VALUE_LOW 0
#define CURVECORE_SHAPER_VALUE_MASK 0x0003ffffu
#define CURVECORE_SHAPER_AXIS_LOW 18
#define CURVECORE_SHAPER_AXIS_MASK 0x003c0000u
#define CURVECORE_SHAPER_KIND_LOW 22
#define CURVECORE_SHAPER_KIND_MASK 0x00c00000u

/* All faults in a word of STATE. */
#define CURVECORE_FAULTS 0x0600ffffu

/* Returns the text of one of them. */
static inline const char* curvecore_fault_text(uint32_t fault) {
    switch (fault) {
    case 0x00000001u:
        return "a word or an access that cannot be";
    case 0x00000002u:
        return "watchdog: the host was silent";
    case 0x00000004u:
        return "e-stop";
    case 0x00000008u:
        return "the e-stop input";
    case 0x00000010u:
        return "a limit switch";
    case 0x00000020u:
        return "a dropped step: the drive's times are too long";
    case 0x00000040u:
        return "an axis faster than half a step a clock, or a program that begins elsewhere";
    case 0x00000080u:
        return "a sample too late";
    case 0x00000100u:
        return "a segment word that cannot be, is not as it was made or for another configuration";
    case 0x00000200u:
        return "a segment missing, doubled or not from the last end";
    case 0x00000400u:
        return "a profile word that cannot be, is not as it was made or for another configuration";
    case 0x00000800u:
        return "a piece missing or doubled";
    case 0x00001000u:
        return "segments and pieces end apart";
    case 0x00002000u:
        return "a full queue does not cover a stop";
    case 0x00004000u:
        return "settings that cannot be, or that changed in motion";
    case 0x00008000u:
        return "no sample for too long, or foreign or changed microcode";
    case 0x02000000u:
        return "an encoder that skips, or goes too fast to be followed";
    case 0x04000000u:
        return "following error";
    default:
        return "";
    }
}

#endif
