// SPDX-License-Identifier: Apache-2.0
// Short programs with the worst possible joints: zigzags, clusters, turns of every size and
// spacing, curvature that changes sign, axes with separate limits.
#pragma once

#include <random>

#include "ref/segment/plan_options.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb {

struct JointCase {
    ref::Program program;
    ref::Machine machine;
    ref::PlanOptions options;
};

class RandomJoints {
  public:
    explicit RandomJoints(unsigned seed) : random_(seed) {}

    JointCase make() {
        flat_ = whole(0, 1) == 1;
        feed_ = spread(5, 500);
        tangent_ = direction();
        if (whole(0, 2) > 0) line(spread(0.1, 30));
        const int count = whole(5, 60);
        switch (whole(0, 7)) {
            case 0:
                zigzag(count);
                break;
            case 1:
                curve(3 * count);
                break;
            case 2:
                clusters();
                break;
            case 3:
                walk(count, 1e-5);
                break;
            case 4:
                walk(count, 1e-3);
                break;
            case 5:
                arcs(count);
                break;
            case 6:
                cubics(count / 6 + 3);
                break;
            default:
                mixture(count);
                break;
        }
        JointCase made;
        made.program = builder_.program();
        if (whole(0, 3) == 0) add_aux_axes(made.program);
        set_machine(made.machine);
        if (whole(0, 2) == 0) {
            made.options.sample_period_s = whole(0, 1) == 1 ? 2e-5 : 2.5e-4;
            made.options.samples_per_tick = whole(0, 1) == 1 ? 1 : 4;
        }
        made.options.aux_axes = made.program.aux_axes;
        return made;
    }

