// SPDX-License-Identifier: Apache-2.0
// Seeded moves of every size that an arc core must draw: arcs in any plane, helices, lines; mm.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "ref/moves/move.hpp"

namespace curvecore::sysc {

struct ArcFamily {
    std::string name;
    double radius;  // mm; 0: line
    bool helix;
};

inline const std::vector<ArcFamily>& arc_families() {
    static const std::vector<ArcFamily> families = {
        {"arcs, R = 10 um", 0.01, false},   {"arcs, R = 100 um", 0.1, false},
        {"arcs, R = 1 mm", 1, false},       {"arcs, R = 10 mm", 10, false},
        {"arcs, R = 100 mm", 100, false},   {"arcs, R = 1 m", 1000, false},
        {"helices, R = 100 um", 0.1, true}, {"helices, R = 10 mm", 10, true},
        {"helices, R = 1 m", 1000, true},   {"lines, 1 um .. 1 m", 0, false},
    };
    return families;
}

class ArcMaker {
  public:
    explicit ArcMaker(std::uint64_t seed) : engine_(seed) {}

    ref::Move next(const ArcFamily& family) {
        ref::Move move;
        move.line = 1;
        move.feed = 10;
        if (family.radius == 0) {
            const double length = std::exp(uniform(std::log(1e-3), std::log(1000.0)));
            move.start = point(500);
            move.end = move.start + direction() * length;
            return move;
        }
        move.kind = ref::Move::Kind::kArc;
        move.normal = direction();
        const ref::Vec3 outward = move.normal.unitOrthogonal();
        move.centre = point(500);
        move.start = move.centre + outward * family.radius;
        move.angle = uniform(0.01, 2 * M_PI);
        const double rise = family.helix ? family.radius * uniform(-1, 1) : 0;
        move.advance = rise * move.normal;
        const ref::Vec3 partner = move.normal.cross(outward);
        move.end =
            move.centre + move.advance +
            family.radius * (outward * std::cos(move.angle) + partner * std::sin(move.angle));
        return move;
    }

    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }

  private:
    ref::Vec3 direction() {
        std::normal_distribution<double> normal;
        return ref::Vec3(normal(engine_), normal(engine_), normal(engine_)).normalized();
    }
    ref::Vec3 point(double size) {
        return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
    }

    std::mt19937_64 engine_;
};

}  // namespace curvecore::sysc
