// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/stop_branch.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/limits.hpp"

namespace curvecore::ref {
namespace {

constexpr std::int64_t kOne = std::int64_t{1} << 32;  // of the rate
constexpr double kRampSteps = 25;                     // in the time to full acceleration, at most
constexpr double kBrakeSteps = 100;                   // in that from full speed
constexpr int kPlaces = 4;                            // of a step, where limits are looked at
constexpr int kRounds = 8;                            // of looking for such a step
constexpr int kLoose = 1000;  // of the room: what a stop that ends already may leave unused

/// A rate and its slope, 2^-32, at a time of the profile.
struct Scaled {
    double tick = 0;
    std::int64_t rate = kOne;
    std::int64_t slope = 0;
    std::size_t cell = 0;
};

/// Changes, r'' in 2^-32 per tick^2, that keep the limits.
struct Room {
    double low, high;
};

/// Cuts `room` to where a x^2 + 2 b x + c <= 0, as changes.
template <class Change>
bool cut_square(double a, double b, double c, Change change, Room& room) {
    const double d = b * b - a * c;
    if (d < 0) return false;
    if (a == 0) return true;
    room.low = std::max(room.low, change((-b - std::sqrt(d)) / a));
    room.high = std::min(room.high, change((-b + std::sqrt(d)) / a));
    return room.low <= room.high;
}

std::int64_t step_ticks(const Machine& machine, double tick_s) {
    double brake = machine.velocity / machine.acceleration;
    for (const AxisLimits& axis : machine.axis) {
        brake = std::min(brake, axis.velocity / axis.acceleration);
    }
    const double time = std::max(ramp_time(machine) / kRampSteps, brake / kBrakeSteps);
    std::int64_t ticks = 1;
    while (static_cast<double>(2 * ticks) * tick_s <= time) ticks *= 2;
    return ticks;
}

class StopLaw {
  public:
    explicit StopLaw(const ProfileCourse& course)
        : course_(course),
          cells_(course.cells()),
          tick_s_(course.tick_s()),
          longest_(step_ticks(course.machine(), tick_s_)) {
        most_ = std::min<double>(0x1p31 - 1, std::ldexp(1.0, 32) / longest_ / longest_);
    }

    StopBranch run(std::uint64_t tick) {
        StopBranch branch;
        branch.tick = tick;
        at_.tick = static_cast<double>(tick);
        find_cell(at_);
        ticks_ = longest_;
        for (std::size_t count = 0; at_.rate != 0 || at_.slope != 0; ++count) {
            if (count == kMostStopSteps) return {};
            while (at_.slope == 0 && at_.rate < ticks_ * ticks_) ticks_ /= 2;
            const std::int64_t change = choose();
            const auto ticks = static_cast<std::uint32_t>(ticks_);
            at_ = after(at_, change, ticks_);
            if (branch.steps.empty() && change == 0) {
                branch.tick += ticks;
            } else if (!branch.steps.empty() && branch.steps.back().change == change) {
                branch.steps.back().ticks += ticks;
            } else {
                branch.steps.push_back({ticks, static_cast<std::int32_t>(change)});
            }
        }
        return branch;
    }

  private:
    void find_cell(Scaled& at) const {
        const auto begins_after = [](double tick, const CourseCell& cell) {
            return tick < cell.from;
        };
        const auto next = std::upper_bound(cells_.begin(), cells_.end(), at.tick, begins_after);
        at.cell = static_cast<std::size_t>(next - cells_.begin());
        if (at.cell > 0) --at.cell;
    }

    Scaled after(Scaled at, std::int64_t change, std::int64_t n) const {
        const std::int64_t pairs = n * (n + 1) / 2;
        const std::int64_t triples = pairs * (n + 2) / 3;
        at.tick +=
            std::ldexp(static_cast<double>(at.rate * n + at.slope * pairs + change * triples), -32);
        at.rate += at.slope * n + change * pairs;
        at.slope += change * n;
        while (at.cell + 1 < cells_.size() && cells_[at.cell + 1].from <= at.tick) ++at.cell;
        return at;
    }