  private:
    double uniform(double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random_);
    }
    double spread(double low, double high) { return low * std::pow(high / low, uniform(0, 1)); }
    int whole(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
    }
    ref::Vec3 direction() {
        return ref::Vec3(uniform(-1, 1), uniform(-1, 1), flat_ ? 0 : uniform(-1, 1)).normalized();
    }
    ref::Vec3 across() {
        const ref::Vec3 side = tangent_.cross(flat_ ? ref::Vec3(0, 0, 1) : direction());
        return (whole(0, 1) == 1 ? side : -side).normalized();
    }
    static ref::Vec3 turned(const ref::Vec3& t, const ref::Vec3& n, double angle) {
        return (t * std::cos(angle) + n * std::sin(angle)).normalized();
    }
    void turn(double angle) { tangent_ = turned(tangent_, across(), angle); }
    void rest(ref::Move& move) {
        if (whole(0, 30) != 0) return;
        move.exact_stop = whole(0, 1) == 1;
        if (!move.exact_stop) move.dwell = spread(1e-4, 0.05);
    }
    void line(double length) { rest(builder_.line(builder_.at() + length * tangent_, feed_)); }
    void arc() {
        ref::Move& move =
            builder_.tangent_arc(tangent_, across(), spread(0.05, 50), spread(1e-3, 3), feed_);
        rest(move);
        tangent_ = end_tangent(move);
    }
    void cubic(double length) {
        const ref::Vec3 end_tangent = turned(tangent_, across(), uniform(0, 1.5));
        const ref::Vec3 end = builder_.at() + length * (tangent_ + end_tangent) / 2;
        rest(builder_.cubic(builder_.at() + length * tangent_ * uniform(0.2, 0.6),
                            end - length * end_tangent * uniform(0.2, 0.6), end, feed_));
        tangent_ = end_tangent;
    }

    void zigzag(int count) {
        const ref::Vec3 ahead = tangent_;
        const ref::Vec3 side = across();
        const double angle = spread(1e-4, 0.125);
        const double length = spread(1e-4, 3);
        for (int i = 0; i < count; ++i) {
            tangent_ = turned(ahead, side, i % 2 == 1 ? angle : -angle);
            line(length * (whole(0, 1) == 1 ? 1 : uniform(0.5, 1.5)));
        }
    }
    void curve(int count) {
        const double angle = spread(1e-4, 0.25);
        const double length = spread(1e-4, 3);
        const double uneven = whole(0, 1) == 1 ? 0 : uniform(0, 0.9);
        ref::Vec3 side = across();
        for (int i = 0; i < count; ++i) {
            const ref::Vec3 before = tangent_;
            tangent_ = turned(before, side, angle);
            side = turned(side, -before, angle);
            line(length * (1 + uneven * uniform(-1, 1)));
        }
    }
    void clusters() {
        for (int cluster = 0; cluster < 4; ++cluster) {
            for (int i = whole(1, 6); i > 0; --i) {
                turn(spread(1e-3, 0.25));
                line(spread(1e-5, 0.2));
            }
            line(spread(0.5, 40));
        }
    }
    void walk(int count, double shortest) {
        const bool feeds = whole(0, 1) == 1;
        for (int i = 0; i < count; ++i) {
            if (feeds) feed_ = spread(5, 500);
            turn(spread(1e-4, 0.25));
            line(spread(shortest, 4));
        }
    }
    void arcs(int count) {
        for (int i = 0; i < count; ++i) {
            if (whole(0, 2) == 0) turn(spread(1e-4, 0.2));
            arc();
            if (whole(0, 4) == 0) line(spread(1e-4, 3));
        }
    }
    void cubics(int count) {
        const double length = spread(0.2, 8);
        for (int i = 0; i < count; ++i) {
            cubic(length);
            if (whole(0, 3) == 0) turn(spread(1e-4, 0.2));
        }
    }
    void mixture(int count) {
        for (int i = 0; i < count; ++i) {
            if (whole(0, 1) == 1) turn(spread(1e-4, 0.2));
            switch (whole(0, 3)) {
                case 0:
                    line(spread(1e-4, 5));
                    break;
                case 1:
                    arc();
                    break;
                case 2:
                    cubic(spread(0.01, 5));
                    break;
                default:
                    helix();
                    break;
            }
        }
    }
    void helix() {
        const ref::Vec3 side = across();
        ref::Move& move = builder_.arc(builder_.at() + side * spread(0.1, 20), tangent_.cross(side),
                                       spread(0.05, 8), uniform(-3, 3), feed_);
        rest(move);
        tangent_ = end_tangent(move);
    }

    void add_aux_axes(ref::Program& program) {
        program.aux_axes = whole(0, 1) == 1 ? 1 : 6;
        double rate = uniform(-1.2, 1.2);
        ref::Aux at{};
        for (ref::Move& move : program.moves) {
            if (whole(0, 2) == 0) rate += uniform(-0.2, 0.2) * (whole(0, 1) == 1 ? 1 : 0.05);
            rate = std::clamp(rate, -1.8, 1.8);
            move.aux_start = at;
            for (std::size_t i = 0; i < static_cast<std::size_t>(program.aux_axes); ++i) {
                at[i] += rate * move.length() / (1 + static_cast<double>(i));
            }
            move.aux_end = at;
        }
    }
    void set_machine(ref::Machine& machine) {
        machine.acceleration = whole(0, 1) == 1 ? 5000 : spread(300, 30000);
        machine.jerk = whole(0, 1) == 1 ? 1e5 : machine.acceleration * spread(5, 200);
        machine.velocity = spread(50, 1000);
        for (ref::AxisLimits& axis : machine.axis) {
            const double share = whole(0, 1) == 1 ? 1 : uniform(0.2, 1.5);
            axis.acceleration = machine.acceleration * share;
            axis.jerk = machine.jerk * (whole(0, 1) == 1 ? share : uniform(0.2, 1.5));
            axis.velocity = spread(50, 1000);
            axis.min = -1e4;
            axis.max = 1e4;
        }
        if (whole(0, 4) == 0) machine.joint_time = whole(0, 1) == 1 ? 2e-3 : 5e-4;
    }

    std::mt19937 random_;
    ProgramBuilder builder_;
    ref::Vec3 tangent_;
    bool flat_ = false;
    double feed_ = 0;
};

}  // namespace curvecore::tb
