// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/optimum/run_path.hpp"

#include <algorithm>
#include <cmath>

#include "ref/limits/limits.hpp"
#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {
namespace {

constexpr double kInset = 1e-6;  // share of an interval: distance of both sides of a joint from it
constexpr int kParts = 4;        // parts of an interval
constexpr double kSameShare = 0.05;  // share of r', r'', r''': constant enough within an interval

bool differ(const PlaceLimit& a, const PlaceLimit& b) {
    const auto apart = [](double x, double y) {
        return std::abs(x - y) > kSameShare * std::max(x, y);
    };
    return apart(a.d11, b.d11) || apart(a.d22, b.d22) || apart(a.d33, b.d33);
}

/// Time at which a phase is x mm from its start, near `t`.
double time_near(const Phase& phase, double t, double x) {
    constexpr double kExact = 1e-9;  // share of the phase
    constexpr int kNewtonRounds = 8;
    for (int round = 0; round < kNewtonRounds; ++round) {
        const double v = phase.speed(t);
        if (!(v > 0)) break;
        const double more = (x - ((phase.j / 6 * t + phase.a / 2) * t + phase.v) * t) / v;
        t = std::clamp(t + more, 0.0, phase.duration);
        if (std::abs(more) <= kExact * phase.duration) return t;
    }
    Phase local = phase;
    local.s = 0;
    return time_at(local, 0, x);
}

}  // namespace

RunPath::RunPath(const std::vector<RunMove>& moves, const Geometry& geometry,
                 const Machine& machine, PathPlaces& places, const std::vector<RunKnot>& knots)
    : moves_(moves), geometry_(geometry), machine_(machine), places_(places), knots_(knots) {
    begin_.push_back(0);
    for (const RunMove& move : moves) begin_.push_back(begin_.back() + move.length);
    for (std::size_t k = 0; k < count(); ++k) look_at(k);
    first_look_.push_back(looks_.size());
}

/// Returns the move at s, which is after its start or before its end.
std::size_t RunPath::move_at(long double s) const {
    const auto after = std::upper_bound(begin_.begin() + 1, begin_.end() - 1, s);
    return static_cast<std::size_t>(after - begin_.begin()) - 1;
}

/// Looks just inside the ends, and at both sides of joints.
void RunPath::look_at(std::size_t k) {
    first_look_.push_back(looks_.size());
    const long double from = knots_[k].s;
    const long double length = knots_[k + 1].s - from;
    const long double inside = length * kInset;
    std::size_t move = move_at(from + inside);
    for (int part = 0; part <= kParts; ++part) {
        const double time = static_cast<double>(part) / kParts;
        double x = time;
        if (starts(k)) x = time * time * time;
        if (ends(k)) x = 1 - (1 - time) * (1 - time) * (1 - time);
        const long double s = from + std::clamp(x, kInset, 1 - kInset) * length;
        for (; move + 1 < moves_.size() && begin_[move + 1] <= s; ++move) {
            add(begin_[move + 1] - inside, -1, move);
            add(begin_[move + 1] + inside, -1, move + 1);
        }
        add(s, part, move);
    }
}

void RunPath::add(long double s, int part, std::size_t move) {
    const RunMove& on = moves_[move];
    const PathShape& shape = geometry_.moves[on.planned].shape;
    const PathPlace at = places_.at(on.planned, static_cast<double>(s - begin_[move]));
    Look look{s, part, move, on.velocity, kUnlimitedChange, limits_.size()};
    if (on.slow_axes) {
        look.velocity =
            std::min(look.velocity, kVelocityShare * highest_speed(at.d1, shape, machine_));
    }
    for (PlaceLimit limit : place_limits(at, shape, machine_)) {
        if (limit.d11 > 0) look.jerk = std::min(look.jerk, limit.jerk / std::sqrt(limit.d11));
        limit.acceleration *= kAccelerationShare;
        limit.jerk = std::min(kJerkShare * limit.jerk, on.jerk);
        limits_.push_back(limit);
    }
    looks_.push_back(look);
}

double RunPath::jerk_along(std::size_t k) const {
    return looks_[k < count() ? first_look_[k] : looks_.size() - 1].jerk;
}

bool RunPath::bends(std::size_t look) const {
    for (std::size_t i = looks_[look].limits; i < limits_end(look); ++i) {
        if (limits_[i].d22 > 0) return true;
    }
    return false;
}

/// Returns true if the path bends unevenly.
bool RunPath::changes(std::size_t k) const {
    const std::size_t first = first_look_[k];
    const std::size_t count = limits_end(first) - looks_[first].limits;
    for (std::size_t i = first + 1; i < first_look_[k + 1]; ++i) {
        if (limits_end(i) - looks_[i].limits != count) return true;
        for (std::size_t j = 0; j < count; ++j) {
            if (differ(limits_[looks_[first].limits + j], limits_[looks_[i].limits + j])) {
                return true;
            }
        }
    }
    return false;
}

