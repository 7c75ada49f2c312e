// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/stops/stop_branch.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ref/format/path_words.hpp"
#include "ref/limits/limits.hpp"
#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {
namespace {

constexpr std::int64_t kOne = std::int64_t{1} << 32;  // rate 1
constexpr double kRateUnit = 0x1p-32;
constexpr double kLeastSteps = 24;          // least number of steps in a stop
constexpr double kShortestStepTime = 2e-3;  // s, shortest step in it
constexpr int kPlaces = 4;                  // places of a step where limits are checked
constexpr int kRounds = 8;                  // rounds of the search for such a step
constexpr int kFine = 64;                   // parts of the room: resolution of a change
constexpr int kLoose = 1000;                // parts of it that the end may leave unused
constexpr double kTriedShare = 0.9;         // share of the possible rest that is tried next
constexpr std::uint32_t kMostTicks = (1u << kStepTicksBits) - 1;  // longest step, ticks

/// A rate and its slope, 2^-32, at a tick of the profile.
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
    const double root = std::sqrt(d);
    const double by_a = 1 / a;
    room.low = std::max(room.low, change((-b - root) * by_a));
    room.high = std::min(room.high, change((-b + root) * by_a));
    return room.low <= room.high;
}

/// Time of the quickest stop along the path, s, by the limits of its first place alone.
double least_time(const PieceMotion& m, const PlaceLimits& limits) {
    double acceleration = kUnlimitedChange;
    double jerk = kUnlimitedChange;
    for (const PlaceLimit& limit : limits) {
        const double rate = std::sqrt(limit.d11);
        if (rate == 0) continue;
        acceleration = std::min(acceleration, limit.acceleration / rate);
        jerk = std::min(jerk, limit.jerk / rate);
    }
    const double rise = std::max(0.0, m.a) / jerk;  // until it brakes
    const double v = m.v + m.a / 2 * rise;
    const double ramp = acceleration / jerk;
    return rise + (v > acceleration * ramp ? v / acceleration + ramp : 2 * std::sqrt(v / jerk));
}

/// The end of a stop, in which the slope returns to 0.
struct Release {
    std::int64_t rate;   // rate that is left then
    std::int64_t ticks;  // ticks until then
};

class StopLaw {
  public:
    explicit StopLaw(const ProfileCourse& course)
        : course_(course), cells_(course.cells()), tick_s_(course.tick_s()) {}

