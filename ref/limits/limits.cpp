// SPDX-License-Identifier: Apache-2.0
#include "ref/limits/limits.hpp"

#include <algorithm>
#include <cmath>

#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {
namespace {

// Shares of an arc's limits that may go across the path at top speed; the rest remains along it.
constexpr double kCentripetalShare = 0.866;    // hypot(0.866, 0.5) = 1
constexpr double kCentripetalJerkShare = 0.4;  // share of v^3 / R^2
constexpr double kCrossJerkShare = 0.6;        // share of 3 v a / R
// Splines: the speed that a bend takes must be gained before it.
constexpr double kSwerveShare = 0.3;       // share of v^3 swerve
constexpr double kCrossSwerveShare = 0.7;  // share of 3 v a curvature + v^3 swerve

/// One constraint, the path itself or an axis, with its limits.
struct Load {
    double swing;    // share of the circular part
    double advance;  // |constant part|
    double acceleration, jerk;
    double curvature, twist, swerve;  // of the circular part
};

template <class Visit>
void each_load(const PathShape& shape, const Machine& machine, Visit visit) {
    if (shape.linear && shape.tool) {
        const ToolShape& tool = *shape.tool;
        const double curvature = tool.curvature / tool.rate;
        visit(Load{tool.rate, 0, machine.acceleration, machine.jerk, curvature, curvature,
                   tool.swerve / tool.rate});
    } else if (shape.linear) {
        // Circular and axial parts are at right angles: hypot(turn, axial) <= rate.
        const double swing = shape.turn > 0 ? 1 : 0;
        const double beside = shape.turn > 0 ? shape.drift : shape.rate;
        visit(Load{swing, beside, machine.acceleration, machine.jerk, shape.curvature, shape.twist,
                   shape.swerve});
    }
    for (int i = 0; i < kMachineAxes; ++i) {
        if (shape.swing[i] == 0 && shape.advance[i] == 0) continue;
        const AxisLimits& axis = machine.axis[i];
        visit(Load{shape.swing[i], std::abs(shape.advance[i]), axis.acceleration, axis.jerk,
                   shape.curvature, shape.twist, shape.swerve});
    }
}

/// Returns the largest x >= 0 with p hypot(x, w) + q x <= limit; 0 if p w is beyond the limit.
double largest(double p, double w, double q, double limit) {
    const double room = limit * limit - p * p * w * w;
    if (limit <= 0 || room <= 0) return 0;
    const double root = std::sqrt(q * q * w * w + room);
    return room / (limit * q + p * root);
}

/// Rate of the circular part: `turn` for the axes in its plane, the whole |r'| for the path.
double circular_rate(const PathShape& shape) {
    return shape.turn > 0 ? std::max(shape.turn, shape.rate) : 0;
}

}  // namespace

double path_speed(const PathShape& shape, const Machine& machine) {
    if (!shape.linear) return kUnlimitedSpeed;
    if (shape.tool) return machine.velocity / shape.tool->rate;
    return machine.velocity / (shape.turn > 0 ? circular_rate(shape) : shape.rate);
}

double highest_speed(const AxisVector& along, const PathShape& shape, const Machine& machine) {
    double v = path_speed(shape, machine);
    for (std::size_t i = 0; i < kMachineAxes; ++i) {
        const double rate = std::abs(along[i]);
        if (rate > 0) v = std::min(v, machine.axis[i].velocity / rate);
    }
    return v;
}

double highest_speed(const PathShape& shape, const Machine& machine) {
    return highest_speed(shape.along, shape, machine);
}

double top_speed(const PathShape& shape, const Machine& machine) {
    double v = highest_speed(shape, machine);
    const auto keep_cube = [&](double most) {
        if (v * v * v > most) v = std::cbrt(most);
    };
    each_load(shape, machine, [&](const Load& load) {
        const double across = load.swing * load.curvature;
        const double swerve = load.swing * load.swerve;
        if (across > 0) {
            v = std::min(v, std::sqrt(kCentripetalShare * load.acceleration / across));
            keep_cube(kCentripetalJerkShare * load.jerk / (across * load.twist));
        }
        if (swerve > 0) keep_cube(kSwerveShare * load.jerk / swerve);
    });
    return v;
}

PathLimits along_path(const PathShape& shape, const Machine& machine, double v) {
    const double turn = circular_rate(shape);
    PathLimits limits{v, 1e12, 1e15};
    each_load(shape, machine, [&](const Load& load) {
        const double swerve = v * v * v * load.swerve;
        double a = 0;
        if (load.swing > 0) {
            // swing hypot(turn a, v^2 curvature) + advance a <= acceleration
            a = largest(load.swing, v * v * load.curvature, load.advance / turn,
                        load.acceleration) /
                turn;
            const double share = swerve > 0 ? kCrossSwerveShare : kCrossJerkShare;
            const double room = share * load.jerk / load.swing - swerve;
            a = std::min(a, std::max(0.0, room) / (3 * v * load.curvature));
        } else {
            a = load.acceleration / load.advance;
        }
        limits.acceleration = std::min(limits.acceleration, a);
    });

    each_load(shape, machine, [&](const Load& load) {
        const double cross = 3 * v * limits.acceleration * load.curvature + v * v * v * load.swerve;
        const double around = v * v * v * load.curvature * load.twist;
        double j = 0;
        if (load.swing > 0) {
            // With y = turn j + around: swing hypot(y, cross) + (advance / turn) (y - around)
            const double q = load.advance / turn;
            j = (largest(load.swing, cross, q, load.jerk + q * around) - around) / turn;
        } else {
            j = load.jerk / load.advance;
        }
        limits.jerk = std::min(limits.jerk, j);
    });
    return limits;
}

