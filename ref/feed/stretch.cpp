// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/stretch.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/pieces/phase_ends.hpp"
#include "ref/feed/pieces/piece_loads.hpp"
#include "ref/feed/places/step_speed.hpp"
#include "ref/feed/ramps/ramp.hpp"
#include "ref/feed/stops/planned_branches.hpp"
#include "ref/limits/limits.hpp"
#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {
namespace {

constexpr double kJointShare = 0.99;  // the same share at joints
// Resolution of a ramp by the shortest piece: this many pieces up to full acceleration, and this
// share of the speed gained within one.
constexpr double kRampPieces = 4;
constexpr double kSpeedPieces = 100;
constexpr double kCarried = 1.045;       // ratio to a share: rounding to ticks may add this
constexpr double kUnseen = 0.005;        // mean of that over the joint time: less than a tick
constexpr double kSpeedCarried = 1.001;  // the same for velocities
constexpr double kWorth = 0.01;          // share of the time that an optimum must be able to gain
constexpr double kRampTime = 0.05;       // s, ramp to full acceleration to which kKnots belongs
constexpr double kKnots = 16;            // knots in it
constexpr double kSlowApart = 2;         // steps between knots where an axis bounds the speed
constexpr double kSameSpeed = 1e-9;      // relative

/// Factor by which knots may be spread where the speed is constant.
double knots_apart(const Move& move) {
    if (move.kind == Move::Kind::kArc) return 4;
    return move.kind == Move::Kind::kLine ? kUnlimited : 2;
}

/// Returns true if no jump is needed: a jump passes zones that no motion from the given speed can
/// pass.
bool is_smooth(const std::vector<Phase>& phases) {
    for (std::size_t i = 0; i + 1 < phases.size(); ++i) {
        const double v = phases[i].speed(phases[i].duration);
        if (std::abs(phases[i + 1].v - v) > kAtRest + kSameSpeed * v) return false;
    }
    return true;
}

}  // namespace

/// Step of knots. A ramp half as long has knots 0.8 times as far apart: looser limits are planned
/// with more knots, but not in proportion.
double knot_step(const PathShape& shape, const Machine& machine) {
    const double step = kRampTime / kKnots * std::cbrt(ramp_time(shape, machine) / kRampTime);
    return std::max(step, machine.joint_time);
}

long double place_of(const Geometry& geometry, const Stretch& stretch, std::size_t move,
                     const PieceGrid& grid) {
    if (move > stretch.last) return kEnd;
    long double place = 0;
    for (std::size_t i = stretch.first; i < move; ++i) place += length_of(geometry.moves[i], grid);
    return place;
}

StretchSolver::StretchSolver(const FeedTask& task, const std::vector<Slowed>& slowed)
    : task_(task),
      places_(task.program, task.geometry, task.options.unit_mm),
      grid_(task.machine, task.options.unit_mm, task.options.tick_s()),
      step_speed_(step_speeds(task.geometry.segments, task.geometry.moves, task.options)),
      slowed_(slowed) {
    if (task.options.has_branches()) grid_.longest = longest_piece(grid_);
}

/// The limits at the ends of the moves from `first` up to `last` (not included).
StretchSolver::Rest StretchSolver::rest(std::size_t first, std::size_t last) const {
    Rest all;
    for (std::size_t i = first; i < last; ++i) {
        const Move& move = task_.program.moves[i];
        all.stop = all.stop || move.exact_stop || move.dwell > 0;
        all.dwell += std::max(0.0, move.dwell);
    }
    return all;
}

std::vector<Stretch> StretchSolver::cut_at_stops() {
    const std::vector<GivenRun>& given = task_.given;
    std::vector<Stretch> stretches;
    std::size_t next = 0;  // move of the program
    std::uint64_t s = 0;
    for (std::size_t i = 0; i < task_.geometry.moves.size(); ++i) {
        const PlannedMove& planned = task_.geometry.moves[i];
        const Rest before = rest(next, planned.move);
        joint_speed_.push_back(0);
        if (i > 0) {
            const PlannedMove& last = task_.geometry.moves[i - 1];
            const bool stop = before.stop || last.stop_after || planned.stop_before;
            if (!stop) joint_speed_[i] = joint_velocity(last.shape, planned.shape, task_.machine);
        }
        if (joint_speed_[i] == 0) {
            Stretch stretch;
            stretch.dwell = before.dwell;
            stretch.first = i;
            stretch.start = s;
            stretches.push_back(stretch);
        }
        s += planned.length;
        stretches.back().last = i;
        stretches.back().end = s;
        next = planned.move;
    }
    last_dwell_ = rest(next, task_.program.moves.size()).dwell;
    for (std::size_t i = 0; i < given.size(); ++i) stretches[i].given = given[i];
    if (!given.empty()) stretches.front().dwell = 0;
    for (Stretch& stretch : stretches) set_zones(stretch);
    return stretches;
}

