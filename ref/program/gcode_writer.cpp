// SPDX-License-Identifier: Apache-2.0
#include "ref/program/gcode_writer.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "ref/gcode/state/coordinates.hpp"
#include "ref/moves/arc_geometry.hpp"
#include "ref/moves/move_part.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

std::string aux_words(const Move& move) {
    std::string text;
    for (std::size_t i = 0; i < kAuxAxes; ++i) {
        if (move.aux_end[i] != move.aux_start[i])
            text += word(kAxisLetters[3 + i], move.aux_end[i]);
    }
    return text;
}

/// Writes G2 or G3 in one of the three planes.
std::string plane_arc(const Move& move, int axis, const std::string& feed) {
    const bool clockwise = move.normal[axis] < 0;
    const Vec3 centre = move.centre - move.start;
    const int turns = std::max(1, static_cast<int>(std::ceil(move.angle / (2 * M_PI) - 1e-12)));
    std::string text = fmt::format("G{} G{}{}",
                                   axis == 2   ? 17
                                   : axis == 1 ? 18
                                               : 19,
                                   clockwise ? 2 : 3, point_words(move.end, true));
    for (int i = 0; i < 3; ++i) {
        if (i != axis) text += word("IJK"[i], centre[i]);
    }
    if (turns > 1) text += fmt::format(" P{}", turns);
    return text + aux_words(move) + feed + (axis == 2 ? "\n" : "\nG17\n");
}

/// Writes G3.4 through points of the arc, half a turn at most each: any plane. Where the radii at
/// both ends differ, the arcs through these points are farther off than 1e-9 mm, but less than that
/// difference.
std::string space_arc(const std::string& file, const Move& move, const std::string& feed) {
    const int parts = static_cast<int>(std::ceil(move.angle / M_PI - 1e-12));
    if (std::abs(move.normal.dot(move.advance)) > kStill) {
        throw InputError(file, move.line, "a helix in a tilted plane: no G-code block draws it");
    }
    const auto at = [&move](double part) {
        const Vec3 radius = move.start - move.centre;
        return Vec3(move.centre + Eigen::AngleAxisd(part * move.angle, move.normal) * radius +
                    part * move.advance);
    };
    std::string text;
    for (int i = 0; i < parts; ++i) {
        const Vec3 end = i + 1 == parts ? move.end : at(static_cast<double>(i + 1) / parts);
        text += "G3.4" + point_words(at((i + 0.5) / parts), true) + feed + "\n";
        text += point_words(end, true).substr(1) + aux_words(move) + "\n";
    }
    return text;
}

/// Tolerance that LinuxCNC's documentation promises.
constexpr ArcTolerance kWrittenTolerance = arc_tolerance(0.005, 0);

/// Cuts an arc whose radii at both ends differ by more than a program in mm may state. The reader
/// turns a part's travel within the plane across the end's radius into rotation: an error of an
/// eighth of that travel times the part's angle.
std::vector<Move> readable(const Move& move) {
    constexpr double kOff = 1e-6;  // mm
    const double radius = (move.start - move.centre).norm();
    const double drift = (move.advance - move.normal * move.normal.dot(move.advance)).norm();
    if (kWrittenTolerance.holds(radius, radius - drift)) return {move};
    const double count = std::ceil(std::max(drift / (0.9 * kWrittenTolerance.always),
                                            std::sqrt(drift * move.angle / 8 / kOff)));
    const double length = move.length();
    std::vector<Move> parts;
    for (double i = 0; i < count; ++i) {
        Move part =
            part_of(move, i / count * length, i + 1 == count ? length : (i + 1) / count * length);
        for (std::size_t a = 0; a < kAuxAxes; ++a) {
            const double travel = move.aux_end[a] - move.aux_start[a];
            part.aux_start[a] = move.aux_start[a] + i / count * travel;
            part.aux_end[a] =
                i + 1 == count ? move.aux_end[a] : move.aux_start[a] + (i + 1) / count * travel;
        }
        parts.push_back(part);
    }
    return parts;
}

std::string arc(const std::string& file, const Move& move, const std::string& feed) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(move.normal[axis]) != 1) continue;
        std::string text;
        for (const Move& part : readable(move)) text += plane_arc(part, axis, feed);
        return text;
    }
    return space_arc(file, move, feed);
}

std::string cubic(const std::string& file, const Move& move, const std::string& feed) {
    if (move.aux_start != move.aux_end) {
        throw InputError(file, move.line, "a spline with auxiliary axes: no G-code block has both");
    }
    const Bezier points = to_bezier(move.cubic);
    bool in_space = false;
    for (const Vec3& point : points) in_space |= std::abs(point.z() - move.start.z()) > kStill;
    return g5_block({points[0], points[1], points[2], move.end}, in_space) + feed + "\n";
}

std::string path_control(const Move& move) {
    if (move.tolerance == 0) return move.exact_stop ? "G61.1" : "G61";
    return move.tolerance == kPathTolerance ? "G64" : "G64" + word('P', move.tolerance);
}

}  // namespace

std::string word(char letter, double value) {
    std::string text = fmt::format("{:.9f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return fmt::format(" {}{}", letter, text == "-0" ? "0" : text);
}

std::string feed_word(double feed) { return word('F', feed * 60); }

std::string point_words(const Vec3& point, bool with_z) {
    return word('X', point.x()) + word('Y', point.y()) + (with_z ? word('Z', point.z()) : "");
}

std::string g5_block(const Bezier& points, bool in_space) {
    const Vec3 out = points[1] - points[0];
    const Vec3 in = points[2] - points[3];
    std::string text = "G5" + point_words(points[3], in_space) + word('I', out.x()) +
                       word('J', out.y()) + (in_space ? word('K', out.z()) : "");
    return text + word('P', in.x()) + word('Q', in.y()) + (in_space ? word('R', in.z()) : "");
}

std::string g52_blocks(const std::vector<Vec3>& points, bool in_space, const std::string& words) {
    std::string text =
        fmt::format("G5.2{} L{}{}\n", point_words(points[1], in_space), points.size(), words);
    for (std::size_t i = 2; i < points.size(); ++i) {
        text += point_words(points[i], in_space).substr(1) + "\n";
    }
    return text + "G5.3\n";
}

std::string gcode_of(const std::string& file, const std::vector<Move>& moves) {
    std::string text;
    std::string mode = "G64";
    const auto enter = [&](const std::string& wanted) {
        if (wanted != mode) text += wanted + "\n";
        mode = wanted;
    };
    for (const Move& move : moves) {
        enter(path_control(move));
        const std::string feed = move.rapid ? "" : feed_word(move.feed);
        if (move.kind == Move::Kind::kArc) {
            text += arc(file, move, feed);
        } else if (move.kind == Move::Kind::kCubic) {
            text += cubic(file, move, feed);
        } else if (move.kind == Move::Kind::kTable) {
            throw InputError(
                file, move.line,
                fmt::format("a curve of the table {} is not written as G-code", move.table.name()));
        } else {
            text += (move.rapid ? "G0" : "G1") + point_words(move.end, true) + aux_words(move) +
                    feed + "\n";
        }
        const bool stop = move.exact_stop && move.tolerance > 0;
        if (stop || move.dwell > 0) text += "G4" + word('P', move.dwell) + "\n";
    }
    enter("G64");
    return text;
}

}  // namespace curvecore::ref
