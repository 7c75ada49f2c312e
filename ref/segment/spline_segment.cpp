// SPDX-License-Identifier: Apache-2.0
#include "ref/segment/spline_segment.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ref/bound/error_bound.hpp"
#include "ref/bound/spline_bound.hpp"
#include "ref/curve/arc_length.hpp"
#include "ref/format/path_words.hpp"
#include "ref/segment/last_step.hpp"

namespace curvecore::ref {
namespace {

constexpr int kMaxHalvings = 40;

/// Roundings of the cubic's words and of the words made from them.
double hair(const CoreParameters& format) { return std::ldexp(1.0, 6 - format.coef_bits); }

/// Room below 1 for the |V| of a v that has drifted along the path, and so for Newton's m.
constexpr double kRoom = 1.0 / 1024;

/// Scale that stands for |V| = 1.
double with_room(double fastest, const CoreParameters& format) {
    return fastest * (1 + kRoom + hair(format));
}

/// A tip too sharp for a step of one unit: pieces of a few units at most, as lines.
constexpr double kLongestLine = 4;

/// Makes a line of a short piece. With m = chord / length, the mean tangent, the curve leaves the
/// line by
///
///     |r(s) - line(s)| <= length / 2 sqrt(1 - m^2)
///
/// for the part before s has a mean tangent A, the rest B, both at most 1 long: with p = s /
/// length, p A^2 + (1-p) B^2 = m^2 + p (1-p) |A - B|^2 <= 1, and the distance is length p (1-p) |A
/// - B|.
Segment short_line(const Cubic& piece, double length, const CoreParameters& format,
                   const Aux& aux_advance, double& aside) {
    Segment line;
    line.aux_advance = aux_advance;
    line.start = piece.d;
    line.end = piece.position(1);
    line.length = static_cast<std::uint64_t>(std::llround(length * kQuantaPerUnit));
    if (length > 0) line.arc().advance = (line.end - line.start) / length;
    line.step_exponent = 2;
    const double straight = std::min(1.0, line.arc().advance.norm());
    aside = length / 2 * std::sqrt(1 - straight * straight);
    line.bound = aside + segment_bound(format, line);
    return line;
}

/// @param speed the highest |V|, @param length units
Segment segment_of(const Cubic& piece, const CoreParameters& format, double speed, double length) {
    const double fastest = with_room(speed, format);
    Segment segment;
    segment.start = piece.d;
    segment.end = piece.position(1);
    int exponent = 0;
    std::frexp(fastest / (1 - hair(format)), &exponent);
    const int lambda = std::max(0, exponent);
    const double beta = std::ldexp(fastest, -lambda);
    const double unit = std::ldexp(1.0, lambda);
    segment.curve =
        SplinePiece{piece.a / (unit * beta * beta * beta), piece.b / (unit * beta * beta),
                    piece.c / (unit * beta), lambda, beta};
    segment.length = static_cast<std::uint64_t>(std::llround(length * kQuantaPerUnit));
    return segment;
}

struct Splitter {
    const Cubic& cubic;
    const CoreParameters& format;
    double limit;
    Aux aux_advance;
    std::size_t max_pieces;
    double least_last_step;
    SplineCut found;

    bool may_cut(int depth) const {
        return depth < kMaxHalvings && found.pieces.size() < max_pieces;
    }

    void cut(double from, double to, int depth) {
        const Cubic part = sub_cubic(cubic, from, to);
        const SpeedRange speed = speed_range(part);
        const ArcLength arc(part);
        const double length = arc.length();
        double middle = (from + to) / 2;
        if (speed.max > 0 && with_room(speed.max, format) < 2 * speed.min) {
            Segment piece = segment_of(part, format, speed.max, length);
            piece.aux_advance = aux_advance;
            const int lambda = piece.spline().lambda;
            if (lambda <= kMaxStepExponent && lambda < format.position_bits &&
                choose_step(format, limit, piece)) {
                const double place =
                    cut_for_last_step(length, piece.step_exponent, least_last_step);
                if (place == 0 || !may_cut(depth)) {
                    found.lengths.push_back(length);
                    found.pieces.push_back(piece);
                    return;
                }
                middle = from + (to - from) * arc.parameter(place);
            }
        }
        if (length <= kLongestLine && middle == (from + to) / 2) {
            double aside = 0;  // share for the curve; the rest is for the words
            const Segment line = short_line(part, length, format, aux_advance, aside);
            if (aside <= 0.4 * limit && line.bound <= limit) {
                found.lengths.push_back(length);
                found.pieces.push_back(line);
                return;
            }
        }
        if (!may_cut(depth)) {
            throw std::domain_error("a cubic that no splitting makes drawable");
        }
        cut(from, middle, depth + 1);
        cut(middle, to, depth + 1);
    }
};

}  // namespace

Segment spline_segment(const Cubic& piece, const CoreParameters& format) {
    return segment_of(piece, format, speed_range(piece).max, ArcLength(piece).length());
}

bool choose_step(const CoreParameters& format, double limit, Segment& segment) {
    int exponent = 0;  // 2^exponent covers the length
    std::frexp(static_cast<double>(segment.length) / kQuantaPerUnit, &exponent);
    Segment trial = segment;
    for (int k = std::clamp(exponent, 0, segment.spline().lambda); k >= 0; --k) {
        trial.step_exponent = k;
        const SplineError error = spline_error(format, trial, limit);
        if (error.shorten == Shorten::kPiece) return false;
        if (error.shorten == Shorten::kSteps) continue;
        if (error.total() <= limit && error.along <= kAlongShare * limit) {
            segment.step_exponent = k;
            segment.bound = error.total();
            return true;
        }
        if (error.rounding > limit || error.along_rounding > kAlongShare * limit) return false;
    }
    return false;
}

SplineCut cut_spline(const Cubic& cubic, const CoreParameters& format, double limit,
                     const Aux& aux_advance, int max_pieces, double least_last_step) {
    if (limit < 4 * std::ldexp(0.5, -format.guard_bits)) {
        throw std::domain_error("a limit below the roundings of a position");
    }
    Splitter splitter{
        cubic,           format, limit, aux_advance, static_cast<std::size_t>(max_pieces),
        least_last_step, {}};
    splitter.cut(0, 1, 0);
    return std::move(splitter.found);
}

std::vector<Segment> placed(SplineCut cut, long double& path) {
    const auto quanta = [&path] {
        return static_cast<std::uint64_t>(
            std::llround(path * static_cast<long double>(kQuantaPerUnit)));
    };
    for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
        cut.pieces[i].s_start = quanta();
        path += cut.lengths[i];
        cut.pieces[i].length = quanta() - cut.pieces[i].s_start;
    }
    return std::move(cut.pieces);
}

std::vector<Segment> split_spline(const Cubic& cubic, const CoreParameters& format, double limit,
                                  long double& path, const Aux& aux_advance, int max_pieces) {
    return placed(cut_spline(cubic, format, limit, aux_advance, max_pieces), path);
}

std::vector<Segment> split_spline(const Cubic& cubic, const CoreParameters& format, double limit,
                                  std::uint64_t s_start) {
    long double path = static_cast<long double>(s_start) / static_cast<long double>(kQuantaPerUnit);
    return split_spline(cubic, format, limit, path);
}

}  // namespace curvecore::ref
