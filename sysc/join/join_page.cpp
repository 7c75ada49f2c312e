// SPDX-License-Identifier: Apache-2.0
#include "sysc/join/join_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/program/gcode_writer.hpp"
#include "sysc/cli/html_page.hpp"
#include "sysc/join/join_template.hpp"

namespace curvecore::sysc {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostPoints = 4000;  // points of a working path in the picture
constexpr double kStretch = 0.25;          // path in the charts, as a share of the idle move
constexpr int kStretchPoints = 50;

/// Number of points of a move that a picture needs, without its start.
int points_of(const ref::Move& move) {
    if (move.kind == ref::Move::Kind::kCubic) return 24;
    if (move.kind == ref::Move::Kind::kLine) return 1;
    return static_cast<int>(std::min(1 + move.angle * 32, static_cast<double>(kMostPoints)));
}

Json rounded(const ref::Vec3& v) {
    Json json;
    for (int i = 0; i < 3; ++i) json.push_back(std::round(v[i] * 1e6) / 1e6);
    return json;
}

/// The working path as a polyline, from its joint on to a rapid or to the picture's end.
Json polyline(const ref::Program& program, bool backward) {
    const auto& moves = program.moves;
    const auto nth = [&](std::size_t i) {
        return backward ? moves[moves.size() - 1 - i] : moves[i];
    };
    Json points{rounded(backward ? moves.back().end : moves.front().start)};
    for (std::size_t i = 0; i < moves.size() && points.size() < kMostPoints; ++i) {
        const ref::Move& move = nth(i);
        if (move.rapid) break;
        if ((move.end - move.start).isZero(0) && move.kind == ref::Move::Kind::kLine) continue;
        const int count = points_of(move);
        const double length = move.length();
        for (int k = 1; k <= count; ++k) {
            const double part = static_cast<double>(backward ? count - k : k) / count;
            points.push_back(rounded(ref::place_on(move, part * length).position));
        }
    }
    return points;
}

/// Joints along the working path near its end, with `s`: path from the joint, < 0 before it.
Json stretch(const ref::Program& program, bool backward, double length) {
    Json rows = Json::array();
    const auto& moves = program.moves;
    double passed = 0;
    int k = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const ref::Move& move = backward ? moves[moves.size() - 1 - i] : moves[i];
        if ((move.end - move.start).isZero(0) && move.kind == ref::Move::Kind::kLine) break;
        if (move.rapid || passed >= length) break;
        const double whole = move.length();
        for (; k <= kStretchPoints; ++k) {
            const double s = length * k / kStretchPoints - passed;
            if (s > whole) break;
            Json row = joint_json({ref::place_on(move, backward ? whole - s : s), move.feed});
            row["s"] = backward ? -(passed + s) : passed + s;
            rows.push_back(std::move(row));
        }
        passed += whole;
    }
    if (backward) std::reverse(rows.begin(), rows.end());
    return rows;
}

}  // namespace

JoinProgram join_program(const ref::Program& a, const ref::Program& b) {
    std::vector<ref::Move> last = b.moves;
    last.back().exact_stop = false;  // M2 stops
    ref::Move approach;              // a file of points begins at the first one, not at 0
    approach.rapid = true;
    approach.end = a.moves.front().start;
    approach.aux_end = a.moves.front().aux_start;
    const bool far = approach.length() > 0;
    return {
        fmt::format("(curvecore join: working path 1)\n{}{}{}(idle move)\n", ref::kWrittenModes,
                    far ? ref::gcode_of(a.file, {approach}) : "", ref::gcode_of(a.file, a.moves)),
        fmt::format("(working path 2)\n{}M2\n", ref::gcode_of(b.file, last))};
}

std::string join_html(const JoinFile& file, const ref::Program& a, const ref::Program& b,
                      const JoinProgram& program) {
    const double length = ref::PathTable(file.move.pieces()).length();
    Json data{{"version", CURVECORE_PROGRAM_VERSION}, {"join", file.json()}};
    data["program"] = {{"head", program.head}, {"tail", program.tail}};
    data["paths"] = {polyline(a, true), polyline(b, false)};
    data["stretches"] = {stretch(a, true, kStretch * length), stretch(b, false, kStretch * length)};
    return html_page(kJoinTemplate, page_json(data));
}

}  // namespace curvecore::sysc