    struct Here {
        double v, a, j;
        double r, p;
    };

    /// Calls see(limit) for each limit at a place; none at rest.
    template <class See>
    bool each_limit(const Scaled& at, Here& here, See see) const {
        if (cells_.empty()) return true;
        const CourseCell& cell = cells_[at.cell];
        if (at.tick < cell.from || at.tick >= cell.to) return true;
        const PieceMotion m = course_.motion(cell, at.tick);
        here = {m.v, m.a, m.j, std::ldexp(static_cast<double>(at.rate), -32),
                std::ldexp(static_cast<double>(at.slope), -32) / tick_s_};
        const double x = (at.tick - cell.from) / (cell.to - cell.from);
        for (std::size_t i = 0; i < cell.begin.size(); ++i) {
            const PlaceLimit& b = cell.begin[i];
            const PlaceLimit& e = cell.end[i];
            const auto mix = [x](double from, double to) { return from + (to - from) * x; };
            const PlaceLimit limit{mix(b.d11, e.d11),
                                   mix(b.d12, e.d12),
                                   mix(b.d13, e.d13),
                                   mix(b.d22, e.d22),
                                   mix(b.d23, e.d23),
                                   mix(b.d33, e.d33),
                                   mix(b.acceleration, e.acceleration),
                                   mix(b.jerk, e.jerk)};
            if (!see(limit)) return false;
        }
        return true;
    }

    /// Cuts `room` to what one place of a step leaves, n ticks after its start at slope `slope`.
    bool cut(const Scaled& at, std::int64_t slope, std::int64_t n, Room& room) const {
        Here h{};
        return each_limit(at, h, [&](const PlaceLimit& l) {
            if (h.v <= 0) return true;
            const double v = h.r * h.v;
            const double q = v * v;
            // |r' alpha + r'' q| <= A
            const double square = l.d22 * q * q - l.acceleration * l.acceleration;
            const auto from_alpha = [&](double alpha) {
                const double p = (alpha - h.r * h.r * h.a) / h.v * tick_s_;
                return (std::ldexp(p, 32) - static_cast<double>(slope)) / static_cast<double>(n);
            };
            if (n > 0 && !cut_square(l.d11, l.d12 * q, square, from_alpha, room)) return false;
            // |r' u + 3 r'' V alpha + r''' V^3| <= J
            const double x = v * q;
            const double y = v * (h.r * h.r * h.a + h.p * h.v);
            const double rest =
                l.d33 * x * x + 9 * l.d22 * y * y + 6 * l.d23 * x * y - l.jerk * l.jerk;
            const auto from_jerk = [&](double u) {
                const double own = h.r * h.r * h.r * h.j + 3 * h.r * h.p * h.a;
                return std::ldexp((u - own) / h.v * tick_s_ * tick_s_, 32);
            };
            return cut_square(l.d11, 3 * l.d12 * y + l.d13 * x, rest, from_jerk, room);
        });
    }

    /// What the limits leave as the step begins.
    bool find_room(const Scaled& from, Room& room) const {
        const auto rest = static_cast<double>(from.rate + from.slope * ticks_);
        const auto n = static_cast<double>(ticks_);
        room = {std::max(-most_, -2 * rest / (n * (n + 1))), most_};  // not below the rate 0
        return cut(from, from.slope, 0, room);
    }

    /// What they leave all through the step if it has this change.
    bool narrow(const Scaled& from, std::int64_t change, Room& room) const {
        for (int i = 1; i <= kPlaces; ++i) {
            const std::int64_t n = std::max<std::int64_t>(1, ticks_ * i / kPlaces);
            if (!cut(after(from, change, n), from.slope, n, room)) return false;
        }
        return room.low <= room.high;
    }

    bool keeps(const Scaled& from, std::int64_t change) const {
        const auto value = static_cast<double>(change);
        Room room;
        return find_room(from, room) && narrow(from, change, room) && room.low <= value &&
               value <= room.high;
    }

