// SPDX-License-Identifier: Apache-2.0
// Gains with which an axis that swings is led so that what swings behind its drive is on the path,
// or rests soon (hls/input_shaper.hpp).
//
// Of the places p(n) of samples, k of them apart in the time tau, q = p(n-k) + near (p(n) - p(n-k))
// + far (p(n-k) - p(n-2k)) is given to the drive. With the mode's w = 2 pi hertz and its damping
// ratio z:
//
//   | kind         | near               | far                | tau                   |
//   |--------------|--------------------|--------------------|-----------------------|
//   | feed-forward | b + a              | a - b              | a few samples         |
//   | ZV           | 1 / (1 + e)        | 0                  | half a period         |
//   | EI           | A (1 + V) / 4      | -A e^2 (1 + V) / 4 | half a period         |
//
// Feed-forward is the mode's own equation, p + 2 z / w p' + p'' / w^2, of the place tau before, by
// differences over +- tau: a = z / (w tau), b = 1 / (w tau)^2. An extruder that leads by the time K
// (pressure advance, p + K p') has K / (2 tau) more in a. ZV and EI (Singer and Seering;
// Singhose) are sums of two and three impulses, where e = exp(-z pi / sqrt(1 - z^2)) and V = 5 % of
// the vibration is left at the mode; A makes their sum 1.
#pragma once

#include <array>

#include "ref/machine/machine.hpp"

namespace curvecore::ref {

struct ShaperTaps {
    int delay = 0;  // samples, k
    double near = 0;
    double far = 0;
};

/// Returns the taps of each axis. Axes without a mode are late by as much with feed-forward, and
/// not shaped otherwise. No taps without a shaper.
/// @throws InputError: a mode needs a delay of no or more than `most` samples
std::array<ShaperTaps, kMachineAxes> shaper_taps(const Machine& machine, double sample_s, int most);

/// Returns the samples by which the tool is later than the path at constant speed, of the latest
/// axis with a mode: the mean of the taps' times, and the mode's own 2 z / w, which is all without
/// taps.
int tool_delay(const Machine& machine, const std::array<ShaperTaps, kMachineAxes>& taps,
               double sample_s);

}  // namespace curvecore::ref
