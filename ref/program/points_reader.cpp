// SPDX-License-Identifier: Apache-2.0
#include "ref/program/points_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/curve/arc_length.hpp"
#include "ref/program/coordinates.hpp"
#include "ref/program/points_table.hpp"
#include "ref/program/text_file.hpp"

namespace curvecore::ref {
namespace {

Vec3 vector_at(const PointRow& row, int first) {
    return {*row.cell[first], *row.cell[first + 1], *row.cell[first + 2]};
}

Aux aux_of(const PointRow& row) {
    Aux aux{};
    for (int i = 0; i < kAuxAxes; ++i) aux[i] = row.cell[3 + i].value_or(0);
    return aux;
}

/// Derivatives are where the fit wants them, and nowhere else.
void check_derivatives(const PointTable& table, const std::string& file, Fit fit) {
    for (const bool first : {true, false}) {
        const int column = first ? kFirstD1 : kFirstD2;
        const bool wanted = first ? wants_d1(fit) : wants_d2(fit);
        const char* const names = first ? "dx dy dz" : "ddx ddy ddz";
        const Place header{file, table.header_line};
        if (wanted && !table.has[column]) {
            header.refuse(fmt::format("this fit wants the columns {}", names));
        }
        if (!wanted && table.has[column]) {
            header.refuse(fmt::format("this fit has no use for the columns {}", names));
        }
        for (std::size_t i = 0; wanted && i < table.rows.size(); ++i) {
            const bool end = i == 0 || i + 1 == table.rows.size();
            if (!table.rows[i].cell[column] && (end || fit != Fit::kClamped)) {
                Place{file, table.rows[i].line}.refuse(
                    fmt::format("this fit wants {} here", names));
            }
        }
    }
}

std::vector<FitPoint> fit_input(const PointTable& table, const std::string& file) {
    std::vector<FitPoint> points;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const PointRow& row = table.rows[i];
        FitPoint point;
        point.position = vector_at(row, 0);
        if (row.cell[kFirstD1]) point.d1 = vector_at(row, kFirstD1);
        if (row.cell[kFirstD2]) point.d2 = vector_at(row, kFirstD2);
        if (i > 0 && (point.position - points.back().position).norm() < kStill) {
            Place{file, row.line}.refuse(
                fmt::format("this is the point of line {} again", table.rows[i - 1].line));
        }
        points.push_back(point);
    }
    if (points.size() < 2) {
        throw InputError(file, table.rows.empty() ? 0 : table.rows[0].line,
                         fmt::format("a spline wants at least 2 points, here {} {}",
                                     points.size() == 1 ? "is" : "are", points.size()));
    }
    return points;
}

/// The moves from one point to the next.
void append(Program& program, const std::vector<Cubic>& chain, const PointRow& from,
            const PointRow& to, double feed) {
    std::vector<double> reached;  // path length at the end of each
    double length = 0;
    for (const Cubic& cubic : chain) {
        for (const Vec3& point : to_bezier(cubic)) {
            if (!(point.cwiseAbs().maxCoeff() <= kFarthest)) {
                Place{program.file, to.line}.refuse(
                    fmt::format("the spline is out of range: beyond {:.10g} mm", kFarthest));
            }
        }
        reached.push_back(length += arc_length(cubic, 0, 1));
    }
    const Aux first = aux_of(from);
    const Aux last = aux_of(to);
    Move move;
    move.kind = Move::Kind::kCubic;
    move.line = to.line;
    move.feed = feed;
    move.start = vector_at(from, 0);
    move.aux_start = first;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const bool end = i + 1 == chain.size();
        move.cubic = chain[i];
        move.end = end ? vector_at(to, 0) : chain[i].position(1);
        for (int a = 0; a < kAuxAxes; ++a) {
            move.aux_end[a] = end ? last[a] : first[a] + (last[a] - first[a]) * reached[i] / length;
            if (last[a] != first[a]) program.aux_axes = std::max(program.aux_axes, a + 1);
        }
        program.moves.push_back(move);
        move.start = move.end;
        move.aux_start = move.aux_end;
    }
}

}  // namespace

Program read_points(const std::string& file, const PointsOptions& options) {
    return read_points_text(read_text_file(file), file, options);
}

Program read_points_text(std::string_view text, const std::string& file_name,
                         const PointsOptions& options) {
    const PointTable table = read_point_table(text, file_name);
    const std::vector<FitPoint> points = fit_input(table, file_name);
    check_derivatives(table, file_name, options.fit);
    const std::vector<std::vector<Cubic>> chains =
        fit_points(points, options.fit, options.parametrisation, options.fit_tolerance);
    Program program;
    program.file = file_name;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        append(program, chains[i], table.rows[i], table.rows[i + 1], options.feed);
    }
    program.moves.back().exact_stop = true;
    return program;
}

}  // namespace curvecore::ref
