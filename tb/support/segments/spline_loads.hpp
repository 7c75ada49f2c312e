// SPDX-License-Identifier: Apache-2.0
// Loads of a planned motion along splines on the machine: at every tick, from the exact curve.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "ref/curve/arc_length.hpp"
#include "ref/feed/pieces/profile_words.hpp"
#include "ref/limits/limits.hpp"

namespace curvecore::tb {

/// Worst ratios to the limits, of the path and of X Y Z, over all ticks on cubic moves. Speed,
/// acceleration and jerk along the path are the profile words' own; r', r'' and r''' are the
/// cubic's. Left out: rests (a stop's word is rounded, slightly above zero), curvatures of more
/// than a hundredth per path quantum, which only cusps have, and the first tick after a move's
/// start and the last before its end, which belong to the joint.
/// and the last before its end, which belong to the joint.
struct SplineLoads {
    ref::LimitRatios worst;
    double at_jerk = 0;  // mm of the path where the jerk is worst
    std::uint64_t ticks = 0;
};

class SplineLoadMeter {
  public:
    SplineLoadMeter(const ref::Program& program, const ref::Machine& machine, const ref::Plan& plan)
        : program_(program), machine_(machine), plan_(plan) {}

    SplineLoads measure() {
        double begin = 0;  // quanta
        for (const ref::ProfilePiece& piece : plan_.pieces) {
            for (std::uint32_t tick = 0; tick <= piece.ticks && piece.ds > 0; ++tick) {
                const ref::PieceState state = ref::piece_state(piece, tick);
                at(begin + state.s, state);
            }
            begin += static_cast<double>(piece.ds);
        }
        return loads_;
    }

  private:
    /// Moves to the move at path s, quanta.
    void seek(double s) {
        const auto& segments = plan_.segments;
        while (next_ < segments.size() && (arc_ == nullptr || s >= move_end_)) {
            const std::size_t move = segments[next_].move;
            move_begin_ = static_cast<double>(segments[next_].s_start);
            while (next_ < segments.size() && segments[next_].move == move) {
                const ref::Segment& segment = segments[next_++];
                move_end_ = static_cast<double>(segment.s_start + segment.length);
            }
            move_ = &program_.moves[move];
            cubic_ = move_->kind == ref::Move::Kind::kCubic;
            arc_ = std::make_unique<ref::ArcLength>(cubic_ ? move_->cubic : ref::from_bezier({}));
        }
    }

    void at(double s, const ref::PieceState& state) {
        seek(s);
        const double speed = plan_.unit_mm / 65536 / plan_.tick_s;
        const double v = state.v * speed;
        const bool joint = s - move_begin_ < state.v || move_end_ - s < state.v;
        if (!cubic_ || joint || v < 1e-6) return;
        const double a = state.a * speed / plan_.tick_s;
        const double j = state.j * speed / plan_.tick_s / plan_.tick_s;
        const double u = arc_->parameter((s - move_begin_) * plan_.unit_mm / 65536);
        const ref::Vec3 t = ref::tangent(move_->cubic, u);
        const ref::Vec3 n = ref::curvature_vector(move_->cubic, u);
        if (n.norm() * plan_.unit_mm / 65536 > 0.01) return;
        const ref::Vec3 velocity = v * t;
        const ref::Vec3 acceleration = a * t + v * v * n;
        const ref::Vec3 jerk =
            j * t + 3 * v * a * n + v * v * v * ref::curvature_rate(move_->cubic, u);
        ref::LimitRatios& worst = loads_.worst;
        worst.velocity = std::max(worst.velocity, v / machine_.velocity);
        worst.acceleration =
            std::max(worst.acceleration, acceleration.norm() / machine_.acceleration);
        double of_jerk = jerk.norm() / machine_.jerk;
        for (int i = 0; i < 3; ++i) {
            const ref::AxisLimits& axis = machine_.axis[static_cast<std::size_t>(i)];
            worst.velocity = std::max(worst.velocity, std::abs(velocity[i]) / axis.velocity);
            worst.acceleration =
                std::max(worst.acceleration, std::abs(acceleration[i]) / axis.acceleration);
            of_jerk = std::max(of_jerk, std::abs(jerk[i]) / axis.jerk);
        }
        if (of_jerk > worst.jerk) {
            worst.jerk = of_jerk;
            loads_.at_jerk = s * plan_.unit_mm / 65536;
        }
        ++loads_.ticks;
    }

    const ref::Program& program_;
    const ref::Machine& machine_;
    const ref::Plan& plan_;
    const ref::Move* move_ = nullptr;
    std::unique_ptr<ref::ArcLength> arc_;
    bool cubic_ = false;
    double move_begin_ = 0;
    double move_end_ = 0;
    std::size_t next_ = 0;
    SplineLoads loads_;
};

}  // namespace curvecore::tb
