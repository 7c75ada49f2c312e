// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/run_path.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/limits.hpp"

namespace curvecore::ref {
namespace {

constexpr double kInside = 1e-6;  // of an interval: of two sides of a joint, its own
constexpr double kSame = 0.05;    // of r', r'', r''': as good as constant within an interval

bool differ(const PlaceLimit& a, const PlaceLimit& b) {
    const auto apart = [](double x, double y) { return std::abs(x - y) > kSame * std::max(x, y); };
    return apart(a.d11, b.d11) || apart(a.d22, b.d22) || apart(a.d33, b.d33);
}

bool differ(const std::vector<PlaceLimit>& a, const std::vector<PlaceLimit>& b) {
    return !std::equal(a.begin(), a.end(), b.begin(), b.end(),
                       [](const PlaceLimit& x, const PlaceLimit& y) { return !differ(x, y); });
}

}  // namespace

RunPath::RunPath(const std::vector<RunMove>& moves, const Geometry& geometry,
                 const Machine& machine, PathPlaces& places)
    : moves_(moves), geometry_(geometry), machine_(machine), places_(places) {
    begin_.push_back(0);
    for (const RunMove& move : moves) begin_.push_back(begin_.back() + move.length);
}

/// The move at s, which is after it begins or before it ends.
std::size_t RunPath::move_at(long double s) const {
    const auto after = std::upper_bound(begin_.begin() + 1, begin_.end() - 1, s);
    return static_cast<std::size_t>(after - begin_.begin()) - 1;
}

std::vector<PlaceLimit> RunPath::limits(long double s) {
    const std::size_t move = move_at(s);
    const RunMove& on = moves_[move];
    const PathPlace at = places_.at(on.planned, static_cast<double>(s - begin_[move]));
    std::vector<PlaceLimit> limits = place_limits(at, geometry_.moves[on.planned].shape, machine_);
    for (PlaceLimit& limit : limits) {
        limit.acceleration *= kAccelerationShare;
        limit.jerk = std::min(kJerkShare * limit.jerk, on.jerk);
    }
    return limits;
}

PathInterval RunPath::interval(const std::vector<RunKnot>& knots, std::size_t k) {
    const long double from = knots[k].s;
    const long double to = knots[k + 1].s;
    const long double inside = (to - from) * kInside;
    PathInterval interval;
    interval.length = static_cast<double>(to - from);
    interval.velocity = interval.end_velocity = 1e9;
    std::vector<long double> places{from + inside};
    const std::size_t last = move_at(to - inside);
    for (std::size_t move = move_at(from + inside); move <= last; ++move) {
        interval.velocity = std::min(interval.velocity, moves_[move].velocity);
        if (move == last) break;
        interval.velocity = std::min(interval.velocity, moves_[move].end_velocity);
        places.push_back(begin_[move + 1] - inside);
        places.push_back(begin_[move + 1] + inside);
    }
    if (begin_[last + 1] < to + inside) interval.end_velocity = moves_[last].end_velocity;
    places.push_back((from + to) / 2);
    places.push_back(to - inside);
    const bool starts = k == 0 && knots[k].v == 0;
    const bool ends = k + 2 == knots.size() && knots[k + 1].v == 0;
    if (starts || ends) return resting(std::move(interval), starts ? from : to, starts ? to : from);

    std::vector<std::vector<PlaceLimit>> all;
    bool changes = false;
    for (const long double s : places) {
        all.push_back(limits(s));
        changes = changes || differ(all.back(), all.front());
    }
    // Where the path bends evenly, the acceleration at the end and the jerk in the middle do.
    for (std::size_t i = changes ? 0 : all.size() - 2; i < all.size(); ++i) {
        const bool end = i + 1 == all.size();
        for (const PlaceLimit& limit : all[i]) {
            interval.places.push_back(
                {static_cast<double>(places[i] - from), changes || end, changes || !end, limit, 1});
        }
    }
    return interval;
}

/// Between rest and a place h farther on the jerk is constant, so x h from rest q = q(h) x^(4/3):
/// what bends there counts as at the place, but r'' x times and r''' x^2 times.
PathInterval RunPath::resting(PathInterval interval, long double rest, long double moving) {
    for (const double time : {1., 0.75, 0.5, 0.25}) {
        const double x = std::min(time * time * time, 1 - kInside);
        for (PlaceLimit limit : limits(rest + x * (moving - rest))) {
            limit.d12 *= x;
            limit.d13 *= x * x;
            limit.d22 *= x * x;
            limit.d23 *= x * x * x;
            limit.d33 *= x * x * x * x;
            interval.places.push_back({0, time == 1, true, limit, 1});
        }
    }
    return interval;
}

double RunPath::load(const Phase& phase, const Part& part) {
    double worst = 0;
    // Just within the ends; where the curve may stand still, not there at all.
    for (int i = part.first ? 1 : 0; i <= part.places - (part.last ? 1 : 0); ++i) {
        const double at = std::clamp(1. * i / part.places, kInside, 1 - kInside);
        const double t = phase.duration * at;
        const double v = phase.speed(t);
        const double a = phase.acceleration(t);
        for (const PlaceLimit& limit : limits(phase.place(t))) {
            worst = std::max({worst, acceleration_of(limit, v, a) / limit.acceleration,
                              jerk_of(limit, v, a, phase.j) / limit.jerk});
        }
    }
    return worst;
}

double RunPath::speed_load(const Phase& phase, int places) const {
    double worst = 0;
    long double from = phase.s;
    std::size_t on = move_at(from);
    for (int i = 0; i <= places; ++i) {
        const double t = phase.duration * i / places;
        const long double s = phase.place(t);
        const double v = phase.speed(t);
        const std::size_t move = move_at(s - (s - from) * kInside);
        worst = std::max(worst, v / moves_[move].velocity);
        // Joints since the last place, as if the speed were constant between both.
        for (; on < move; ++on) {
            const double part = static_cast<double>((begin_[on + 1] - from) / (s - from));
            const double joint = phase.speed(t - (1 - part) * phase.duration / places);
            worst = std::max(worst, joint / moves_[on].end_velocity);
        }
        from = s;
    }
    return worst;
}

}  // namespace curvecore::ref
