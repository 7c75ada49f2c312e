// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/geometry.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "ref/bound/error_bound.hpp"
#include "ref/format/path_words.hpp"
#include "ref/geometry/joint_geometry.hpp"
#include "ref/geometry/remedy.hpp"
#include "ref/geometry/rotary_turns.hpp"
#include "ref/geometry/spline_geometry.hpp"
#include "ref/geometry/table_geometry.hpp"
#include "ref/limits/arc_shape.hpp"
#include "ref/limits/limits.hpp"
#include "ref/limits/travel.hpp"
#include "ref/numeric/unlimited.hpp"
#include "ref/segment/last_step.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr double kClosing = 0.02;  // units, error of a computed arc at its end

/// The cut of a move.
struct Cut {
    int pieces = 0;  // 0: no cut meets the bound
    int step_exponent = 0;
    double bound = 0;
};

/// Segment 0 of the move cut into `pieces` pieces, without position.
Segment prototype(const Move& move, const PathShape& shape, int pieces, double unit) {
    Segment segment;
    segment.length =
        static_cast<std::uint64_t>(std::ceil(shape.length / unit / pieces * kQuantaPerUnit)) + 1;
    if (move.kind == Move::Kind::kArc) {
        const Vec3 arm = move.start - move.centre;
        const Vec3 normal = arm.normalized();
        segment.curve = ArcPiece{move.normal.cross(normal), normal, shape.turn, arm.norm() / unit,
                                 move.advance / shape.length};
    } else {
        segment.arc().advance = (move.end - move.start) / shape.length;
    }
    for (int i = 0; i < kAuxAxes; ++i) segment.aux_advance[i] = shape.advance[3 + i];
    return segment;
}

/// Longest step that keeps the bound; the best one if none does.
Cut best_step(Segment segment, const CoreParameters& format, double limit) {
    Cut cut;
    cut.bound = kUnlimited;
    const double length = static_cast<double>(segment.length) / kQuantaPerUnit;
    const int longest =
        std::min(kMaxStepExponent, std::max(0, static_cast<int>(std::ceil(std::log2(length)))));
    for (int k = longest; k >= 0 && std::ldexp(kMaxSteps, k) > length; --k) {
        segment.step_exponent = k;
        if (std::ldexp(segment.arc().twist(), k) > kMostTheta) continue;
        const double bound = segment_bound(format, segment);
        if (bound < cut.bound) {
            cut.bound = bound;
            cut.step_exponent = k;
        }
        if (bound <= limit) break;
    }
    return cut;
}

