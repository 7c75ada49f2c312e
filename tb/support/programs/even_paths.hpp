// SPDX-License-Identifier: Apache-2.0
// Paths that are alike everywhere, at high feed: the shortest stop on them is known.
#pragma once

#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb {

inline ref::Program fast_line(double length) {
    ProgramBuilder builder;
    builder.line({length, 0, 0}, 500);
    return builder.program();
}
inline ref::Program fast_arc(double radius, double angle, double rise) {
    ProgramBuilder builder;
    builder.arc({-radius, 0, 0}, {0, 0, 1}, angle, rise, 500);
    return builder.program();
}

struct EvenPath {
    const char* name;
    ref::Program program;
    double bend, third;  // |r''|, |r'''|
};
inline std::vector<EvenPath> even_paths() {
    const double rate = 6 * M_PI / std::hypot(60 * M_PI, 12.);
    return {{"line 1", fast_line(1), 0, 0},
            {"line 10", fast_line(10), 0, 0},
            {"line 100", fast_line(100), 0, 0},
            {"line 300", fast_line(300), 0, 0},
            {"circle 2", fast_arc(2, 2 * M_PI, 0), 1 / 2., 1 / 4.},
            {"circle 25", fast_arc(25, 2 * M_PI, 0), 1 / 25., 1 / 625.},
            {"helix", fast_arc(10, 6 * M_PI, 12), 10 * rate * rate, 10 * rate * rate * rate}};
}

}  // namespace curvecore::tb