PathInterval RunPath::interval(std::size_t k) const {
    const long double from = knots_[k].s;
    const long double to = knots_[k + 1].s;
    const std::size_t first = first_look_[k];
    const std::size_t end = first_look_[k + 1];
    PathInterval interval;
    interval.length = static_cast<double>(to - from);
    const std::size_t last = looks_[end - 1].move;
    double velocity = kUnlimited;
    for (std::size_t move = looks_[first].move; move <= last; ++move) {
        velocity = std::min(velocity, moves_[move].velocity);
        if (move < last) velocity = std::min(velocity, moves_[move].end_velocity);
    }
    const auto least = [&](int from_part, int to_part) {
        double most = velocity;
        for (std::size_t i = first; i < end; ++i) {
            const int part = looks_[i].part;
            if (part < 0 || (part >= from_part && part <= to_part)) {
                most = std::min(most, looks_[i].velocity);
            }
        }
        return most;
    };
    interval.start_velocity = least(0, 0);
    interval.velocity = least(kParts / 2, kParts / 2);
    interval.end_velocity = least(kParts, kParts);
    const bool joins = begin_[last + 1] < to + interval.length * kInset;
    if (joins && last + 1 < moves_.size()) {
        interval.end_velocity = std::min(interval.end_velocity, moves_[last].end_velocity);
    }
    const bool rests = starts(k) || ends(k);
    const bool all = !rests && changes(k);
    const bool bent = bends(first);
    for (std::size_t i = first; i < end; ++i) {
        const int part = looks_[i].part;
        if (rests) {
            const long double x = starts(k) ? looks_[i].s - from : to - looks_[i].s;
            const bool still = part == (starts(k) ? 0 : kParts);
            if (part >= 0 && !still) {
                add_resting(i, interval, static_cast<double>(x) / interval.length);
            }
        } else if (all) {
            if (part < 0 || part % 2 == 0) add_places(i, interval, from, true, true);
        } else if (bent ? part == 0 || part == kParts : part == kParts / 2 || part == kParts) {
            // Where the path bends evenly, the acceleration at the end and the jerk at both, since
            // it changes with the acceleration; on a line, where it does not, in the middle.
            add_places(i, interval, from, part == kParts, bent || part != kParts);
        }
    }
    return interval;
}

void RunPath::add_places(std::size_t look, PathInterval& interval, long double from,
                         bool acceleration, bool jerk) const {
    const auto x = static_cast<double>(looks_[look].s - from);
    for (std::size_t i = looks_[look].limits; i < limits_end(look); ++i) {
        interval.places.push_back({x, acceleration, jerk, limits_[i], 1});
    }
}

/// Adds the places beside a rest: between it and a place h farther on the jerk is constant, so x h
/// from rest q = q(h) x^(4/3): what bends there counts as at the place, but r'' x times and r'''
/// x^2 times.
void RunPath::add_resting(std::size_t look, PathInterval& interval, double x) const {
    const bool moving = x > 0.9;
    for (std::size_t i = looks_[look].limits; i < limits_end(look); ++i) {
        PlaceLimit limit = limits_[i];
        limit.d12 *= x;
        limit.d13 *= x * x;
        limit.d22 *= x * x;
        limit.d23 *= x * x * x;
        limit.d33 *= x * x * x * x;
        interval.places.push_back({0, moving, true, limit, 1});
    }
}

RunLoads RunPath::loads(const Phase& phase, std::size_t first, std::size_t end,
                        const RunLoads& most) const {
    RunLoads worst;
    double square = 0;  // square of the worst load
    double t = 0;
    for (std::size_t i = first_look_[first]; i < first_look_[end]; ++i) {
        const Look& look = looks_[i];
        t = time_near(phase, t, static_cast<double>(look.s - phase.s));
        const double v = phase.speed(t);
        worst.speed = std::max(worst.speed, v / look.velocity);
        if (i > first_look_[first] && looks_[i - 1].move != look.move) {
            worst.speed = std::max(worst.speed, v / moves_[look.move - 1].end_velocity);
        }
        // A curve that may stand still has no limit there.
        if (i > 0 && i + 1 < looks_.size()) {
            const double a = phase.acceleration(t);
            for (std::size_t j = look.limits; j < limits_end(i); ++j) {
                const PlaceLimit& limit = limits_[j];
                square = std::max({square,
                                   acceleration_square(limit, v * v, a) /
                                       (limit.acceleration * limit.acceleration),
                                   jerk_square(limit, v, a, phase.j) / (limit.jerk * limit.jerk)});
            }
        }
        if (square > most.load * most.load || worst.speed > most.speed) break;
    }
    worst.load = std::sqrt(square);
    return worst;
}

}  // namespace curvecore::ref
