// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/pieces/profile_words.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/pieces/phase_ends.hpp"
#include "ref/format/path_words.hpp"

namespace curvecore::ref {
namespace {

constexpr int kFrac = 34;

/// Place and speed of a motion at a whole tick: quanta, quanta per tick.
struct Knot {
    std::uint64_t tick;
    std::uint64_t s;
    long double v;
};

/// The motion of one run on the grid of ticks and quanta.
class Run {
  public:
    Run(const std::vector<Phase>& phases, std::uint64_t length, const PieceGrid& grid)
        : phases_(phases), ends_(phases, grid.tick), length_(length), grid_(grid) {}

    std::vector<Knot> knots() const {
        const std::uint64_t gap = grid_.shortest;
        std::vector<Knot> knots{{0, 0, per_tick(phases_.front().v)}};
        for (std::size_t i = 1; i < phases_.size(); ++i) {
            const std::uint64_t tick = ends_.nearest(i);
            if (tick >= knots.back().tick + gap && tick + gap <= ends_.ticks()) {
                knots.push_back(at(tick));
            }
        }
        knots.push_back({ends_.ticks(), length_, per_tick(end_speed(phases_))});
        for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
            knots[i].s = std::clamp(knots[i].s, knots[i - 1].s, length_);
        }
        return knots;
    }

    Knot at(std::uint64_t tick) const {
        const std::vector<long double>& times = ends_.times();
        const long double time = tick * ends_.tick();
        const auto next = std::upper_bound(times.begin(), times.end() - 1, time);
        const std::size_t i = static_cast<std::size_t>(next - times.begin()) - 1;
        const Phase& p = phases_[i];
        const long double t = time - times[i];
        const long double s = p.s + ((p.j / 6 * t + p.a / 2) * t + p.v) * t;
        const long double v = std::max(0.0L, (p.j / 2 * t + p.a) * t + p.v);
        const auto quanta = std::llround(std::max(0.0L, s / grid_.quantum));
        return {tick, std::min(length_, static_cast<std::uint64_t>(quanta)),
                v * ends_.tick() / grid_.quantum};
    }

  private:
    long double per_tick(long double v) const { return v * grid_.tick / grid_.quantum; }

    const std::vector<Phase>& phases_;
    PhaseEnds ends_;
    std::uint64_t length_;
    PieceGrid grid_;
};

int bits_for(std::uint64_t ticks) {
    int m = 0;
    while ((std::uint64_t{1} << m) < ticks) ++m;
    return m;
}

/// Value of a word's exponent.
double power_of_two(int exponent) { return static_cast<double>(std::uint64_t{1} << exponent); }

/// The cubic through both knots, with the exponent at which no coefficient and no partial sum of
/// Horner's scheme leaves its word.
ProfilePiece cubic(const Knot& from, const Knot& to) {
    ProfilePiece piece;
    const std::uint64_t ticks = to.tick - from.tick;
    piece.ticks = static_cast<std::uint32_t>(ticks);
    piece.ds = to.s - from.s;
    piece.time_exponent = bits_for(ticks);
    if (piece.ds == 0) return piece;
    const long double n = ticks;
    const long double ds = piece.ds;
    const long double scale = std::ldexp(1.0L, piece.time_exponent);
    const long double c1 = from.v * scale;
    const long double c2 = (3 * ds / n - 2 * from.v - to.v) / n * scale * scale;
    const long double c3 = (from.v + to.v - 2 * ds / n) / (n * n) * scale * scale * scale;
    long double size = std::max(
        {std::abs(c1), std::abs(c2), std::abs(c3), std::abs(c2 + c3), std::abs(c1 + c2 + c3)});
    if (c3 != 0) {
        const long double bend = -c2 / (2 * c3);
        if (bend > 0 && bend < 1) size = std::max(size, std::abs(c1 + c2 * bend / 2));
    }
    const long double most = 2 - std::ldexp(1.0L, -30);
    piece.exponent = std::max(0, std::ilogb(size));  // or one more
    while (size >= std::ldexp(most, piece.exponent)) ++piece.exponent;

    const auto word = [](long double c) {
        return static_cast<std::int64_t>(std::llround(std::ldexp(c, kFrac)));
    };
    const long double unit = std::ldexp(1.0L, piece.exponent);
    piece.c[0] = word(c1 / unit);
    piece.c[1] = word(c2 / unit);
    // The last coefficient takes what the others have rounded, so that the cubic ends at ds.
    const long double tau = n / scale;
    const long double rest = ds / unit -
                             std::ldexp(static_cast<long double>(piece.c[0]), -kFrac) * tau -
                             std::ldexp(static_cast<long double>(piece.c[1]), -kFrac) * tau * tau;
    piece.c[2] = word(rest / (tau * tau * tau));
    return piece;
}

/// Returns true if the cubic through both knots runs backwards by more than the rounding of its
/// ends. It does so behind a long slow phase whose last tick is partly of a faster one.
bool goes_back(const Knot& from, const Knot& to) {
    const long double n = to.tick - from.tick;
    const long double mean = (to.s - from.s) / n;
    const long double slope = 3 * mean - 2 * from.v - to.v;  // n / 2 times the first acceleration
    const long double bend = from.v + to.v - 2 * mean;       // n^2 / 6 times the jerk
    if (bend <= 0 || slope >= 0 || -slope >= 3 * bend) return false;
    return from.v - slope * slope / (3 * bend) < -0.01L * mean - 2 / n;
}

void append_cubic(const Run& run, const Knot& from, const Knot& to, const PieceGrid& grid,
                  std::vector<ProfilePiece>& pieces) {
    const std::uint64_t ticks = to.tick - from.tick;
    const std::uint64_t parts = grid.longest.parts(ticks, to.s - from.s);
    std::uint64_t first = ticks / 2;  // ticks of the first of two pieces
    if (ticks >= 2 * grid.shortest && goes_back(from, to)) {
        first = to.v > from.v ? ticks - grid.shortest : grid.shortest;
    } else if (parts > 1) {
        first = ticks * (parts / 2) / parts;
    } else {
        const ProfilePiece piece = cubic(from, to);
        if (piece.exponent <= kMaxPlannedExponent || ticks == 1) {
            pieces.push_back(piece);
            return;
        }
    }
    Knot middle = run.at(from.tick + first);
    middle.s = std::clamp(middle.s, from.s, to.s);
    append_cubic(run, from, middle, grid, pieces);
    append_cubic(run, middle, to, grid, pieces);
}

}  // namespace