void StretchSolver::set_zones(Stretch& stretch) const {
    for (std::size_t i = stretch.first; i <= stretch.last; ++i) {
        if (i > stretch.first) {
            stretch.zones.push_back(
                {0, kJointShare * joint_speed_[i], kUnlimitedChange, kUnlimitedChange});
        }
        stretch.zones.push_back(zone(i));
    }
    if (!one_line(stretch)) {
        for (Zone& zone : stretch.zones) {
            zone.velocity *= task_.pace;
            zone.acceleration *= task_.pace * task_.pace;
            zone.jerk *= task_.pace * task_.pace * task_.pace;
        }
    }
    stretch.caps.assign(stretch.zones.size(), kUnlimitedSpeed);
    if (stretch.given.moves == 0 || stretch.is_given()) return;
    // A motion from rest has the end speed of the given motion before that begins.
    const double v = end_speed(stretch.given.phases);
    double acceleration = kUnlimitedChange;
    double jerk = kUnlimitedChange;
    for (const Zone& zone : stretch.zones) {
        acceleration = std::min(acceleration, zone.acceleration);
        jerk = std::min(jerk, zone.jerk);
    }
    stretch.lead = 2 * Ramp(0, v, acceleration, jerk).length();
    for (std::size_t k = 0; k < stretch.joint_before(stretch.open()); ++k) {
        stretch.zones[k] = {stretch.zones[k].length, v, kUnlimitedChange, kUnlimitedChange};
    }
    stretch.zones.front().length += stretch.lead;
}

bool StretchSolver::solve_by_rules(Stretch& stretch) const {
    if (stretch.is_given()) {
        stretch.phases = stretch.given.phases;
        return true;
    }
    stretch.phases = ramps_over(stretch.zones);
    if (stretch.given.moves == 0) return true;
    const long double begin = place_of(task_.geometry, stretch, stretch.open(), grid_);
    const std::vector<Phase> own = part_of(stretch.phases, stretch.lead + begin, kEnd);
    const double v = end_speed(stretch.given.phases);
    stretch.phases = stretch.given.phases;
    append_motion(stretch.phases, own, begin);
    return own.front().a == 0 && std::abs(own.front().v - v) <= kSameSpeed * v && is_smooth(own);
}

std::vector<RunMove> StretchSolver::run_moves(const Stretch& stretch, std::size_t first,
                                              std::size_t end) const {
    std::vector<RunMove> moves;
    for (std::size_t i = first; i < end; ++i) {
        const std::size_t zone = stretch.zone_of(i);
        const PathShape& shape = task_.geometry.moves[i].shape;
        const double highest = highest_speed(shape, task_.machine);
        const double fastest = shape.turn > 0 ? path_speed(shape, task_.machine) : highest;
        RunMove move;
        move.planned = i;
        move.length = length_of(task_.geometry.moves[i], grid_);
        const double asked = asked_speed(i, fastest);
        move.velocity = std::min({asked, slowed_[i].speed, stretch.caps[zone]});
        move.slow_axes = kVelocityShare * highest < move.velocity;
        // A motion that the queues slow has no more knots than before.
        move.step =
            std::max(knot_step(shape, task_.machine) * std::max(1.0, asked / slowed_[i].speed),
                     slowed_[i].ramp / kKnots);
        move.widest = knots_apart(task_.program.moves[task_.geometry.moves[i].move]);
        if (move.slow_axes) move.widest = std::min(move.widest, kSlowApart);
        move.jerk = carried_jerk(i, move.velocity, kAccelerationShare * task_.machine.acceleration);
        if (i < stretch.last) {
            move.end_velocity = std::min(stretch.caps[zone + 1], kJointShare * joint_speed_[i + 1]);
        }
        moves.push_back(move);
    }
    return moves;
}

void StretchSolver::improve(Stretch& stretch, std::size_t end) {
    const std::size_t first = stretch.open();
    end = std::min(end, stretch.last + 1);
    if (first >= end || one_line(stretch)) return;
    const std::vector<RunMove> moves = run_moves(stretch, first, end);
    double least = 0;  // s, without ramps
    for (const RunMove& move : moves) least += move.length / move.velocity;
    const long double from = place_of(task_.geometry, stretch, first, grid_);
    const long double to = place_of(task_.geometry, stretch, end, grid_);
    const std::vector<Phase> rules = part_of(stretch.phases, from, to);
    if (duration(rules) * (1 - kWorth) < least) return;
    std::vector<Phase> phases = stretch.given.phases;
    append_motion(phases,
                  optimal_run(rules, moves, task_.geometry, task_.machine, places_,
                              [&](auto& run) { return place_ends(moves, run); }),
                  from);
    append_motion(phases, part_of(stretch.phases, to, kEnd), to);
    stretch.phases = std::move(phases);
}

/// Returns true on a straight line from rest to rest, where the rules are the optimum.
bool StretchSolver::one_line(const Stretch& stretch) const {
    const Move& move = task_.program.moves[task_.geometry.moves[stretch.first].move];
    return stretch.first == stretch.last && move.kind == Move::Kind::kLine;
}

