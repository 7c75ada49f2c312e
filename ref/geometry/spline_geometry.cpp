// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/spline_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ref/format/path_words.hpp"
#include "ref/limits/spline_shape.hpp"
#include "ref/segment/last_step.hpp"
#include "ref/segment/spline_segment.hpp"

namespace curvecore::ref {
namespace {

Cubic in_units(const Cubic& mm, double unit_mm) {
    return {mm.a / unit_mm, mm.b / unit_mm, mm.c / unit_mm, mm.d / unit_mm};
}

/// Places at which the curve stands still, quanta from its start.
class Standstills {
  public:
    Standstills(const Cubic& cubic, const ArcLength& arc, double quantum)
        : tolerance_(4 + 1e-12 * arc.length() / quantum) {
        for (const double u : standstills(cubic)) places_.push_back(arc.path(u) / quantum);
    }

    bool at(std::uint64_t place) const {
        return std::any_of(places_.begin(), places_.end(), [&](double stop) {
            return std::abs(stop - static_cast<double>(place)) <= tolerance_;
        });
    }

  private:
    double tolerance_;  // quanta
    std::vector<double> places_;
};

SharedCut cut_of(const Cubic& piece, const Aux& rate, const PlanOptions& options, double fastest) {
    const double last_step = least_last_step(fastest, options);
    if (!options.cuts) {
        return std::make_shared<const SplineCut>(cut_spline(
            piece, options.format, options.error_limit, rate, options.max_pieces, last_step));
    }
    return options.cuts->of(piece, options.format, options.error_limit, rate, options.max_pieces,
                            last_step);
}

}  // namespace

std::vector<Segment> spline_segments(const Program& program, std::size_t index,
                                     const PlanOptions& options, double fastest,
                                     long double& path) {
    const Move& move = program.moves[index];
    const double unit = options.unit_mm;
    const Cubic cubic = in_units(move.cubic, unit);
    const double length = move.length() / unit;
    Aux rate;
    for (std::size_t i = 0; i < kAuxAxes; ++i) {
        rate[i] = (move.aux_end[i] - move.aux_start[i]) / unit / length;
    }
    const auto aux_at = [&](long double s) {
        Aux aux;
        for (std::size_t i = 0; i < kAuxAxes; ++i) {
            aux[i] = move.aux_start[i] / unit + rate[i] * static_cast<double>(s);
        }
        return aux;
    };

    std::vector<double> cuts = standstills(move.cubic);
    if (cuts.empty() || cuts.front() > 0) cuts.insert(cuts.begin(), 0);
    if (cuts.back() < 1) cuts.push_back(1);
    std::vector<Segment> segments;
    const long double begin = path;
    for (std::size_t part = 0; part + 1 < cuts.size(); ++part) {
        const Cubic piece = sub_cubic(cubic, cuts[part], cuts[part + 1]);
        const SharedCut cut = cut_of(piece, rate, options, fastest);
        for (Segment& segment : placed(*cut, path)) {
            if (segment.length == 0) continue;
            segment.move = index;
            segment.line = move.line;
            segments.push_back(segment);
        }
    }
    for (Segment& segment : segments) {
        const auto from = static_cast<long double>(segment.s_start) / kQuantaPerUnit - begin;
        const auto length_units = static_cast<long double>(segment.length) / kQuantaPerUnit;
        segment.aux_start = aux_at(from);
        segment.aux_end = aux_at(from + length_units);
    }
    if (!segments.empty()) {
        segments.back().end = move.end / unit;
        for (std::size_t i = 0; i < kAuxAxes; ++i) {
            segments.back().aux_end[i] = move.aux_end[i] / unit;
        }
    }
    return segments;
}

std::vector<PlannedMove> spline_stretches(const Program& program, const Machine& machine,
                                          const Segment* segments, std::size_t count,
                                          double unit_mm) {
    std::vector<PlannedMove> all;
    if (count == 0) return all;
    const Move& move = program.moves[segments->move];
    const double quantum = unit_mm / kQuantaPerUnit;
    const ArcLength arc(move.cubic);
    const Standstills stands(move.cubic, arc, quantum);
    const std::uint64_t begin = segments->s_start;
    double u = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Segment& segment = segments[i];
        const std::uint64_t end = segment.s_start + segment.length;
        const double u_end =
            i + 1 == count ? 1 : arc.parameter(static_cast<double>(end - begin) * quantum);
        const double steps =
            std::ceil(std::ldexp(static_cast<double>(segment.length), -16 - segment.step_exponent));
        std::uint64_t from = segment.s_start;
        const std::vector<SplineStretch> stretches = spline_stretches(move, arc, machine, u, u_end);
        for (const SplineStretch& stretch : stretches) {
            std::uint64_t to = end;
            if (&stretch != &stretches.back()) {
                to = begin +
                     static_cast<std::uint64_t>(std::llround(arc.path(stretch.u1) / quantum));
                to = std::min(to, end);
            }
            if (to <= from) continue;
            PlannedMove planned;
            planned.move = segment.move;
            planned.shape = stretch.shape;
            planned.length = to - from;
            planned.steps =
                steps * static_cast<double>(to - from) / static_cast<double>(segment.length);
            planned.stop_before = from == segment.s_start && stands.at(from - begin);
            planned.stop_after = to == end && stands.at(to - begin);
            all.push_back(planned);
            from = to;
        }
        u = u_end;
    }
    return all;
}

bool spline_fits(const Program& program, std::size_t index, PlanOptions options,
                 const CoreParameters& format, double unit_mm) {
    options.format = format;
    options.unit_mm = unit_mm;
    options.cuts.reset();  // cuts of the program's own words stay
    long double path = 0;
    try {
        spline_segments(program, index, options, 0, path);
    } catch (const std::domain_error&) {
        return false;
    }
    return true;
}

}  // namespace curvecore::ref
