// SPDX-License-Identifier: Apache-2.0
// Random programs with cubics among lines and arcs, for the planner's tests.
#pragma once

#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb {

/// A walk of cubics of every size, most of them tangent to the move before: bends, S bends,
/// hairpins, loops, near cusps and exact ones, doubled ends; a fifth are lines and arcs.
inline ref::Program random_splines(unsigned seed, int moves, double largest = 20) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    const auto direction = [&] {
        return ref::Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized();
    };
    ProgramBuilder builder;
    ref::Vec3 heading = direction();
    for (int i = 0; i < moves; ++i) {
        const double size = largest * std::pow(10.0, uniform(-3, 0));
        const double feed = uniform(0, 1) < 0.1 ? 0 : std::pow(10.0, uniform(0, 2.7));
        if (uniform(0, 1) < 0.2) heading = direction();
        if (builder.at().norm() > 300) heading = -builder.at().normalized();
        const ref::Vec3 side = heading.cross(direction()).normalized();
        const ref::Vec3 p = builder.at();
        const double kind = uniform(0, 10);
        ref::Move* move = nullptr;
        if (kind < 1) {
            move = &builder.line(p + size * heading, feed);
        } else if (kind < 2) {
            move = &builder.tangent_arc(heading, side, size, uniform(0.1, 3), feed);
        } else if (kind < 5) {  // anything
            move = &builder.cubic(p + uniform(0.2, 1) * size * heading, p + size * direction(),
                                  p + size * direction(), feed);
        } else if (kind < 7) {  // gentle, twisted
            const ref::Vec3 end = p + size * (heading + 0.3 * side);
            move = &builder.cubic(p + size / 3 * heading,
                                  end - size / 3 * (heading + 0.2 * direction()), end, feed);
        } else if (kind < 8.5) {  // a hairpin, or a cusp where both legs cross in the middle
            const double width = uniform(0, 1) < 0.3 ? 0 : std::pow(10.0, uniform(-3, -0.5));
            const ref::Vec3 leg = size * (heading + side);
            const ref::Vec3 end = p + size * side;
            move = &builder.cubic(p + leg, end + size * (heading - side) * (1 - width), end, feed);
        } else if (kind < 9) {  // doubled start
            move = &builder.cubic(p, p + size * (heading + side), p + 2 * size * heading, feed);
        } else if (kind < 9.5) {  // doubled end
            const ref::Vec3 end = p + size * (heading + side);
            move = &builder.cubic(p + size * heading, end, end, feed);
        } else {  // straight
            move = &builder.cubic(p + size * heading, p + 1.5 * size * heading,
                                  p + 2.5 * size * heading, feed);
        }
        const bool stands = move->kind == ref::Move::Kind::kCubic && move->cubic.speed(1) < 1e-9;
        if (!stands) heading = end_tangent(*move);
        if (uniform(0, 1) < 0.03) move->exact_stop = true;
    }
    return builder.program();
}

}  // namespace curvecore::tb
