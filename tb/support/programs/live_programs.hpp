// SPDX-License-Identifier: Apache-2.0
// Moves of programs that are planned while they are drawn, as G-code.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>

namespace curvecore::tb {

/// Chords of 0.2 mm.
inline std::string surface() {
    std::string text;
    double x = 0;
    double way = 0.2;
    for (int n = 0; n < 2500; ++n) {
        x += way;
        const double y = 0.5 * (n / 250);
        if (n % 250 == 249) way = -way;
        text += fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f}\n", x, y, std::sin(x / 5) * std::cos(y));
    }
    return text;
}

/// Lines with some rapids between.
inline std::string corners() {
    std::mt19937 random(3);
    std::string text;
    for (int n = 0; n < 120; ++n) {
        text +=
            fmt::format("{} X{} Y{}\n", n % 20 == 7 ? "G0" : "G1", random() % 60, random() % 60);
    }
    return text;
}

inline std::string arcs() {
    std::string text;
    for (int n = 0; n < 12; ++n)
        text += fmt::format("G2 X{} Y0 I15 J0\nG3 X{} I10\n", 30 * n, 30 * n);
    return text;
}

}  // namespace curvecore::tb
