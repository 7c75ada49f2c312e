// SPDX-License-Identifier: Apache-2.0
// Random lines, with every kind of neighbour at every size.
#pragma once

#include <cmath>
#include <random>

#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb {

inline ref::Program with_tolerance(ref::Program program, double tolerance) {
    for (ref::Move& move : program.moves) move.tolerance = tolerance;
    return program;
}

/// A program chosen by the seed: a walk in space, a zigzag in a plane, chords of 0.1 um to 10 mm,
/// or straight runs with corners and reversals; coordinates are rounded as in a file.
inline ref::Program random_lines(unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    ProgramBuilder builder;
    const int kind = static_cast<int>(seed % 4);
    const double size = std::pow(10.0, uniform(-3, 0.7));
    ref::Vec3 way(1, 0, 0);
    for (int i = 0; i < 150; ++i) {
        const ref::Vec3 aside(uniform(-1, 1), uniform(-1, 1), kind == 1 ? 0 : uniform(-1, 1));
        const double chord = kind == 2 ? std::pow(10.0, uniform(-4, 1)) : size;
        if (kind == 0) way = (way + 0.3 * aside).normalized();
        if (kind == 1)
            way = ref::Vec3(1, i % 2 == 0 ? uniform(0, 2) : uniform(-2, 0), 0).normalized();
        if (kind == 2) way = (way + uniform(0, 1) * aside).normalized();
        if (kind == 3 && i % 7 == 0) way = aside.normalized();
        if (kind == 3 && i % 31 == 30) way = -way;
        ref::Vec3 end = builder.at() + chord * way;
        for (double& x : end) x = std::round(x * 1e4) / 1e4;
        if (end != builder.at()) builder.line(end, std::pow(10.0, uniform(1, 2.7)));
    }
    return builder.program();
}

}  // namespace curvecore::tb
