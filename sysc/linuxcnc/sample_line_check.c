/* SPDX-License-Identifier: GPL-2.0-or-later
 * sample_line.h beside a board whose clock drifts and a servo thread that jitters:
 *
 *     sample_line_check DRIFT_PPM
 *
 * A joint goes at one speed for 100 s. Prints the most by which a sample's distance is off the
 * speed, in percent, behind the first 10 s the lowest and the highest level, of what was wanted,
 * and how many samples came late in all. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "sample_line.h"

#define PERIODS 100000 /* of 1 ms */
#define SETTLED 10000
#define SAMPLES 10.0 /* a period */
#define WANTED 40.0
#define SPEED 1000.0 /* units a sample: in all within what a position can be */

int main(int count, char** values) {
    static struct sample_line line;
    const double drift = count > 1 ? atof(values[1]) * 1e-6 : 0;
    double place = 0, board = 0, low = 1e9, high = 0, worst = 0;
    long waiting, sent = 0, taken = 0, late = 0;
    unsigned chance = 1;
    int n;
    int32_t last = 0;
    line_begin(&line, &place, 1, (int)WANTED);
    for (n = 0; n < PERIODS; ++n) {
        /* The thread comes up to half a period late. */
        chance = chance * 1103515245u + 12345u;
        const double now = n + (chance >> 16 & 0x7fff) / 65536.0;
        for (; line.count > 0; ++sent) {
            const int32_t at = *line_next(&line);
            if (sent > WANTED + 1) worst = fmax(worst, fabs(at - last - SPEED) / SPEED);
            last = at;
        }
        for (; board < now * SAMPLES * (1 + drift); ++board) {
            if (taken < sent)
                ++taken;
            else
                ++late;
        }
        waiting = sent - taken;
        if (n > SETTLED) {
            low = fmin(low, waiting / WANTED);
            high = fmax(high, waiting / WANTED);
        }
        place += SPEED * SAMPLES;
        if (line_go_on(&line, &place, SAMPLES, (int)waiting, WANTED) != 0) return 1;
    }
    printf("%.2f %.2f %.2f %ld\n", 100 * worst, low, high, late);
    return 0;
}