/// Moves ends of phases to the other tick beside them where that lowers the loads of the words on
/// both sides: first those behind words that take too much, then those before. Returns the loads
/// that are left.
std::vector<RunLoad> StretchSolver::place_ends(const std::vector<RunMove>& moves,
                                               std::vector<Phase>& phases) {
    WordsLoad now = words_load(moves, phases);
    for (const std::size_t before : {1, 0}) {
        const auto load = [](const WordsLoad& words, std::size_t end) {
            return std::max(words.highest[end - 1], words.highest[end]);
        };
        if (now.loads.empty()) break;
        const PhaseEnds ends(phases, grid_.tick);
        std::vector<std::size_t> tried;
        for (std::size_t i = 1; i < phases.size(); ++i) {
            if (now.highest[i - before] > 1) tried.push_back(i);
        }
        const WordsLoad there = words_load(moves, ends.moved(tried));
        std::vector<std::size_t> better;
        std::copy_if(tried.begin(), tried.end(), std::back_inserter(better),
                     [&](std::size_t end) { return load(there, end) < load(now, end); });
        if (better.empty()) continue;
        phases = ends.moved(better);
        now = better.size() == tried.size() ? there : words_load(moves, phases);
    }
    return now.loads;
}

/// Rounding to ticks may ask too much, also at joints within a few of them.
StretchSolver::WordsLoad StretchSolver::words_load(const std::vector<RunMove>& moves,
                                                   const std::vector<Phase>& phases) {
    Geometry own;
    std::uint64_t length = 0;
    for (const RunMove& move : moves) {
        own.moves.push_back(task_.geometry.moves[move.planned]);
        length += own.moves.back().length;
    }
    Plan run;
    run.unit_mm = task_.options.unit_mm;
    run.tick_s = grid_.tick;
    append_run(phases, length, grid_, run.pieces);
    const PhaseEnds ends(phases, grid_.tick);
    WordsLoad words{{}, std::vector<double>(phases.size(), 0)};
    double begin = 0;  // mm, start of the move
    const ProfilePiece* piece = run.pieces.data();
    std::uint64_t tick = 0;  // start of the piece
    std::size_t phase = 0;   // first that ends behind it
    walk_pieces(run, own, grid_, [&](const PieceStretch& part) {
        for (; piece != part.piece; ++piece) tick += piece->ticks;
        while (phase + 1 < phases.size() && ends.nearest(phase + 1) <= tick) ++phase;
        LimitRatios worst;
        const RunMove& on = moves[part.move_index];
        keep_loads(part, on.planned, run, grid_, task_.machine, places_, worst);
        const double load =
            std::max(worst.acceleration / kAccelerationShare, worst.jerk / kJerkShare);
        double speed = std::max(top_of(part, run) / on.velocity, worst.velocity / kVelocityShare);
        if (part.ends_move && part.move_index + 1 < moves.size()) {
            speed = std::max(speed, motion(part, 1, run).v / on.end_velocity);
        }
        // Rounding leaves less than a tick of a piece beside a joint. No sample sees that alone.
        const double ticks = part.to - part.from;
        const double unseen = kUnseen * task_.machine.joint_time / (ticks * grid_.tick);
        const double carried = ticks < 1 ? std::max(kCarried, 1 + unseen) : kCarried;
        const double highest = std::max(load / carried, speed / kSpeedCarried);
        if (highest > 1) {
            words.loads.push_back(
                {begin + part.s * grid_.quantum, std::max(1.0, load), std::max(1.0, speed)});
        }
        for (std::size_t i = phase; i < phases.size() && ends.nearest(i) < tick + piece->ticks;
             ++i) {
            words.highest[i] = std::max(words.highest[i], highest);
        }
        if (part.ends_move) begin += length_of(*part.move, grid_);
    });
    return words;
}

/// Speed that feed, core and words allow, given the machine's.
double StretchSolver::asked_speed(std::size_t i, double machine) const {
    const PlannedMove& planned = task_.geometry.moves[i];
    const Move& move = task_.program.moves[planned.move];
    const double v =
        std::min({machine * kVelocityShare, step_speed_[i] * kVelocityShare, fastest_word(grid_)});
    return !move.rapid && move.feed > 0 ? std::min(v, move.feed / planned.shape.rate) : v;
}

double StretchSolver::carried_jerk(std::size_t i, double v, double acceleration) const {
    const double time = static_cast<double>(grid_.shortest) * grid_.tick;
    const double least = slowed_[i].ramp / 2;  // to full acceleration and back
    return std::min({acceleration / (kRampPieces * time), v / (kSpeedPieces * time * time),
                     least > 0 ? v / (least * least) : kUnlimited});
}

Zone StretchSolver::zone(std::size_t i) const {
    const PlannedMove& planned = task_.geometry.moves[i];
    const double v =
        std::min(asked_speed(i, top_speed(planned.shape, task_.machine)), slowed_[i].speed);
    const PathLimits limits = along_path(planned.shape, task_.machine, v);
    const double acceleration = kAccelerationShare * limits.acceleration;
    const double jerk = std::min(kJerkShare * limits.jerk, carried_jerk(i, v, acceleration));
    return {length_of(planned, grid_), limits.velocity, acceleration, jerk};
}

}  // namespace curvecore::ref
