// SPDX-License-Identifier: Apache-2.0
// Programs of moves so short that a core's clocks bound the speed.
#pragma once

#include <random>

#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb {

/// Lines and arcs of 0.1 to 20 um, almost straight on, with an occasional longer one.
inline ref::Program tiny_moves(unsigned seed, int count) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    ProgramBuilder builder;
    ref::Vec3 tangent = ref::Vec3::UnitX();
    for (int n = 0; n < count; ++n) {
        const double length = random() % 20 == 0 ? uniform(0.1, 2) : uniform(1e-4, 2e-2);
        if (random() % 3 == 0) {
            builder.tangent_arc(tangent, ref::Vec3::UnitZ(), 50 * length, 0.02, 500);
        } else {
            builder.line(builder.at() + length * tangent, 500);
        }
        tangent = end_tangent(builder.program().moves.back());
    }
    return builder.program();
}

/// Lines of 50 nm: only the core bounds the speed.
inline ref::Program even_lines(int count) {
    ProgramBuilder builder;
    for (int n = 1; n <= count; ++n) builder.line({5e-5 * n, 0, 0}, 500);
    return builder.program();
}

inline ref::Program tiny_splines(unsigned seed, int count) {
    std::mt19937 random(seed);
    ProgramBuilder builder;
    for (int n = 0; n < count; ++n) {
        const double length = 1e-3 * static_cast<double>(1 + random() % 100);
        const ref::Vec3 leg(length, 0, 0);
        const ref::Vec3 start = builder.at();
        if (random() % 4 == 0) {
            builder.line(start + leg, 500);
        } else {
            const ref::Vec3 aside(0, 1e-3 * length, 0);
            builder.cubic(start + leg / 3, start + leg * 2 / 3 + aside, start + leg + aside, 500);
        }
    }
    return builder.program();
}

}  // namespace curvecore::tb
