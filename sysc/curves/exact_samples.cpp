// SPDX-License-Identifier: Apache-2.0
#include "sysc/curves/exact_samples.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <optional>
#include <random>

#include "ref/curve/arc_length.hpp"
#include "ref/curve/drawn/table_curve.hpp"
#include "ref/format/path_words.hpp"
#include "ref/limits/path_shape.hpp"

namespace curvecore::sysc {
namespace {

/// Margin, quanta, for a move's ends: plans shift them by the rounding of their sums, and of
/// lengths of cubics.
std::int64_t margin(long double path) {
    return 16 + static_cast<std::int64_t>(1e-12L * path * ref::kQuantaPerUnit);
}

/// A move in units, parametrised by path length in units.
class ExactMove {
  public:
    ExactMove(const ref::Move& move, double unit_mm) : move_(move), unit_(unit_mm) {
        if (move.kind == ref::Move::Kind::kCubic) {
            cubic_ = {move.cubic.a / unit_, move.cubic.b / unit_, move.cubic.c / unit_,
                      move.cubic.d / unit_};
            path_.emplace(cubic_);
            length_ = path_->length();
            return;
        }
        if (move.kind == ref::Move::Kind::kTable) {
            length_ = move.table_length / unit_;
            curve_ = std::make_shared<const ref::TableCurve>(move.table.rescaled(1 / unit_),
                                                             move.start / unit_, length_);
            return;
        }
        const ref::PathShape shape = ref::path_shape(move);
        length_ = shape.length / unit_;
        if (move.kind == ref::Move::Kind::kArc) {
            const ref::Vec3 arm = move.start - move.centre;
            radius_ = arm.norm() / unit_;
            normal_ = arm.normalized();
            tangent_ = move.normal.cross(normal_);
            twist_ = shape.twist * unit_;
            advance_ = move.advance / shape.length;
        } else if (length_ > 0) {
            advance_ = (move.end - move.start) / shape.length;
        }
    }

    double length() const { return length_; }

    void at(double s, ExactSample& sample, double* aux, int aux_axes) const {
        ref::Vec3 position, direction;
        if (path_) {
            const double u = path_->parameter(s);
            position = cubic_.position(u);
            direction = cubic_.velocity(u);
        } else if (curve_) {
            position = curve_->position(s);
            direction = curve_->direction(s);
        } else {
            // Sines of half the angle keep all digits for a far centre.
            const double angle = twist_ * s;
            const double half_sine = std::sin(angle / 2);
            const double sine = std::sin(angle);
            position = move_.start / unit_ + advance_ * s +
                       radius_ * (tangent_ * sine - normal_ * (2 * half_sine * half_sine));
            direction = advance_ + radius_ * twist_ * (tangent_ * std::cos(angle) - normal_ * sine);
        }
        const double speed = direction.norm();
        for (int axis = 0; axis < 3; ++axis) {
            sample.position[axis] = position[axis];
            sample.tangent[axis] = speed > 0 ? direction[axis] / speed : 0;
        }
        for (int i = 0; i < aux_axes; ++i) {
            const auto a = static_cast<std::size_t>(i);
            aux[i] =
                (move_.aux_start[a] + (move_.aux_end[a] - move_.aux_start[a]) * (s / length_)) /
                unit_;
        }
    }

  private:
    const ref::Move& move_;
    double unit_;
    double length_ = 0;
    double radius_ = 0;
    double twist_ = 0;  // rad per unit
    ref::Vec3 normal_ = ref::Vec3::Zero();
    ref::Vec3 tangent_ = ref::Vec3::Zero();
    ref::Vec3 advance_ = ref::Vec3::Zero();
    ref::Cubic cubic_;
    std::optional<ref::ArcLength> path_;
    std::shared_ptr<const ref::TableCurve> curve_;
};

}  // namespace

ExactSamples exact_samples(const ref::Program& program, double unit_mm, std::int64_t count,
                           const std::function<void(std::int64_t)>& keep_going) {
    std::vector<ExactMove> moves;
    moves.reserve(program.moves.size());
    double total = 0;
    int long_moves = 0;
    for (const ref::Move& move : program.moves) {
        moves.emplace_back(move, unit_mm);
        total += moves.back().length();
        long_moves += moves.back().length() * ref::kQuantaPerUnit >= 1 ? 1 : 0;
    }
    ExactSamples exact;
    exact.aux_axes = program.aux_axes;
    exact.samples.reserve(static_cast<std::size_t>(count) + moves.size());
    std::mt19937_64 random(1);
    long double begin = 0;
    double aux[ref::kAuxAxes] = {};
    for (const ExactMove& move : moves) {
        const double share = static_cast<double>(count) / 2 *
                             (move.length() / total + 1.0 / std::max(1, long_moves));
        const auto places = static_cast<std::int64_t>(std::ceil(share));
        const std::int64_t away = margin(begin + move.length());
        const std::int64_t start = std::llround(begin * ref::kQuantaPerUnit) + away;
        const std::int64_t end = std::llround((begin + move.length()) * ref::kQuantaPerUnit) - away;
        bool first = true;
        for (std::int64_t n = 0; n < places; ++n) {
            const double part =
                (static_cast<double>(n) + std::generate_canonical<double, 53>(random)) /
                static_cast<double>(places);
            ExactSample sample;
            sample.s = std::llround((begin + move.length() * part) * ref::kQuantaPerUnit);
            const bool again = !first && sample.s <= exact.samples.back().s;
            if (sample.s < start || sample.s > end || again) continue;
            const double local = static_cast<double>(
                static_cast<long double>(sample.s) / ref::kQuantaPerUnit - begin);
            move.at(local, sample, aux, exact.aux_axes);
            if (!first) {
                const ExactSample& before = exact.samples.back();
                sample.chord = std::hypot(sample.position[0] - before.position[0],
                                          sample.position[1] - before.position[1],
                                          sample.position[2] - before.position[2]);
            }
            first = false;
            exact.samples.push_back(sample);
            exact.aux.insert(exact.aux.end(), aux, aux + exact.aux_axes);
            if (exact.samples.size() % 16384 == 0) {
                keep_going(static_cast<std::int64_t>(exact.samples.size()));
            }
        }
        begin += move.length();
    }
    return exact;
}

}  // namespace curvecore::sysc