    StopSteps run(std::uint64_t tick) {
        StopSteps steps;
        at_.tick = static_cast<double>(tick);
        find_cell(at_);
        ticks_ = longest_step();
        const auto n = static_cast<double>(ticks_);
        most_ = std::min(0x1p31 - 1, 0x1p32 / n / n);
        const double end = at_.tick + static_cast<double>(stop_reach(course_.machine(), tick_s_));
        for (int count = 0; at_.rate != 0 || at_.slope != 0; ++count) {
            if (count == kStopSteps || at_.tick > end) return {};
            while (at_.slope == 0 && at_.rate < ticks_ * ticks_) ticks_ /= 2;
            const std::int64_t change = choose();
            const auto ticks = static_cast<std::uint32_t>(ticks_);
            at_ = after(at_, change, ticks_);
            if (!steps.empty() && steps.back().change == change &&
                steps.back().ticks + ticks <= kMostTicks) {
                steps.back().ticks += ticks;
            } else {
                steps.push_back({ticks, static_cast<std::int32_t>(change)});
            }
        }
        return steps;
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

    /// Longest step, ticks, a power of two.
    std::int64_t longest_step() const {
        double time = kShortestStepTime;
        if (!cells_.empty()) {
            const CourseCell& cell = cells_[at_.cell];
            const PieceMotion m = course_.motion(cell, std::clamp(at_.tick, cell.from, cell.to));
            time = std::max(time, least_time(m, cell.begin) / kLeastSteps);
        }
        std::int64_t ticks = 1;
        while (static_cast<double>(2 * ticks) * tick_s_ <= time && 2 * ticks <= kMostTicks) {
            ticks *= 2;
        }
        return ticks;
    }

    Scaled after(Scaled at, std::int64_t change, std::int64_t n) const {
        const std::int64_t pairs = n * (n + 1) / 2;
        const std::int64_t triples = pairs * (n + 2) / 3;
        at.tick +=
            static_cast<double>(at.rate * n + at.slope * pairs + change * triples) * kRateUnit;
        at.rate += at.slope * n + change * pairs;
        at.slope += change * n;
        while (at.cell + 1 < cells_.size() && cells_[at.cell + 1].from <= at.tick) ++at.cell;
        return at;
    }

    /// Cuts the rooms to what acceleration and jerk leave at one place of a step, n ticks after its
    /// start at slope `slope`.
    bool cut(const Scaled& at, std::int64_t slope, std::int64_t n, Room& by_acceleration,
             Room& by_jerk) const {
        if (cells_.empty()) return true;
        const CourseCell& cell = cells_[at.cell];
        if (at.tick < cell.from || at.tick >= cell.to) return true;
        const PieceMotion m = course_.motion(cell, at.tick);
        if (m.v <= 0) return true;
        const double r = static_cast<double>(at.rate) * kRateUnit;
        const double p = static_cast<double>(at.slope) * kRateUnit / tick_s_;
        const double v = r * m.v;
        const double q = v * v;
        const double x = v * q;
        const double even = r * r * m.a;  // alpha without a slope
        const double y = v * (even + p * m.v);
        const double own = r * (r * r * m.j + 3 * p * m.a);  // u without a change
        const double per_speed = tick_s_ / (m.v * kRateUnit);
        const double per_jerk = per_speed * tick_s_;
        const double per_tick = n > 0 ? 1 / static_cast<double>(n) : 0;
        const auto from_alpha = [&](double alpha) {
            return ((alpha - even) * per_speed - static_cast<double>(slope)) * per_tick;
        };
        const auto from_jerk = [&](double u) { return (u - own) * per_jerk; };
        const double part = (at.tick - cell.from) / (cell.to - cell.from);
        const auto mix = [part](double from, double to) { return from + (to - from) * part; };
        for (std::size_t i = 0; i < cell.begin.size(); ++i) {
            const PlaceLimit& b = cell.begin[i];
            const PlaceLimit& e = cell.end[i];
            const double d11 = mix(b.d11, e.d11);
            const double d12 = mix(b.d12, e.d12);
            const double d22 = mix(b.d22, e.d22);
            // |r' alpha + r'' q| <= A
            if (n > 0) {
                const double most = mix(b.acceleration, e.acceleration);
                const double rest = d22 * q * q - most * most;
                if (!cut_square(d11, d12 * q, rest, from_alpha, by_acceleration)) return false;
            }
            // |r' u + 3 r'' V alpha + r''' V^3| <= J
            const double most = mix(b.jerk, e.jerk);
            const double rest = mix(b.d33, e.d33) * x * x + 9 * d22 * y * y +
                                6 * mix(b.d23, e.d23) * x * y - most * most;
            const double mean = 3 * d12 * y + mix(b.d13, e.d13) * x;
            if (!cut_square(d11, mean, rest, from_jerk, by_jerk)) return false;
        }
        return true;
    }

    /// Finds the room that jerk leaves at the start of a step that follows none.
    bool find_start(const Scaled& from, Room& start) const {
        start = {-most_, most_};
        return cut(from, from.slope, 0, start, start);
    }

    /// Narrows that to changes that do not go below the rate 0.
    bool find_room(const Scaled& from, const Room& start, Room& room) const {
        const auto rest = static_cast<double>(from.rate + from.slope * ticks_);
        const auto n = static_cast<double>(ticks_);
        room = {std::max(start.low, -2 * rest / (n * (n + 1))), start.high};
        return room.low <= room.high;
    }

    /// Narrows `room` to what the limits leave all through a step with this change, and finds the
    /// room of the next step.
    bool narrow(const Scaled& from, std::int64_t change, Room& room, Room& next) const {
        for (int i = 1; i < kPlaces; ++i) {
            const std::int64_t n = std::max<std::int64_t>(1, ticks_ * i / kPlaces);
            if (!cut(after(from, change, n), from.slope, n, room, room)) return false;
        }
        next = {-most_, most_};
        if (!cut(after(from, change, ticks_), from.slope, ticks_, room, next)) return false;
        room = {std::max(room.low, next.low), std::min(room.high, next.high)};
        return room.low <= room.high;
    }

    bool keeps(const Scaled& from, Room room, std::int64_t change, Room& next) const {
        const auto value = static_cast<double>(change);
        return narrow(from, change, room, next) && room.low <= value && value <= room.high;
    }

    /// Moves `change` into the room that it leaves itself, or towards `other` if it leaves none.
    bool settle(const Scaled& from, const Room& room, std::int64_t other, std::int64_t& change,
                Room& next) const {
        for (int round = 0; round < kRounds; ++round) {
            const auto value = static_cast<double>(change);
            Room left = room;
            if (!narrow(from, change, left, next)) {
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

    /// Finds the change that returns the slope to 0 fastest; `start` becomes the next step's.
    bool release(const Scaled& at, Room& start, std::int64_t& change) const {
        Room room;
        if (!find_room(at, start, room)) return false;
        const std::int64_t most = -at.slope / ticks_;
        change = std::min(static_cast<std::int64_t>(std::floor(room.high)), most);
        return settle(at, room, static_cast<std::int64_t>(std::ceil(room.low)), change, start) &&
               change <= most;
    }

    /// Returns the remaining rate, and the time, when the slope is back at 0 after a step with this
    /// change; none if it cannot be before the rate is 0.
    std::optional<Release> released(const Room& room, std::int64_t change) const {
        Room start;
        if (!keeps(at_, room, change, start)) return {};
        Scaled at = after(at_, change, ticks_);
        if (at.slope > 0) return {};
        std::int64_t ticks = 0;
        for (; at.slope < 0; ticks += ticks_) {
            if (!release(at, start, change)) return {};
            at = after(at, change, ticks_);
        }
        if (at.rate < 0) return {};
        return Release{at.rate, ticks};
    }

    /// Greatest reduction of a step's change with which the rate ends at 0 and not below: the slope
    /// stays lower all through the release, and longer.
    double reach(const Release& after) const {
        const auto n = static_cast<double>(ticks_);
        return static_cast<double>(after.rate) /
               (n * (n + 1) / 2 + n * static_cast<double>(after.ticks));
    }

    std::int64_t choose() {
        std::int64_t good = 0;
        Room start;
        const bool any = find_start(at_, start);
        Room next = start;
        if (any && at_.slope < 0) release(at_, next, good);  // rolled out before, so it can
        left_.ticks = std::max<std::int64_t>(0, left_.ticks - ticks_);
        Room room;
        if (!any || !find_room(at_, start, room)) return good;
        auto bad = static_cast<std::int64_t>(std::ceil(room.low));
        settle(at_, room, good, bad, next);
        if (bad >= good) return good;
        const auto room_left = static_cast<double>(good - bad);
        const double fine = std::max(1.0, room_left / kFine);
        const double loose = room_left / kLoose;
        const auto try_change = [&](std::int64_t change) {
            const std::optional<Release> found = released(room, change);
            if (found) left_ = *found;
            (found ? good : bad) = change;
            return found.has_value();
        };
        if (room_left <= reach(left_) && try_change(bad)) return good;
        while (static_cast<double>(good - bad) > fine && reach(left_) > loose) {
            const double more =
                std::min(kTriedShare * reach(left_), static_cast<double>(good - bad) / 2);
            try_change(good - static_cast<std::int64_t>(std::ceil(more)));
        }
        return good;
    }

    const ProfileCourse& course_;
    const std::deque<CourseCell>& cells_;
    double tick_s_;
    double most_ = 0;  // largest change
    Scaled at_;
    std::int64_t ticks_ = 1;
    Release left_{kOne, 0};  // with the steps so far
};

}  // namespace

std::uint64_t ticks_of(const StopSteps& steps) {
    std::uint64_t sum = 0;
    for (const StopStep& step : steps) sum += step.ticks;
    return sum;
}

StopSteps stop_steps(const ProfileCourse& course, std::uint64_t tick) {
    return StopLaw(course).run(tick);
}

std::uint64_t stop_reach(const Machine& machine, double tick_s) {
    constexpr double kTimesSlowest = 4;  // times that of the slowest axis
    double time = machine.velocity / machine.acceleration + machine.acceleration / machine.jerk;
    for (const AxisLimits& axis : machine.axis) {
        time = std::max(time, axis.velocity / axis.acceleration + axis.acceleration / axis.jerk);
    }
    return static_cast<std::uint64_t>(std::ceil(kTimesSlowest * time / tick_s));
}

}  // namespace curvecore::ref
