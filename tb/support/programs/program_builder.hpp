// SPDX-License-Identifier: Apache-2.0
// Programs for the planner's tests, without a reader: moves that follow each other.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "ref/machine/machine.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::tb {

class ProgramBuilder {
  public:
    ProgramBuilder() { program_.file = "test.ngc"; }

    ref::Move& line(const ref::Vec3& end, double feed) {
        ref::Move& move = next(feed);
        move.end = at_ = end;
        return move;
    }

    /// Adds a cubic with these control points after the last position; the last one is the end.
    ref::Move& cubic(const ref::Vec3& leg, const ref::Vec3& second, const ref::Vec3& end,
                     double feed) {
        ref::Move& move = next(feed);
        move.kind = ref::Move::Kind::kCubic;
        move.cubic = ref::from_bezier({at_, leg, second, end});
        move.end = at_ = end;
        return move;
    }

    /// Adds an arc counter-clockwise about `normal` by `angle`, rising by `advance` along it.
    ref::Move& arc(const ref::Vec3& centre, const ref::Vec3& normal, double angle, double advance,
                   double feed) {
        ref::Move& move = next(feed);
        move.kind = ref::Move::Kind::kArc;
        move.normal = normal.normalized();
        move.centre = centre + move.normal * move.normal.dot(at_ - centre);
        move.angle = angle;
        move.advance = advance * move.normal;
        const ref::Vec3 arm = at_ - move.centre;
        move.end = move.centre + Eigen::AngleAxisd(angle, move.normal) * arm + move.advance;
        at_ = move.end;
        return move;
    }

    /// Adds an arc that leaves along `tangent`, with its centre on the side of `towards`.
    ref::Move& tangent_arc(const ref::Vec3& tangent, const ref::Vec3& towards, double radius,
                           double angle, double feed) {
        const ref::Vec3 n = (towards - tangent * tangent.dot(towards)).normalized();
        return arc(at_ + radius * n, tangent.cross(n), angle, 0, feed);
    }

    const ref::Vec3& at() const { return at_; }
    ref::Program& program() { return program_; }

  private:
    ref::Move& next(double feed) {
        ref::Move move;
        move.line = static_cast<int>(program_.moves.size()) + 1;
        move.start = move.end = at_;
        move.feed = feed;
        move.rapid = feed == 0;
        if (!program_.moves.empty()) move.aux_start = program_.moves.back().aux_end;
        move.aux_end = move.aux_start;
        program_.moves.push_back(move);
        return program_.moves.back();
    }

    ref::Program program_;
    ref::Vec3 at_ = ref::Vec3::Zero();
};

/// Unit tangent at the end of a move.
inline ref::Vec3 end_tangent(const ref::Move& move) {
    if (move.kind == ref::Move::Kind::kLine) return (move.end - move.start).normalized();
    if (move.kind == ref::Move::Kind::kCubic) return ref::tangent(move.cubic, 1);
    const ref::Vec3 arm =
        move.end - move.centre - move.normal * move.normal.dot(move.end - move.centre);
    return (move.normal.cross(arm) * move.angle + move.advance).normalized();
}

/// The built-in machine with limits that differ from axis to axis, 0.3 to 1.3 of its own.
inline ref::Machine unequal_machine(unsigned seed) {
    std::mt19937 random(seed);
    const auto factor = [&] { return 0.3 + static_cast<double>(random() % 1000) * 1e-3; };
    ref::Machine machine;
    for (ref::AxisLimits& axis : machine.axis) {
        axis.velocity *= factor();
        axis.acceleration *= factor();
        axis.jerk *= factor();
    }
    return machine;
}

/// A random walk of lines, arcs in any plane and helices, tangent or not, of every size.
inline ref::Program random_program(unsigned seed, int moves, double largest = 30) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    const auto direction = [&] {
        return ref::Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized();
    };
    ProgramBuilder builder;
    for (int i = 0; i < moves; ++i) {
        const double size = largest * std::pow(10.0, uniform(-4, 0));
        const double feed = uniform(0, 1) < 0.1 ? 0 : std::pow(10.0, uniform(-1, 2.7));
        ref::Vec3 tangent = direction();
        if (i > 0 && uniform(0, 1) < 0.6) {
            tangent = (end_tangent(builder.program().moves.back()) +
                       direction() * (uniform(0, 1) < 0.5 ? 0 : uniform(0, 0.2)))
                          .normalized();
        }
        if (builder.at().norm() > 300) tangent = -builder.at().normalized();
        ref::Move* move = nullptr;
        const int kind = static_cast<int>(uniform(0, 4));
        if (kind < 2) {
            move = &builder.line(builder.at() + size * tangent, feed);
        } else if (kind == 2) {
            move = &builder.tangent_arc(tangent, direction(), size, uniform(0.01, 7), feed);
        } else {
            const ref::Vec3 normal = direction();
            const ref::Vec3 arm = normal.cross(direction()).normalized() * size;
            move = &builder.arc(builder.at() + arm, normal, uniform(0.01, 7), uniform(-1, 1) * size,
                                feed);
        }
        if (uniform(0, 1) < 0.05) move->exact_stop = true;
        if (uniform(0, 1) < 0.03) move->dwell = uniform(0, 0.5);
    }
    return builder.program();
}

}  // namespace curvecore::tb
