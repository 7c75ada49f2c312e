/* SPDX-License-Identifier: GPL-2.0-or-later
 * Positions of servo periods into samples of a board that has a clock of its own.
 *
 * Between two servo periods a joint goes in a straight line. Samples stand on it at even distances,
 * about the board's period over that of the servo: a little more where too many samples wait, a
 * little less where too few do. So both clocks go on together, and no sample is left out. */
#ifndef CURVECORE_SAMPLE_LINE_H
#define CURVECORE_SAMPLE_LINE_H

#include <stdint.h>

#include "../../hls/registers/registers.h"

#define LINE_SAMPLES 4096 /* most samples that wait here */
/* Gain of the distances: 1 % more or less for a buffer twice as full as wanted, or empty; at most
 * 2 %. A drift of 200 ppm moves the level by 2 %. */
#define LINE_GAIN 0.01
#define LINE_MOST 0.02
/* Multiple of the wanted level at which motion holds until the samples are drawn. While joints
 * stand, no samples are made beyond the wanted level. So motion waits, on the path, for a late link
 * or board. */
#define LINE_HOLDS 2
/* Periods over which the level is averaged: it varies by a servo period's samples. */
#define LINE_PERIODS 64
#define LINE_UNIT_BITS 8 /* of a position, in a step */
#define LINE_UNITS (1 << LINE_UNIT_BITS)

struct sample_line {
    int axes;
    double at[CURVECORE_MOST_AXES]; /* end of the last period, in units */
    double phase;                   /* of the next sample, in the coming period */
    double level;                   /* average of samples that wait, here and there */
    int32_t samples[LINE_SAMPLES][CURVECORE_MOST_AXES];
    int first, count;
};

static void line_put(struct sample_line* line, const double* units) {
    int32_t* sample = line->samples[(line->first + line->count++) % LINE_SAMPLES];
    int axis;
    for (axis = 0; axis < line->axes; ++axis) {
        sample[axis] = (int32_t)(units[axis] < 0 ? units[axis] - 0.5 : units[axis] + 0.5);
    }
}

/* It stands here, so many samples. */
static void line_begin(struct sample_line* line, const double* units, int axes, int samples) {
    int axis;
    line->axes = axes;
    line->first = line->count = 0;
    line->phase = 0;
    line->level = samples;
    for (axis = 0; axis < axes; ++axis) line->at[axis] = units[axis];
    while (samples-- > 0) line_put(line, units);
}

/* A servo period of so many samples on to the next place, while `waiting` of `wanted` wait.
 * 0: all found room. */
static int line_go_on(struct sample_line* line, const double* units, double samples, int waiting,
                      double wanted) {
    double change, distance, between[CURVECORE_MOST_AXES];
    int axis, stands = 1;
    for (axis = 0; axis < line->axes; ++axis) stands &= units[axis] == line->at[axis];
    if (stands && waiting > wanted) return 0;
    line->level += (waiting - line->level) / LINE_PERIODS;
    change = LINE_GAIN * (line->level - wanted) / wanted;
    if (change > LINE_MOST) change = LINE_MOST;
    if (change < -LINE_MOST) change = -LINE_MOST;
    distance = (1 + change) / samples;
    for (; line->phase < 1; line->phase += distance) {
        if (line->count == LINE_SAMPLES) return -1;
        for (axis = 0; axis < line->axes; ++axis) {
            between[axis] = line->at[axis] + (units[axis] - line->at[axis]) * line->phase;
        }
        line_put(line, between);
    }
    line->phase -= 1;
    for (axis = 0; axis < line->axes; ++axis) line->at[axis] = units[axis];
    return 0;
}

static const int32_t* line_next(struct sample_line* line) {
    const int32_t* sample = line->samples[line->first];
    line->first = (line->first + 1) % LINE_SAMPLES;
    --line->count;
    return sample;
}

#endif
