// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/windows/window_rule.hpp"

#include <algorithm>
#include <cmath>

namespace curvecore::ref {
namespace {

constexpr double kSpare = 4 * kStraight;  // share of A T
constexpr double kFine = 1.2;             // ratio of lengths
constexpr double kLarge = 0.02;           // share of A T
constexpr int kPairs = 24;                // joints
constexpr std::size_t kJumpsAtOnce = 64;  // whose pairs one thread looks at
constexpr double kExponent = 0.6;  // power of the ratio that lowers speed: jumps go with v, bends
                                   // with v^3
constexpr double kLeastSpeedShare = 0.5;  // share of the speed: it is lowered by no more at once
constexpr double kSameTime = 1e-9;        // s

double square(const AxisVector& v, int axis) {
    if (axis >= 0) return v[static_cast<std::size_t>(axis)] * v[static_cast<std::size_t>(axis)];
    const double xyz = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    return xyz > 0 ? xyz : v[6] * v[6] + v[7] * v[7] + v[8] * v[8];
}

AxisVector combine(std::size_t axes, double p, const AxisVector& a, double q, const AxisVector& b) {
    AxisVector sum{};
    for (std::size_t i = 0; i < axes; ++i) sum[i] = p * a[i] + q * b[i];
    return sum;
}

/// Squares |b - a|^2 and |a - 2 b + c|^2 over all axes: at least those of any limit.
double change_square(std::size_t axes, const AxisVector& a, const AxisVector& b) {
    double sum = 0;
    for (std::size_t i = 0; i < axes; ++i) sum += (b[i] - a[i]) * (b[i] - a[i]);
    return sum;
}
double second_square(std::size_t axes, const AxisVector& a, const AxisVector& b,
                     const AxisVector& c) {
    double sum = 0;
    for (std::size_t i = 0; i < axes; ++i) {
        const double second = a[i] - 2 * b[i] + c[i];
        sum += second * second;
    }
    return sum;
}

}  // namespace

double longest_window(const Machine& machine) {
    double full = machine.acceleration / machine.jerk;  // time to full acceleration
    for (const AxisLimits& axis : machine.axis)
        full = std::max(full, axis.acceleration / axis.jerk);
    return 2 * full + machine.joint_time;
}

double window_reach(const Machine& machine) { return 4 * longest_window(machine); }

WindowRule::WindowRule(const Machine& machine, const VelocityCourse& course)
    : course_(course), joint_time_(machine.joint_time), longest_(longest_window(machine)) {
    // The tool's own windows are not looked at where the axes are joints.
    const bool joints = !is_trivial(machine.kinematics);
    if (!joints) limits_.push_back({machine.acceleration, machine.jerk, -1});
    for (std::size_t i = 0; i < course.axes(); ++i) {
        const AxisLimits& axis = machine.axis[i];
        const bool implied = !joints && i < 3 && axis.acceleration >= machine.acceleration &&
                             axis.jerk >= machine.jerk;
        if (!implied) limits_.push_back({axis.acceleration, axis.jerk, static_cast<int>(i)});
    }
    for (const Limit& limit : limits_) {
        weakest_.acceleration = std::min(weakest_.acceleration, limit.acceleration);
        weakest_.jerk = std::min(weakest_.jerk, limit.jerk);
        fine_ = std::max(fine_, 3 * std::sqrt(limit.acceleration / limit.jerk * joint_time_));
    }
}

std::vector<JointCap> joint_caps(const Machine& machine, VelocityCourse& course,
                                 const std::shared_ptr<Workers>& workers) {
    const auto& joints = course.all_joints();
    std::vector<JointCap> caps;
    for (std::size_t first = 0; first < joints.size();) {
        const std::size_t end = course.look_at(first, window_reach(machine));
        for (const JointCap& cap : WindowRule(machine, course).caps(workers)) {
            if (cap.s >= joints[first].s && cap.s <= joints[end - 1].s) caps.push_back(cap);
        }
        first = end;
    }
    return caps;
}

std::vector<JointCap> WindowRule::caps(const std::shared_ptr<Workers>& workers) {
    std::vector<double> lengths;
    for (double w = joint_time_; w < longest_; w *= w < fine_ ? kFine : 2) lengths.push_back(w);
    const std::vector<Jump> large = large_jumps();
    const std::size_t parts = (large.size() + kJumpsAtOnce - 1) / kJumpsAtOnce;
    std::vector<Found> found(lengths.size() + parts);
    each(workers, found.size(), [&](std::size_t i) {
        if (i < lengths.size()) {
            look_at_length(lengths[i], found[i]);
        } else {
            const std::size_t first = (i - lengths.size()) * kJumpsAtOnce;
            look_at_pairs(large, first, std::min(first + kJumpsAtOnce, large.size()), found[i]);
        }
    });
    Found all;
    for (const Found& some : found) all.insert(all.end(), some.begin(), some.end());
    look_at_jumps(all);
    std::vector<bool> linked(course_.joints().size(), false);
    const std::vector<double> speed = speeds(all, linked);
    std::vector<JointCap> caps;
    for (std::size_t i = 0; i < speed.size(); ++i) {
        if (speed[i] == 0) continue;
        const Knot& knot = course_.knots()[course_.joints()[i]];
        caps.push_back({knot.s, knot.t, speed[i], linked[i]});
    }
    return caps;
}

/// Worst ratio to the bound of a limit.
template <class Bound>
double WindowRule::ratio(const AxisVector& size, Bound bound) const {
    double worst = 0;
    for (const Limit& limit : limits_) {
        const double most = bound(limit);
        worst = std::max(worst, square(size, limit.axis) / (most * most));
    }
    return std::sqrt(worst);
}

double WindowRule::most_change(const Limit& limit, double w) const {
    return limit.acceleration * (w + (1 - kSpare) * joint_time_);
}

double WindowRule::most_second(const Limit& limit, double w) const {
    return limit.jerk * w * (w + joint_time_) + (1 - kSpare) * limit.acceleration * joint_time_;
}

/// Checks (a) for the window that begins at t.
void WindowRule::change(const AxisVector& from, const AxisVector& to, double t, double w,
                        Found& found) const {
    const double weakest = most_change(weakest_, w);
    if (change_square(course_.axes(), from, to) <= weakest * weakest) return;
    const AxisVector size = combine(course_.axes(), 1, to, -1, from);
    keep(t, t + w, ratio(size, [&](const Limit& limit) { return most_change(limit, w); }), found);
}

/// Checks (b) for the windows that begin at t.
void WindowRule::second(const AxisVector& a, const AxisVector& b, const AxisVector& c, double t,
                        double w, Found& found) const {
    const std::size_t axes = course_.axes();
    const double weakest = most_second(weakest_, w);
    if (second_square(axes, a, b, c) <= weakest * weakest) return;
    const AxisVector size = combine(axes, 1, combine(axes, 1, a, -2, b), 1, c);
    keep(t, t + 2 * w, ratio(size, [&](const Limit& limit) { return most_second(limit, w); }),
         found);
}

/// Lowers the speed of the joints of a window.
void WindowRule::keep(double from, double to, double ratio, Found& found) const {
    if (ratio <= 1) return;
    const auto& knots = course_.knots();
    const auto& joints = course_.joints();
    const auto earlier = [&](std::size_t joint, double t) { return knots[joint].t < t; };
    const auto first = std::lower_bound(joints.begin(), joints.end(), from - kSameTime, earlier);
    const auto end = std::lower_bound(first, joints.end(), to + kSameTime, earlier);
    if (first == end) return;
    // Speeds change little from joint to joint: a few of many suffice.
    double v = knots[*(end - 1)].v;
    const auto stride = (end - first) / 16 + 1;
    for (auto joint = first; end - joint > stride; joint += stride) {
        v = std::max(v, knots[*joint].v);
    }
    const double factor = std::max(kLeastSpeedShare, 0.99 * std::pow(ratio, -kExponent));
    found.push_back({static_cast<std::size_t>(first - joints.begin()),
                     static_cast<std::size_t>(end - joints.begin() - 1), v * factor});
}

/// Checks all windows of length w with a place at a knot and a joint within.
void WindowRule::look_at_length(double w, Found& found) const {
    const auto& knots = course_.knots();
    const auto& joints = course_.joints();
    std::array<std::size_t, 4> place{};
    std::size_t next = 0;  // joint
    for (const Knot& knot : knots) {
        const double t = knot.t;
        while (next < joints.size() && knots[joints[next]].t < t - 2 * w - kSameTime) ++next;
        if (next == joints.size()) return;
        if (knots[joints[next]].t > t + 2 * w + kSameTime) continue;
        const AxisVector a = course_.at(t - 2 * w, place[0]);
        const AxisVector b = course_.at(t - w, place[1]);
        const AxisVector d = course_.at(t + w, place[2]);
        const AxisVector e = course_.at(t + 2 * w, place[3]);
        for (const AxisVector* c : {&knot.before, &knot.after}) {
            if (c == &knot.after && !knot.joint) break;
            change(b, *c, t - w, w, found);
            change(*c, d, t, w, found);
            second(a, b, *c, t - 2 * w, w, found);
            second(b, *c, d, t - w, w, found);
            second(*c, d, e, t, w, found);
        }
    }
}

/// Returns the joints whose pairs are checked.
std::vector<WindowRule::Jump> WindowRule::large_jumps() const {
    const auto& knots = course_.knots();
    std::vector<Jump> large;
    for (const std::size_t joint : course_.joints()) {
        const Knot& knot = knots[joint];
        const std::size_t axes = course_.axes();
        const AxisVector jump = combine(axes, 1, knot.after, -1, knot.before);
        const double share =
            ratio(jump, [&](const Limit& limit) { return limit.acceleration * joint_time_; });
        if (share <= kLarge) continue;
        large.push_back({&knot, joint, combine(axes, 0.5, knot.before, 0.5, knot.after),
                         std::sqrt(change_square(axes, knot.before, knot.after)) / 2});
    }
    return large;
}

/// Checks the pairs that begin at these jumps.
void WindowRule::look_at_pairs(const std::vector<Jump>& large, std::size_t first, std::size_t end,
                               Found& found) const {
    std::size_t from = first;
    for (std::size_t i = first; i < end; ++i) {
        while (from < large.size() && large[from].knot->t - large[i].knot->t < joint_time_) ++from;
        Places places{large[i].index, large[i].index, large[i].index};
        for (std::size_t j = from; j < std::min(large.size(), from + kPairs); ++j) {
            if (large[j].knot->t - large[i].knot->t > 2 * longest_) break;
            look_at_pair(large[i], large[j], places, found);
        }
    }
}

/// Checks windows with two places at these joints, on either side of both jumps: first by the
/// jumps' middles, which are half a jump from both sides.
void WindowRule::look_at_pair(const Jump& first, const Jump& last, Places& places,
                              Found& found) const {
    const Knot& one = *first.knot;
    const Knot& two = *last.knot;
    const double w = two.t - one.t;
    const std::size_t axes = course_.axes();
    const AxisVector before = course_.at(one.t - w, places[0]);
    const AxisVector middle = course_.at(one.t + w / 2, places[1]);
    const AxisVector after = course_.at(two.t + w, places[2]);
    const auto kept = [](double square, double off, double most) {
        return most >= off && square <= (most - off) * (most - off);
    };
    const AxisVector& m = first.middle;
    const AxisVector& n = last.middle;
    const double p = first.half;
    const double q = last.half;
    const bool thirds = w >= 2 * joint_time_;
    if (kept(change_square(axes, m, n), p + q, most_change(weakest_, w)) &&
        kept(second_square(axes, before, m, n), 2 * p + q, most_second(weakest_, w)) &&
        kept(second_square(axes, m, n, after), p + 2 * q, most_second(weakest_, w)) &&
        (!thirds || kept(second_square(axes, m, middle, n), p + q, most_second(weakest_, w / 2)))) {
        return;
    }
    for (const AxisVector* a : {&one.before, &one.after}) {
        for (const AxisVector* b : {&two.before, &two.after}) {
            change(*a, *b, one.t, w, found);
            second(before, *a, *b, one.t - w, w, found);
            second(*a, *b, after, one.t, w, found);
            if (thirds) second(*a, middle, *b, one.t, w / 2, found);
        }
    }
}

/// Checks (c).
void WindowRule::look_at_jumps(Found& found) const {
    const auto& knots = course_.knots();
    const auto& joints = course_.joints();
    const auto add = [&](const AxisVector& sum, double sign, const Knot& knot) {
        const std::size_t axes = course_.axes();
        return combine(axes, 1, sum, sign, combine(axes, 1, knot.after, -1, knot.before));
    };
    AxisVector sum{};
    std::size_t first = 0;
    for (const std::size_t last : joints) {
        sum = add(sum, 1, knots[last]);
        for (; knots[last].t - knots[joints[first]].t > joint_time_; ++first) {
            sum = add(sum, -1, knots[joints[first]]);
        }
        keep(knots[joints[first]].t, knots[last].t,
             ratio(sum, [&](const Limit& limit) { return limit.acceleration * joint_time_; }),
             found);
    }
}

/// Returns for each joint the lowest speed that any violated window demands, 0 if none. Joints in
/// one window are marked as linked.
std::vector<double> WindowRule::speeds(Found& found, std::vector<bool>& linked) const {
    const auto& knots = course_.knots();
    const auto& joints = course_.joints();
    std::sort(found.begin(), found.end(),
              [](const Broken& a, const Broken& b) { return a.velocity < b.velocity; });
    std::vector<double> speed(joints.size(), 0);
    std::vector<std::size_t> next(joints.size() + 1);  // not yet settled
    for (std::size_t i = 0; i < next.size(); ++i) next[i] = i;
    const auto open = [&](std::size_t i) {
        while (next[i] != i) i = next[i] = next[next[i]];
        return i;
    };
    for (const Broken& window : found) {
        for (std::size_t i = open(window.first); i <= window.last; i = open(i)) {
            speed[i] = window.velocity;
            next[i] = i + 1;
            if (i > window.first) linked[i] = true;
            if (i < window.last) linked[i + 1] = true;
        }
    }
    // One speed holds within T: finer steps than windows would only be more pieces.
    for (std::size_t i = 0; i < joints.size();) {
        const double t = knots[joints[i]].t + joint_time_;
        double least = speed[i];
        std::size_t end = i + 1;
        for (; end < joints.size() && linked[end] && knots[joints[end]].t < t; ++end) {
            least = std::min(least, speed[end]);
        }
        for (; i < end; ++i) speed[i] = least;
    }
    return speed;
}

}  // namespace curvecore::ref
