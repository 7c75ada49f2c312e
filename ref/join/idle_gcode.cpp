// SPDX-License-Identifier: Apache-2.0
#include "ref/join/idle_gcode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ref/gcode/state/coordinates.hpp"
#include "ref/program/gcode_writer.hpp"

namespace curvecore::ref {
namespace {

using Points = std::vector<Vec3>;

void check(double chords) {
    if (chords <= static_cast<double>(kMostChords)) return;
    throw std::invalid_argument(
        fmt::format("the idle move becomes more than {} chords", kMostChords));
}

/// Least number of even chords that keeps the tolerance over one piece.
double chords_for(const BezierPiece& piece, double tolerance) {
    double widest = 0;
    for (std::size_t i = 0; i + 2 < piece.points.size(); ++i) {
        const Vec3 second = piece.points[i + 2] - 2 * piece.points[i + 1] + piece.points[i];
        widest = std::max(widest, second.norm());
    }
    const int n = piece.degree();
    return std::max(1.0, std::ceil(std::sqrt(n * (n - 1) * widest / (8 * tolerance))));
}

std::string chord(const Vec3& to, double feed) {
    return "G1" + point_words(to, true) + feed_word(feed) + "\n";
}

std::string by_step(const PathTable& path, const SpeedCourse& course, double step) {
    std::string text;
    const double count = std::max(1.0, std::ceil(path.length() / step - 1e-9));
    check(count);
    for (double k = 1; k <= count; ++k) {
        const Vec3 to = k == count ? path.pieces().back().points.back()
                                   : path.at(path.length() * k / count).position;
        text += chord(to, course.speed(path.length() * (k - 0.5) / count));
    }
    return text;
}

/// Makes chords even in u; a chord is as long as its piece of path within the tolerance.
std::string by_tolerance(const PathTable& path, const SpeedCourse& course, double tolerance) {
    std::string text;
    const std::vector<double> starts = path.starts();
    double total = 0;
    for (std::size_t i = 0; i < path.pieces().size(); ++i) {
        const BezierPiece& piece = path.pieces()[i];
        const double count = chords_for(piece, tolerance);
        check(total += count);
        Vec3 from = piece.points.front();
        double s = starts[i];
        for (double k = 1; k <= count; ++k) {
            const Vec3 to = k == count ? piece.points.back() : piece.at(k / count).r;
            const double length = (to - from).norm();
            text += chord(to, course.speed(std::min(s + length / 2, path.length())));
            s += length;
            from = to;
        }
    }
    return text;
}

std::string exact(const PathTable& path, const SpeedCourse& course) {
    const bool in_space = !is_plane(path.pieces());
    const std::vector<double> starts = path.starts();
    std::string text;
    for (std::size_t i = 0; i < path.pieces().size(); ++i) {
        const Points& points = path.pieces()[i].points;
        const std::string feed = feed_word(course.speed((starts[i] + starts[i + 1]) / 2));
        if (points.size() == 4) {
            text += g5_block({points[0], points[1], points[2], points[3]}, in_space) + feed + "\n";
        } else {
            text += g52_blocks(points, in_space, feed);
        }
    }
    return text;
}

}  // namespace

bool is_plane(const std::vector<BezierPiece>& pieces) {
    const double z = pieces.front().points.front().z();
    return std::all_of(pieces.begin(), pieces.end(), [z](const BezierPiece& piece) {
        return std::all_of(piece.points.begin(), piece.points.end(),
                           [z](const Vec3& point) { return std::abs(point.z() - z) <= kStill; });
    });
}

std::string idle_gcode(const PathTable& path, const SpeedCourse& course,
                       const GcodeChoice& choice) {
    switch (choice.form) {
        case GcodeForm::kStep:
            return by_step(path, course, choice.size);
        case GcodeForm::kTolerance:
            return by_tolerance(path, course, choice.size);
        default:
            return exact(path, course);
    }
}

}  // namespace curvecore::ref
