// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/feed_window.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/windows/window_rule.hpp"
#include "ref/limits/limits.hpp"

namespace curvecore::ref {
namespace {

constexpr int kRounds = 50;    // rounds of solving; some five are seen
constexpr int kCutRounds = 5;  // rounds of making a cut
// Share by which the speed at a cut is lowered, off its limits; four times more if that was not
// enough.
constexpr double kSlower = 0.01;
constexpr double kSameSpeedRatio = 1 + 1e-9;  // ratio of speeds

}  // namespace

FeedWindow::FeedWindow(const FeedTask& task, const std::vector<Slowed>& slowed, std::size_t cut)
    : task_(task),
      cut_(cut),
      solver_(task, slowed),
      stretches_(solver_.cut_at_stops()),
      open_(given_moves(task.given)) {
    for (std::size_t i = 0; i < open_; ++i) given_end_ += task.geometry.moves[i].length;
}

bool FeedWindow::solve() {
    for (Stretch& stretch : stretches_) {
        if (!solve(stretch)) return false;
    }
    return keep_windows();
}

bool FeedWindow::cut_before(std::size_t cut) {
    cut_ = cut;
    for (Stretch& stretch : stretches_) {
        stretch.changed = cut >= stretch.first && cut <= stretch.last;
        if (stretch.changed && !solve(stretch)) return false;
    }
    return keep_windows();
}

bool FeedWindow::solve(Stretch& stretch) {
    if (!solver_.solve_by_rules(stretch) || !pass_cut(stretch)) return false;
    if (task_.options.effort == Effort::kOptimum) {
        solver_.improve(stretch, cut_ > 0 ? cut_ : task_.geometry.moves.size());
    }
    return true;
}

/// Lowers the speed at the cut until it passes: no acceleration where a joint's own limit is met.
bool FeedWindow::pass_cut(Stretch& stretch) {
    if (cut_ <= stretch.open() || cut_ > stretch.last) return true;
    const long double place = place_of(task_.geometry, stretch, cut_, solver_.grid());
    const std::size_t joint = stretch.joint_before(cut_);
    double slower = kSlower;
    for (int round = 0; round < kCutRounds; ++round, slower *= 4) {
        const Phase after = part_of(stretch.phases, place, kEnd).front();
        if (after.a == 0 && after.v <= stretch.caps[joint] * kSameSpeedRatio) return true;
        stretch.cap(joint, std::max(1 - slower, kSlower) * after.v);
        if (!solver_.solve_by_rules(stretch)) return false;
    }
    return false;
}

/// Solves again, slower, where limits over windows are violated.
bool FeedWindow::keep_windows() {
    const std::vector<Segment>& segments = task_.geometry.segments;
    double given = 0;  // s
    for (const Stretch& stretch : stretches_) {
        if (stretch.given.moves > 0) given += stretch.dwell + duration(stretch.given.phases);
    }
    // Windows that see what is not given must keep them; what others see was checked before.
    const double seen = given - window_reach(task_.machine);
    for (int round = 0; round < kRounds; ++round) {
        look_near_changes();
        VelocityCourse course(segments, task_.options.unit_mm, 3 + task_.program.aux_axes,
                              task_.machine);
        std::size_t segment = 0;
        for (const Stretch& stretch : stretches_) {
            const std::size_t first = segment;
            while (segment < segments.size() && segments[segment].s_start < stretch.end) ++segment;
            course.rest(stretch.dwell);
            if (stretch.looked_at) {
                course.run(stretch.phases, first, segment - 1);
            } else {
                course.rest(duration(stretch.phases));
            }
        }
        const std::vector<JointCap> caps = joint_caps(task_.machine, course, task_.options.workers);
        auto cap = caps.begin();
        for (; cap != caps.end() && open_ > 0 && cap->s <= given_end_; ++cap) {
            if (cap->t > seen) return false;
        }
        if (cap == caps.end()) return true;
        for (Stretch& stretch : stretches_) {
            const auto first = cap;
            while (cap != caps.end() && cap->s < stretch.end) ++cap;
            stretch.changed = first != cap;
            if (!stretch.changed) continue;
            lower(stretch, first, cap);
            if (!solve(stretch)) return false;
        }
    }
    return true;
}

/// Marks the stretches that share a window with a part of a changed one.
void FeedWindow::look_near_changes() {
    const double reach = 2 * longest_window(task_.machine);
    const auto look = [&](auto begin, auto end) {
        double time = 2 * reach;  // s, since the last change
        for (auto stretch = begin; stretch != end; ++stretch) {
            if (stretch->changed) time = 0;
            stretch->looked_at = stretch->looked_at || time <= reach;
            if (!stretch->changed) time += duration(stretch->phases);
        }
    };
    for (Stretch& stretch : stretches_) stretch.looked_at = false;
    look(stretches_.begin(), stretches_.end());
    look(stretches_.rbegin(), stretches_.rend());
}

template <class Cap>
void FeedWindow::lower(Stretch& stretch, Cap cap, Cap end) const {
    std::uint64_t s = stretch.start;
    std::size_t after = 0;  // the last cap's joint
    for (std::size_t i = stretch.first; i < stretch.last && cap != end; ++i) {
        s += task_.geometry.moves[i].length;
        if (s != cap->s) continue;
        const std::size_t joint = stretch.joint_before(i + 1);
        stretch.cap(joint, cap->velocity);
        for (std::size_t zone = after; cap->linked && zone != 0 && zone < joint; ++zone) {
            stretch.cap(zone, std::max(cap->velocity, stretch.zones[after].velocity));
        }
        after = joint;
        ++cap;
    }
}

WindowMotion FeedWindow::slower_motion(double factor) const {
    std::vector<Stretch> stretches = stretches_;
    for (Stretch& stretch : stretches) {
        for (Phase& phase : stretch.phases) phase = phase.slower(factor);
    }
    return {std::move(stretches), task_.geometry, solver_.grid(), solver_.last_dwell()};
}

WindowMotion FeedWindow::motion() const {
    return {stretches_, task_.geometry, solver_.grid(), solver_.last_dwell()};
}

}  // namespace curvecore::ref
