// SPDX-License-Identifier: Apache-2.0
// Clocks of the serial core, as the header of rtl/curve_interpolator_serial.sv states them.
#pragma once

#include <algorithm>

namespace curvecore::tb {

/// | field   | clocks, at most                                                                 |
/// |---------|---------------------------------------------------------------------------------|
/// | sample  | between samples of a step, on average                                           |
/// | step    | from a step's last sample to the first of the next step                         |
/// | segment | the same of the next segment, if its words come without a pause                 |
struct SerialClocks {
    int sample, step, segment;
};

constexpr SerialClocks serial_clocks(int order, int aux_axes, bool series, bool splines) {
    const int aux_frames = (aux_axes + 2) / 3;
    const int frames = (series ? order : splines ? order + 3 : 4 + order / 2) + aux_frames;
    const int sample = std::max({9 * (1 + aux_frames), 3 * (frames + 5), 24});
    if (!splines) {
        return {sample, 15 * order + 9 * frames + 84,
                27 * order + 9 * frames + 3 * aux_axes + 66 + (series ? 0 : 11 * order + 24)};
    }
    const int network =
        4 * order * order + 37 * order + (series ? 3 * order * (order + 11) / 2 : 0);
    return {sample, network + 2 * order + 9 * frames + 120,
            network + 9 * frames + 3 * aux_axes + 162};
}

}  // namespace curvecore::tb