void each_limit(const PathShape& shape, const Machine& machine,
                const std::function<void(const LimitLoad&)>& visit) {
    const double turn = circular_rate(shape);
    each_load(shape, machine, [&](const Load& load) {
        visit({load.swing * turn + load.advance, load.swing, load.curvature, load.acceleration,
               load.jerk});
    });
}

namespace {

/// Changes at a joint that the path's own limits see.
struct PathJoint {
    Vec3 turn;  // change of r'
    Vec3 bend;  // and of r''
};

PathJoint path_joint(const PathShape& before, const PathShape& after) {
    if (before.tool && after.tool) {
        return {after.tool->tangent_start - before.tool->tangent_end,
                after.tool->bend_start - before.tool->bend_end};
    }
    Vec3 turn;
    for (std::size_t i = 0; i < 3; ++i) {
        turn[static_cast<Eigen::Index>(i)] = after.tangent_start[i] - before.tangent_end[i];
    }
    return {turn, after.bend_start - before.bend_end};
}

}  // namespace

double joint_velocity(const PathShape& before, const PathShape& after, const Machine& machine) {
    double aux_turn = 0;
    double v = kUnlimitedSpeed;
    for (int i = 0; i < kMachineAxes; ++i) {
        const double turn = std::abs(after.tangent_start[i] - before.tangent_end[i]);
        if (i >= 3) aux_turn += turn * turn;
        if (turn > 0) v = std::min(v, machine.axis[i].acceleration * machine.joint_time / turn);
    }
    const Vec3 bend = after.bend_start - before.bend_end;
    for (int i = 0; i < 3; ++i) {
        if (bend[i] == 0) continue;
        const double limit = machine.axis[i].jerk * machine.joint_time / std::abs(bend[i]);
        v = std::min(v, std::sqrt(limit));
    }
    const auto still = [](const PathShape& shape) {
        return shape.tangent_start[0] == 0 && shape.tangent_start[1] == 0 &&
               shape.tangent_start[2] == 0 && shape.turn == 0;
    };
    const PathJoint path = path_joint(before, after);
    const double turn = std::sqrt(path.turn.squaredNorm() + (still(before) ? aux_turn : 0));
    const double length = before.tool && after.tool ? before.tool->rate : 1;  // of r'
    if (turn > kSmallTurn * length) return 0;
    if (turn > 0) v = std::min(v, machine.acceleration * machine.joint_time / turn);
    const double change = path.bend.norm();
    if (change > 0) v = std::min(v, std::sqrt(machine.jerk * machine.joint_time / change));
    return v;
}

LimitRatios joint_ratios(const PathShape& before, const PathShape& after, const Machine& machine,
                         double v) {
    const double time = machine.joint_time;
    LimitRatios worst;
    const PathJoint path = path_joint(before, after);
    const double turn = path.turn.norm();
    for (int i = 0; i < kMachineAxes; ++i) {
        const double change = after.tangent_start[i] - before.tangent_end[i];
        worst.acceleration = std::max(worst.acceleration,
                                      std::abs(change) * v / (machine.axis[i].acceleration * time));
    }
    worst.acceleration = std::max(worst.acceleration, turn * v / (machine.acceleration * time));
    const Vec3 change = v * v * (after.bend_start - before.bend_end);
    for (int i = 0; i < 3; ++i) {
        worst.jerk = std::max(worst.jerk, std::abs(change[i]) / (machine.axis[i].jerk * time));
    }
    worst.jerk = std::max(worst.jerk, v * v * path.bend.norm() / (machine.jerk * time));
    return worst;
}

double ramp_time(const Machine& machine) {
    double time = machine.acceleration / machine.jerk;
    for (const AxisLimits& axis : machine.axis) {
        time = std::min(time, axis.acceleration / axis.jerk);
    }
    return time;
}

double ramp_time(const PathShape& shape, const Machine& machine) {
    const double turn = circular_rate(shape);
    double acceleration = kUnlimitedChange;
    double jerk = kUnlimitedChange;
    each_load(shape, machine, [&](const Load& load) {
        const double rate = load.swing * turn + load.advance;
        acceleration = std::min(acceleration, load.acceleration / rate);
        jerk = std::min(jerk, load.jerk / rate);
    });
    return acceleration / jerk;
}

}  // namespace curvecore::ref