PieceGrid::PieceGrid(const Machine& machine, double unit_mm, double tick_s)
    : tick(tick_s), quantum(unit_mm * kQuantum) {
    double jerk = machine.jerk;
    for (const AxisLimits& axis : machine.axis) jerk = std::min(jerk, axis.jerk);
    // A quantum of rounding over a time h is a jerk of 12 quanta / h^3: at most 2 % of the least.
    const double time = std::cbrt(600 * quantum / jerk);
    shortest = static_cast<std::uint64_t>(std::max(1.0, std::ceil(time / tick)));
}

void append_run(const std::vector<Phase>& phases, std::uint64_t length, const PieceGrid& grid,
                std::vector<ProfilePiece>& pieces) {
    const Run run(phases, length, grid);
    const std::vector<Knot> knots = run.knots();
    for (std::size_t i = 1; i < knots.size(); ++i) {
        append_cubic(run, knots[i - 1], knots[i], grid, pieces);
    }
}

void append_rest(double seconds, const PieceGrid& grid, std::vector<ProfilePiece>& pieces) {
    std::uint64_t ticks = rest_ticks(seconds, grid.tick);
    while (ticks > 0) {
        // The last one is no longer than others: where motion begins, a piece has begun shortly
        // before.
        const std::uint64_t last = std::min(ticks, grid.longest.ticks);
        ProfilePiece piece;
        piece.ticks = static_cast<std::uint32_t>(
            ticks > last ? std::min<std::uint64_t>(ticks - last, kMaxTicks) : last);
        piece.time_exponent = bits_for(piece.ticks);
        ticks -= piece.ticks;
        pieces.push_back(piece);
    }
}

double ticks_of(const std::vector<ProfilePiece>& pieces) {
    double ticks = 0;
    for (const ProfilePiece& piece : pieces) ticks += piece.ticks;
    return ticks;
}

double fastest_word(const PieceGrid& grid) {
    return std::ldexp(grid.quantum / grid.tick, kMaxPlannedExponent);
}

PieceState piece_state(const ProfilePiece& piece, double ticks) {
    const double scale = 1 / power_of_two(piece.time_exponent);
    const double unit = power_of_two(piece.exponent) / power_of_two(kFrac);
    const double tau = ticks * scale;
    const double c1 = static_cast<double>(piece.c[0]) * unit;
    const double c2 = static_cast<double>(piece.c[1]) * unit;
    const double c3 = static_cast<double>(piece.c[2]) * unit;
    return {((c3 * tau + c2) * tau + c1) * tau, ((3 * c3 * tau + 2 * c2) * tau + c1) * scale,
            (6 * c3 * tau + 2 * c2) * scale * scale, 6 * c3 * scale * scale * scale};
}

}  // namespace curvecore::ref
