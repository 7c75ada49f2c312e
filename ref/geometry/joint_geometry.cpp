// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/joint_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "ref/format/path_words.hpp"
#include "ref/joints/joint_moves.hpp"
#include "ref/limits/joint_shape.hpp"
#include "ref/segment/series_error.hpp"

namespace curvecore::ref {

Segment joint_segment(const Program& program, std::size_t index, const PlanOptions& options,
                      long double& path) {
    const Move& move = program.moves[index];
    const JointPath& of = move.joints;
    const double unit = options.unit_mm;
    const double length = of.length / unit;
    TablePiece piece;
    piece.table = options.format.table.get();
    const auto series = of.joints.stretched(1 / unit);
    for (const auto& [place, row] : piece.table->bus) {
        const int n = piece.table->powers.at(row) + 1;  // x = c1 tau + c2 h tau^2 ..
        for (int axis = 0; axis < 3; ++axis) piece.at(place, axis) = series.c(axis, n) / unit;
    }
    Segment segment;
    segment.move = index;
    segment.line = move.line;
    segment.curve = piece;
    segment.start = move.start / unit;
    segment.end = move.end / unit;
    segment.stretch = of.stretch;
    segment.step_exponent = std::max(0, static_cast<int>(std::ceil(std::log2(length) - 1e-12)));
    segment.bound =
        series_error(options.format, segment.step_exponent) + kJointShare * options.error_limit;
    segment.s_start = static_cast<std::uint64_t>(std::llround(path * kQuantaPerUnit));
    path += length;
    segment.length =
        static_cast<std::uint64_t>(std::llround(path * kQuantaPerUnit)) - segment.s_start;
    for (std::size_t i = 0; i < kAuxAxes; ++i) {
        segment.aux_start[i] = move.aux_start[i] / unit;
        segment.aux_end[i] = move.aux_end[i] / unit;
        segment.aux_advance[i] = (segment.aux_end[i] - segment.aux_start[i]) / length;
    }
    return segment;
}

std::vector<PlannedMove> joint_stretches(const Program& program, const Machine& machine,
                                         const Segment& segment, double unit_mm) {
    std::vector<PlannedMove> all;
    const double quantum = unit_mm / kQuantaPerUnit;
    std::uint64_t from = 0;
    const std::vector<JointStretch> stretches =
        joint_stretches(program.moves[segment.move], machine);
    for (const JointStretch& stretch : stretches) {
        std::uint64_t to = segment.length;
        if (&stretch != &stretches.back()) {
            to = std::min(to, static_cast<std::uint64_t>(std::llround(stretch.to / quantum)));
        }
        if (to <= from) continue;
        PlannedMove planned;
        planned.move = segment.move;
        planned.shape = stretch.shape;
        planned.length = to - from;
        planned.steps = static_cast<double>(to - from) / static_cast<double>(segment.length);
        all.push_back(planned);
        from = to;
    }
    return all;
}

}  // namespace curvecore::ref
