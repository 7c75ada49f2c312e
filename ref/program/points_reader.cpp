// SPDX-License-Identifier: Apache-2.0
#include "ref/program/points_reader.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ref/curve/angle_between.hpp"
#include "ref/curve/arc_length.hpp"
#include "ref/gcode/state/coordinates.hpp"
#include "ref/program/points_table.hpp"
#include "ref/text/text_file.hpp"

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

/// Checks that derivatives are where the fit reads them, and nowhere else.
void check_derivatives(const PointTable& table, const std::string& file,
                       const PointsOptions& options) {
    for (const bool first : {true, false}) {
        const int column = first ? kFirstD1 : kFirstD2;
        const Reads reads =
            first ? reads_d1(options.fit, options.ends) : reads_d2(options.fit, options.ends);
        const char* const names = first ? "dx dy dz" : "ddx ddy ddz";
        const Place header{file, table.header_line};
        if (options.fit == Fit::kClamped && first && !table.has[column]) {
            header.refuse(fmt::format("this fit wants the columns {}", names));
        }
        if (reads == Reads::kNothing && table.has[column]) {
            header.refuse(fmt::format("this fit has no use for the columns {}", names));
        }
        for (std::size_t i = 0; table.has[column] && i < table.rows.size(); ++i) {
            const bool end = i == 0 || i + 1 == table.rows.size();
            if (!table.rows[i].cell[column] && (end || reads == Reads::kAll)) {
                Place{file, table.rows[i].line}.refuse(
                    fmt::format("this fit wants {} here", names));
            }
        }
    }
}

void check_closed(const PointTable& table, const std::string& file) {
    const PointRow& last = table.rows.back();
    if (table.rows.size() < 4) {
        Place{file, last.line}.refuse(
            "a closed spline wants at least 4 points, the first again last");
    }
    if (vector_at(table.rows.front(), 0) != vector_at(last, 0)) {
        Place{file, last.line}.refuse(fmt::format(
            "a closed spline ends at its first point, that of line {}", table.rows.front().line));
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

/// Appends the moves from one point to the next.
void append(Program& program, const std::vector<Cubic>& chain, const PointRow& from,
            const PointRow& to, double feed) {
    std::vector<double> reached;  // mm, path length at the end of each
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

/// Warns of second derivatives that are not those of a C2 spline: they leave corners at the points.
void warn_of_corners(Program& program, const std::vector<std::vector<Cubic>>& chains,
                     const PointTable& table) {
    constexpr double kNoCorner = 1e-6;  // rad
    double worst = kNoCorner;
    std::size_t at = 0;
    int count = 0;
    for (std::size_t i = 1; i < chains.size(); ++i) {
        const double angle =
            angle_between(chains[i - 1].back().velocity(1), chains[i].front().velocity(0));
        count += angle > kNoCorner ? 1 : 0;
        if (angle <= worst) continue;
        worst = angle;
        at = i;
    }
    if (count == 0) return;
    program.warnings.push_back(
        fmt::format("{}:{}: warning: a corner of {:.3g} degrees, the sharpest of {}: these second "
                    "derivatives are not those of a C2 spline (--fit c2 is one)",
                    program.file, table.rows[at].line, worst * 180 / M_PI, count));
}

}  // namespace

Program read_points(const std::string& file, const PointsOptions& options) {
    return read_points_text(read_text_file(file), file, options);
}

Program read_points_text(std::string_view text, const std::string& file_name,
                         const PointsOptions& options) {
    const PointTable table = read_point_table(text, file_name);
    const std::vector<FitPoint> points = fit_input(table, file_name);
    check_derivatives(table, file_name, options);
    if (options.fit == Fit::kC2 && options.ends == Ends::kClosed) check_closed(table, file_name);
    const std::vector<std::vector<Cubic>> chains = fit_points(
        points, options.fit, options.parametrisation, options.fit_tolerance, options.ends);
    Program program;
    program.file = file_name;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        append(program, chains[i], table.rows[i], table.rows[i + 1], options.feed);
    }
    program.moves.back().exact_stop = true;
    if (options.fit == Fit::kMoments) warn_of_corners(program, chains, table);
    return program;
}

}  // namespace curvecore::ref
