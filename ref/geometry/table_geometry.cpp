// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/table_geometry.hpp"

#include <cmath>

#include "ref/format/path_words.hpp"
#include "ref/limits/table_shape.hpp"
#include "ref/segment/last_step.hpp"
#include "ref/segment/table_segment.hpp"

namespace curvecore::ref {

std::vector<Segment> table_segments(const Program& program, std::size_t index,
                                    const PlanOptions& options, double fastest, long double& path) {
    const Move& move = program.moves[index];
    const double unit = options.unit_mm;
    const auto length = static_cast<long double>(move.table_length) / unit;
    const TableCurve curve(move.table.rescaled(1 / unit), move.start / unit,
                           move.table_length / unit);
    std::vector<Segment> segments = cut_table(curve, options, least_last_step(fastest, options));
    long double from = 0;
    for (Segment& segment : segments) {
        segment.move = index;
        segment.line = move.line;
        const auto own = static_cast<long double>(segment.length) / kQuantaPerUnit;
        const long double to = &segment == &segments.back() ? length : from + own;
        segment.s_start = static_cast<std::uint64_t>(std::llround((path + from) * kQuantaPerUnit));
        segment.length = static_cast<std::uint64_t>(std::llround((path + to) * kQuantaPerUnit)) -
                         segment.s_start;
        for (std::size_t i = 0; i < kAuxAxes; ++i) {
            segment.aux_start[i] = segment.aux_end[i] = move.aux_start[i] / unit;
        }
        from = to;
    }
    path += length;
    if (!segments.empty()) segments.back().end = move.end / unit;
    return segments;
}

std::vector<PlannedMove> table_stretches(const Program& program, const Machine& machine,
                                         const Segment* segments, std::size_t count,
                                         double unit_mm) {
    std::vector<PlannedMove> all;
    if (count == 0) return all;
    const Move& move = program.moves[segments->move];
    const double quantum = unit_mm / kQuantaPerUnit;
    const TableCurve curve(move.table, move.start, move.table_length);
    const std::uint64_t begin = segments->s_start;
    for (std::size_t i = 0; i < count; ++i) {
        const Segment& segment = segments[i];
        const std::uint64_t end = segment.s_start + segment.length;
        const double steps =
            std::ceil(std::ldexp(static_cast<double>(segment.length), -16 - segment.step_exponent));
        const double s0 = static_cast<double>(segment.s_start - begin) * quantum;
        const double s1 =
            i + 1 == count ? move.table_length : static_cast<double>(end - begin) * quantum;
        std::uint64_t from = segment.s_start;
        const std::vector<TableStretch> stretches = table_stretches(move, curve, machine, s0, s1);
        for (const TableStretch& stretch : stretches) {
            std::uint64_t to = end;
            if (&stretch != &stretches.back()) {
                to = begin + static_cast<std::uint64_t>(std::llround(stretch.to / quantum));
                to = std::min(to, end);
            }
            if (to <= from) continue;
            PlannedMove planned;
            planned.move = segment.move;
            planned.shape = stretch.shape;
            planned.length = to - from;
            planned.steps =
                steps * static_cast<double>(to - from) / static_cast<double>(segment.length);
            all.push_back(planned);
            from = to;
        }
    }
    return all;
}

}  // namespace curvecore::ref
