// SPDX-License-Identifier: Apache-2.0
// Curves, and the same curves as chains of chords.
#pragma once

#include "ref/curve/arc_length.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb {

/// A curve by its chord in mm, 0: the curve itself, and its feed in mm/s.
using ChoppedCurve = ref::Program (*)(double chord, double feed);

/// A turn back of 5 mm width between two lines of 40 mm.
inline ref::Program chopped_turn(double chord, double feed) {
    ProgramBuilder builder;
    builder.line({40, 0, 0}, feed);
    const ref::Vec3 at = builder.at();
    const ref::Cubic cubic = ref::from_bezier(
        {at, at + ref::Vec3(2.3, 0, 0), at + ref::Vec3(2.3, 5, 0), at + ref::Vec3(0, 5, 0)});
    if (chord == 0) {
        builder.cubic(at + ref::Vec3(2.3, 0, 0), at + ref::Vec3(2.3, 5, 0), at + ref::Vec3(0, 5, 0),
                      feed);
    } else {
        const ref::ArcLength arc(cubic);
        const auto count = static_cast<int>(std::lround(arc.length() / chord));
        for (int i = 1; i <= count; ++i) {
            builder.line(cubic.position(arc.parameter(arc.length() * i / count)), feed);
        }
    }
    builder.line({0, 5, 0}, feed);
    return builder.program();
}

/// The wave y = 3 sin x over one period.
inline ref::Program chopped_wave(double chord, double feed) {
    const double end = 2 * M_PI;
    ProgramBuilder builder;
    const auto point = [](double x) { return ref::Vec3(x, 3 * std::sin(x), 0); };
    const auto slope = [](double x) { return ref::Vec3(1, 3 * std::cos(x), 0); };
    constexpr int kCubics = 28;
    for (int i = 0; chord == 0 && i < kCubics; ++i) {
        const double from = end * i / kCubics;
        const double to = end * (i + 1) / kCubics;
        builder.cubic(point(from) + slope(from) * (to - from) / 3,
                      point(to) - slope(to) * (to - from) / 3, point(to), feed);
    }
    for (double x = 0; chord > 0 && x < end - 1e-6;) {
        const double half = x + chord / slope(x).norm() / 2;
        x = std::min(end, x + chord / slope(half).norm());
        builder.line(point(x), feed);
    }
    return builder.program();
}

inline ref::Program chopped_circle(double chord, double feed) {
    constexpr double kRadius = 10;
    ProgramBuilder builder;
    if (chord == 0) builder.arc({-kRadius, 0, 0}, {0, 0, 1}, 2 * M_PI, 0, feed);
    const auto count = chord == 0 ? 0 : static_cast<int>(std::lround(2 * M_PI * kRadius / chord));
    for (int i = 1; i <= count; ++i) {
        const double angle = 2 * M_PI * i / count;
        builder.line({kRadius * (std::cos(angle) - 1), kRadius * std::sin(angle), 0}, feed);
    }
    return builder.program();
}

}  // namespace curvecore::tb