    /// Moves `change` into the room that it leaves itself; where it leaves none, towards `other`.
    bool settle(const Scaled& from, const Room& room, std::int64_t other,
                std::int64_t& change) const {
        for (int round = 0; round < kRounds; ++round) {
            const auto value = static_cast<double>(change);
            Room left = room;
            if (!narrow(from, change, left)) {
                change = (change + other) / 2;
            } else if (value < left.low) {
                change = static_cast<std::int64_t>(std::ceil(left.low));
            } else if (value > left.high) {
                change = static_cast<std::int64_t>(std::floor(left.high));
            } else {
                return true;
            }
        }
        return false;
    }

    /// The change that brings the slope back to 0 the quickest.
    bool release(const Scaled& at, std::int64_t& change) const {
        Room room;
        if (!find_room(at, room)) return false;
        const std::int64_t most = -at.slope / ticks_;
        change = std::min(static_cast<std::int64_t>(std::floor(room.high)), most);
        return settle(at, room, static_cast<std::int64_t>(std::ceil(room.low)), change) &&
               change <= most;
    }

    /// The slope can come back to 0, before the rate does, after a step with this change.
    bool safe(std::int64_t change) const {
        if (!keeps(at_, change)) return false;
        Scaled at = after(at_, change, ticks_);
        if (at.slope > 0) return false;
        while (at.slope < 0) {
            if (!release(at, change)) return false;
            at = after(at, change, ticks_);
        }
        return at.rate >= 0;
    }

    std::int64_t choose() {
        std::int64_t good = 0;
        if (at_.slope < 0) release(at_, good);  // as it was rolled out: it can
        Room room;
        find_room(at_, room);
        auto bad = static_cast<std::int64_t>(std::ceil(room.low));
        settle(at_, room, good, bad);
        if (bad >= good) return good;
        if (safe(bad)) {
            ending_ = false;
            return bad;
        }
        const std::int64_t near = good - (good - bad) / kLoose - 1;
        if (ending_ && at_.slope < 0 && !safe(near)) return good;
        while (good - bad > 1) {
            const std::int64_t middle = bad + (good - bad) / 2;
            (safe(middle) ? good : bad) = middle;
        }
        ending_ = true;
        return good;
    }

    const ProfileCourse& course_;
    const std::deque<CourseCell>& cells_;
    double tick_s_;
    std::int64_t longest_;  // ticks of a step
    double most_;           // of a change
    Scaled at_;
    std::int64_t ticks_ = 1;
    bool ending_ = false;
};

}  // namespace

std::uint64_t StopBranch::ticks() const {
    std::uint64_t sum = 0;
    for (const StopStep& step : steps) sum += step.ticks;
    return sum;
}

StopBranch stop_branch(const ProfileCourse& course, std::uint64_t tick) {
    return StopLaw(course).run(tick);
}

std::uint64_t stop_reach(const Machine& machine, double tick_s) {
    return 2 * kMostStopSteps * static_cast<std::uint64_t>(step_ticks(machine, tick_s));
}

std::vector<StopBranch> stop_branches(const Program& program, const Machine& machine,
                                      const Geometry& geometry, const Plan& plan,
                                      std::uint64_t every) {
    std::vector<StopBranch> branches;
    ProfileCourse course(program, machine, geometry, plan, kStopShare);
    const double reach = static_cast<double>(stop_reach(machine, plan.tick_s));
    std::uint64_t next = 0;
    const auto add_until = [&](double end) {
        for (; static_cast<double>(next) < end; next += every) {
            course.forget_before(static_cast<double>(next));
            StopBranch branch = stop_branch(course, next);
            if (!branch.steps.empty()) branches.push_back(std::move(branch));
        }
    };
    const PieceGrid grid(machine, plan.unit_mm, plan.tick_s);
    walk_pieces(plan, geometry, grid, [&](const PieceStretch& stretch) {
        course.add(stretch);
        add_until(course.cells().back().from - reach);
    });
    if (!course.cells().empty()) add_until(course.cells().back().to);
    return branches;
}

}  // namespace curvecore::ref
