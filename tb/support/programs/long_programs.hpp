// SPDX-License-Identifier: Apache-2.0
// Programs of any length, as text.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace curvecore::tb {

/// A raster over a surface in short chords, or chords that stay what they are.
inline std::string raster(int chords, const char* mode) {
    std::string text = fmt::format("G21 G90 {} F3000\n", mode);
    double x = 0;
    double step = 0.2;
    for (int i = 0, row = 0; i < chords; ++i) {
        x += step;
        if (x > 40 || x < 0) {
            step = -step;
            x += step;
            ++row;
        }
        text += fmt::format("G1 X{:.4f} Y{:.4f} Z{:.4f}\n", x, 0.05 * row,
                            3 * std::sin(x / 5) * std::cos(0.05 * row / 7));
    }
    return text;
}

/// Long moves: lines to and fro with corners, or arcs that go on into each other with a jump of
/// the curvature at every joint.
inline std::string strokes(int moves, const char* mode) {
    std::string text = fmt::format("G21 G90 {} F6000\n", mode);
    for (int i = 1; i <= moves; ++i) {
        text += fmt::format("G1 X{} Y{}\n", i % 2 * 40 + i % 7, i % 11);
    }
    return text;
}

inline std::string waves(int arcs, const char* mode) {
    std::string text = fmt::format("G21 G90 {} F6000\n", mode);
    for (int i = 0; i < arcs; ++i) {
        const int step = i / 50 % 2 == 0 ? 10 : -10;
        text += fmt::format("G{} X{} Y0 I{} J0\n", i % 2 == 0 ? 3 : 2,
                            step > 0 ? i % 50 * 10 + 10 : 490 - i % 50 * 10, step / 2);
    }
    return text;
}

/// A print: layers of walls and of lines to and fro within them, with the extruder's axis, which is
/// drawn back before the ways between, and a fan that is set now and then.
inline std::string print(int lines) {
    std::string text = "; print\nM82\nG28\nG90\nG92 E0\n";
    int count = 5;
    double x = 100;
    double y = 100;
    double fed = 0;
    const auto add = [&](const std::string& line) {
        if (count++ < lines) text += line + "\n";
    };
    const auto travel = [&](double to_x, double to_y) {
        add(fmt::format("G1 F1500 E{:.5f}", fed - 4));
        add(fmt::format("G0 F6000 X{:.3f} Y{:.3f}", to_x, to_y));
        add(fmt::format("G1 F1500 E{:.5f}", fed));
        x = to_x;
        y = to_y;
    };
    const auto draw = [&](double to_x, double to_y, int feed) {
        fed += 0.033 * std::hypot(to_x - x, to_y - y);
        add(fmt::format("G1 F{} X{:.3f} Y{:.3f} E{:.5f}", feed, to_x, to_y, fed));
        x = to_x;
        y = to_y;
    };
    int layer = -1;
    while (count < lines) {
        ++layer;
        add(fmt::format(";LAYER:{}", layer));
        add(fmt::format("G0 F6000 Z{:.1f}", 0.2 + 0.2 * layer));
        if (layer % 10 == 0) add(fmt::format("M106 S{}", layer % 256));
        for (int wall = 0; wall < 3; ++wall) {
            const double radius = 20 - 0.4 * wall - 3 * std::sin(0.02 * layer);
            for (int i = 0; i <= 120; ++i) {
                const double angle = 2 * M_PI * i / 120;
                const double r = radius * (1 + 0.1 * std::sin(5 * angle));
                const double to_x = 100 + r * std::cos(angle);
                const double to_y = 100 + r * std::sin(angle);
                i == 0 ? travel(to_x, to_y) : draw(to_x, to_y, 2400);
            }
        }
        for (int i = 0; i < 40; ++i) {
            const double to_y = 85 + 0.75 * i;
            const double half = std::sqrt(289 - (to_y - 100) * (to_y - 100));
            const double side = i % 2 == 0 ? half : -half;
            i == 0 ? travel(100 + side, to_y) : draw(100 + side, to_y, 3000);
            draw(100 - side, to_y, 3000);
        }
    }
    return text;
}

}  // namespace curvecore::tb