Cut cut_move(const Move& move, const PathShape& shape, const CoreParameters& format, double unit,
             const PlanOptions& options, int pieces_by_turns) {
    const double limit = options.error_limit;
    const auto with = [&](int pieces) {
        Cut cut = best_step(prototype(move, shape, pieces, unit), format, limit);
        cut.pieces = cut.bound <= limit ? pieces : 0;
        return cut;
    };
    int least = static_cast<int>(shape.length / unit / (kLongestSegment - 1)) + 1;
    least = std::max(least, pieces_by_turns);
    if (move.kind == Move::Kind::kArc) {
        least = std::max(least, static_cast<int>(std::ceil(move.angle / M_PI_2 * (1 - 1e-12))));
    }
    int high = least;
    Cut best = with(high);
    while (best.pieces == 0 && high < options.max_pieces) {
        high = std::min(2 * high, std::max(options.max_pieces, least));
        best = with(high);
    }
    if (best.pieces == 0) return best;
    for (int low = std::max(least, high / 2); low < high;) {  // fewest pieces
        const int middle = low + (high - low) / 2;
        const Cut cut = with(middle);
        if (cut.pieces > 0) {
            best = cut;
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return best;
}

/// Speed that feed and machine allow, mm/s.
double fastest_of(const Move& move, const PathShape& shape, double machine) {
    return !move.rapid && move.feed > 0 ? std::min(machine, move.feed / shape.rate) : machine;
}

/// Adds pieces where the last step of each would be too short.
Cut with_long_last_steps(const Cut& fewest, const Move& move, const PathShape& shape,
                         double fastest, const PlanOptions& options) {
    constexpr int kTries = 64;
    const double least = least_last_step(fastest, options);
    const double length = shape.length / options.unit_mm;
    const auto fits = [&](const Cut& cut) {
        return cut_for_last_step(length / cut.pieces, cut.step_exponent, least) == 0;
    };
    if (fewest.pieces == 0 || fits(fewest)) return fewest;
    const int most = std::min(fewest.pieces + kTries, options.max_pieces);
    for (int pieces = fewest.pieces + 1; pieces <= most; ++pieces) {
        Cut cut = best_step(prototype(move, shape, pieces, options.unit_mm), options.format,
                            options.error_limit);
        cut.pieces = pieces;
        if (cut.bound <= options.error_limit && fits(cut)) return cut;
    }
    return fewest;
}

class Cutter {
  public:
    Cutter(const Program& program, const Machine& machine, const PlanOptions& options, double miss)
        : program_(program), machine_(machine), options_(options), path_(miss / kQuantaPerUnit) {}

    Geometry run(std::size_t most) {
        if (program_.aux_axes > options_.aux_axes) {
            throw InputError(program_.file, 0,
                             fmt::format("the program needs AuxAxes {} (now {})", program_.aux_axes,
                                         options_.aux_axes));
        }
        for (std::size_t i = 0; i < program_.moves.size(); ++i) {
            const std::size_t first = geometry_.moves.size();
            if (std::max(first, geometry_.segments.size()) >= most) break;
            const long double begin = path_ * kQuantaPerUnit;
            add(i);
            if (first == geometry_.moves.size()) continue;
            geometry_.moves[first].miss = static_cast<double>(begin - std::round(begin));
        }
        geometry_.moves.shrink_to_fit();
        geometry_.segments.shrink_to_fit();
        return std::move(geometry_);
    }

  private:
    [[noreturn]] void refuse(const Move& move, const std::string& reason) const {
        throw InputError(program_.file, move.line, reason);
    }

    template <class Fits>
    [[noreturn]] void refuse_width(const Move& move, const char* kind, const Fits& fits) const {
        if (!options_.advise) {
            refuse(move, fmt::format("this {} cannot stay within {:g} units of the exact curve in "
                                     "{} segments",
                                     kind, options_.error_limit, options_.max_pieces));
        }
        refuse(move, fmt::format("this {} {} to stay within {} units of the exact curve", kind,
                                 remedy(options_, fits), options_.error_limit));
    }

    void add(std::size_t index) {
        const Move& move = program_.moves[index];
        check_travel(move);
        if (move.kind == Move::Kind::kJoints) return add_joints(index);
        if (move.kind > Move::Kind::kArc) return add_curve(index);
        const PathShape shape = path_shape(move);
        check_path(move, shape.length);
        const double unit = options_.unit_mm;
        if (shape.length / unit * kQuantaPerUnit < 0.5) {
            path_ += static_cast<long double>(shape.length) / unit;
            return;
        }
        const int by_turns = pieces_by_turns(move);
        const Cut fewest = cut_move(move, shape, options_.format, unit, options_, by_turns);
        const Cut cut = with_long_last_steps(
            fewest, move, shape, fastest_of(move, shape, path_speed(shape, machine_)), options_);
        const char* kind = move.kind == Move::Kind::kArc ? "arc" : "line";
        if (cut.pieces == 0) {
            refuse_width(move, kind, [&](const CoreParameters& format, double finer) {
                return cut_move(move, shape, format, finer, options_, by_turns).pieces > 0;
            });
        }
        const std::size_t first = geometry_.segments.size();
        const long double begin = path_;
        for (int i = 0; i < cut.pieces; ++i) {
            place(index, shape, cut, i,
                  begin + shape.length / static_cast<long double>(unit) * (i + 1) / cut.pieces);
        }
        std::uint64_t length = 0;
        double steps = 0;
        for (std::size_t i = first; i < geometry_.segments.size(); ++i) {
            const std::uint64_t own = geometry_.segments[i].length;
            length += own;
            steps += std::ceil(std::ldexp(static_cast<double>(own), -16 - cut.step_exponent));
        }
        add_stretches(index, shape, length, steps);
    }

    /// Adds the stretches of a line or an arc of `length` quanta with `steps` integration steps.
    void add_stretches(std::size_t index, const PathShape& shape, std::uint64_t length,
                       double steps) {
        const Move& move = program_.moves[index];
        std::vector<ArcStretch> stretches{{0, 1, shape}};
        if (move.kind == Move::Kind::kArc) stretches = arc_stretches(move, machine_);
        std::uint64_t from = 0;
        for (const ArcStretch& stretch : stretches) {
            const auto to = static_cast<std::uint64_t>(
                std::llround(static_cast<long double>(stretch.to) * length));
            if (to <= from) continue;
            PlannedMove planned;
            planned.move = index;
            planned.shape = stretch.shape;
            planned.length = to - from;
            planned.steps = steps * static_cast<double>(to - from) / static_cast<double>(length);
            geometry_.moves.push_back(planned);
            from = to;
        }
    }

    void add_curve(std::size_t index) {
        const Move& move = program_.moves[index];
        const bool spline = move.kind == Move::Kind::kCubic;
        const double length = move.length();
        check_path(move, length);
        for (int i = 0; i < kAuxAxes; ++i) {
            const double rate = std::abs(move.aux_end[i] - move.aux_start[i]) / length;
            if (rate > kMostAxisRate) {
                refuse(move, fmt::format("{} goes {:.4g} times as far as this spline is long; {:g} "
                                         "times is the most",
                                         kAxisLetters[3 + i], rate, kMostAxisRate));
            }
        }
        spline ? add_spline(index) : add_table(index);
    }

    void add_table(std::size_t index) {
        const Move& move = program_.moves[index];
        std::vector<Segment> segments;
        try {
            segments = table_segments(program_, index, options_,
                                      fastest_of(move, PathShape(), machine_.velocity), path_);
        } catch (const std::domain_error&) {
            refuse(move,
                   fmt::format("the words of this core do not draw this {} within {:g} units: "
                               "take a larger CoefBits or Order",
                               move.table.name(), options_.error_limit));
        }
        append(segments, table_stretches(program_, machine_, segments.data(), segments.size(),
                                         options_.unit_mm));
    }

    void add_joints(std::size_t index) {
        check_path(program_.moves[index], program_.moves[index].joints.length);
        std::vector<Segment> one{joint_segment(program_, index, options_, path_)};
        if (one[0].length == 0) return;
        append(one, joint_stretches(program_, machine_, one[0], options_.unit_mm));
    }

    void add_spline(std::size_t index) {
        const Move& move = program_.moves[index];
        std::vector<Segment> segments;
        try {
            segments = spline_segments(program_, index, options_,
                                       fastest_of(move, PathShape(), machine_.velocity), path_);
        } catch (const std::domain_error&) {
            refuse_width(move, "spline", [&](const CoreParameters& format, double finer) {
                return spline_fits(program_, index, options_, format, finer);
            });
        }
        append(segments, spline_stretches(program_, machine_, segments.data(), segments.size(),
                                          options_.unit_mm));
    }

    /// Appends a curve's segments and its stretches.
    void append(std::vector<Segment>& segments, const std::vector<PlannedMove>& stretches) {
        geometry_.moves.insert(geometry_.moves.end(), stretches.begin(), stretches.end());
        for (Segment& segment : segments) turns_.leave_out(segment);
        geometry_.segments.insert(geometry_.segments.end(), segments.begin(), segments.end());
    }

    /// Places piece i of the move; the path reaches `end` with it.
    void place(std::size_t index, const PathShape& shape, const Cut& cut, int i, long double end) {
        const Move& move = program_.moves[index];
        const double unit = options_.unit_mm;
        Segment segment = prototype(move, shape, cut.pieces, unit);
        segment.move = index;
        segment.line = move.line;
        segment.step_exponent = cut.step_exponent;
        segment.bound = cut.bound;
        segment.s_start = static_cast<std::uint64_t>(std::llround(path_ * kQuantaPerUnit));
        segment.length =
            static_cast<std::uint64_t>(std::llround(end * kQuantaPerUnit)) - segment.s_start;
        path_ = end;
        const double from = static_cast<double>(i) / cut.pieces;
        const double to = static_cast<double>(i + 1) / cut.pieces;
        if (move.kind == Move::Kind::kArc) {
            ArcPiece& arc = segment.arc();
            const Vec3 n = arc.normal;
            const Vec3 t = arc.tangent;
            const double angle = move.angle * from;
            arc.normal = n * std::cos(angle) + t * std::sin(angle);
            arc.tangent = t * std::cos(angle) - n * std::sin(angle);
            segment.start = on_arc(move, n, t, arc.radius, from);
            segment.end = on_arc(move, n, t, arc.radius, to);
            const double miss = (segment.end - move.end / unit).norm();
            if (i + 1 == cut.pieces && miss > kClosing) {
                refuse(move,
                       fmt::format("this arc misses its end point by {:.3g} mm", miss * unit));
            }
        } else {
            segment.start = (move.start + (move.end - move.start) * from) / unit;
            segment.end = (move.start + (move.end - move.start) * to) / unit;
        }
        if (i + 1 == cut.pieces) segment.end = move.end / unit;
        for (int a = 0; a < kAuxAxes; ++a) {
            const double travel = move.aux_end[a] - move.aux_start[a];
            segment.aux_start[a] = (move.aux_start[a] + travel * from) / unit;
            segment.aux_end[a] = i + 1 == cut.pieces ? move.aux_end[a] / unit
                                                     : (move.aux_start[a] + travel * to) / unit;
        }
        turns_.leave_out(segment);
        if (segment.length > 0) geometry_.segments.push_back(segment);
    }

    int pieces_by_turns(const Move& move) const {
        const double pieces = turns_.pieces(move);
        if (pieces > options_.max_pieces) {
            refuse(move,
                   fmt::format("this move turns so far that it needs {:.0f} segments", pieces));
        }
        return static_cast<int>(pieces);
    }

    /// Point of an arc, units, counted from its start so that a far centre costs no digits.
    Vec3 on_arc(const Move& move, const Vec3& n, const Vec3& t, double radius, double part) const {
        const double angle = move.angle * part;
        const double half_sine = std::sin(angle / 2);
        return move.start / options_.unit_mm +
               radius * (t * std::sin(angle) - n * (2 * half_sine * half_sine)) +
               move.advance / options_.unit_mm * part;
    }

    void check_path(const Move& move, double length) const {
        if (path_ + static_cast<long double>(length) / options_.unit_mm < kLongestProgram) return;
        refuse(move, fmt::format("the program's path is {:.6g} m here; a program of this unit is "
                                 "shorter than {:.6g} m",
                                 (static_cast<double>(path_) * options_.unit_mm + length) / 1000,
                                 kLongestProgram * options_.unit_mm / 1000));
    }

    void check_travel(const Move& move) const {
        const AxisRange range = travel(move);
        const std::string beyond = beyond_travel(range, move, machine_);
        if (!beyond.empty()) refuse(move, beyond);
        for (int i = 0; i < kMachineAxes; ++i) {
            if (machine_.axis[i].rotary) {
                const std::string beyond_words =
                    turns_.beyond_words(move, static_cast<std::size_t>(i));
                if (!beyond_words.empty()) refuse(move, beyond_words);
                continue;
            }
            const double far = std::max(-range.low[i], range.high[i]) / options_.unit_mm + 1;
            const int bits = far < 1 ? 1 : static_cast<int>(std::ceil(std::log2(far))) + 1;
            if (bits > options_.format.position_bits) {
                refuse(move, fmt::format("{} = {:.6g} mm needs PositionBits {} (now {}) or a "
                                         "larger unit",
                                         kAxisLetters[i], (far - 1) * options_.unit_mm, bits,
                                         options_.format.position_bits));
            }
        }
    }

    const Program& program_;
    const Machine& machine_;
    const PlanOptions& options_;
    const RotaryTurns turns_{machine_, options_};
    Geometry geometry_;
    long double path_;  // units
};

}  // namespace

Geometry make_geometry(const Program& program, const Machine& machine, const PlanOptions& options,
                       double miss, std::size_t most) {
    return Cutter(program, machine, options, miss).run(most);
}

}  // namespace curvecore::ref
