// SPDX-License-Identifier: Apache-2.0
#include "ref/path/tube_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace curvecore::ref {
namespace {

constexpr int kRefinements = 24;
constexpr std::size_t kMostKnots = 50;  // times those at first
constexpr double kUneven = 4;           // neighbouring spans
constexpr double kStrongTurn = 0.3;     // rad: spans are cut there
constexpr double kFull = 0.97;          // of the tolerance
// Of the jerk, by the speeds of the last curve: the first one says little more than these.
constexpr std::array<TubeSpline::Stages, 3> kWeightings{{{0, 2}, {1, 3}, {1, 3}}};

/// A span's middle, or its sharpest joint.
double cut_of(double a, double b, const std::vector<Site>& sites) {
    double cut = (a + b) / 2;
    double most = kStrongTurn;
    const auto first = std::lower_bound(sites.begin(), sites.end(), a + (b - a) / 8,
                                        [](const Site& site, double s) { return site.s < s; });
    for (auto site = first; site != sites.end() && site->s < b - (b - a) / 8; ++site) {
        if (site->turn > most) {
            most = site->turn;
            cut = site->s;
        }
    }
    return cut;
}

std::vector<double> refined(const TubeSpline& tube, double tolerance,
                            const std::vector<Site>& sites) {
    const CubicSpline& spline = tube.spline();
    std::vector<double> knots{spline.knot(0)};
    for (std::size_t i = 0; i < spline.spans(); ++i) {
        if (tube.deviation(i) > kFull * tolerance) {
            knots.push_back(cut_of(spline.knot(i), spline.knot(i + 1), sites));
        }
        knots.push_back(spline.knot(i + 1));
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
            const double width = knots[i + 1] - knots[i];
            const bool far =
                (i > 0 && width > kUneven * (knots[i] - knots[i - 1])) ||
                (i + 2 < knots.size() && width > kUneven * (knots[i + 2] - knots[i + 1]));
            if (!far) continue;
            knots.insert(knots.begin() + static_cast<std::ptrdiff_t>(i) + 1, knots[i] + width / 2);
            changed = true;
        }
    }
    return knots;
}

std::vector<double> first_speeds(const CubicSpline& spline, const std::vector<Site>& sites) {
    std::vector<double> speeds;
    auto site = sites.begin();
    for (std::size_t span = 0; span < spline.spans(); ++span) {
        const double middle = (spline.knot(span) + spline.knot(span + 1)) / 2;
        while (site + 1 != sites.end() && (site + 1)->s <= middle) ++site;
        speeds.push_back(site->speed);
    }
    return speeds;
}

std::vector<double> speeds_of(const CubicSpline& spline, const Pace& pace) {
    std::vector<double> middles;
    std::vector<double> speeds;
    for (std::size_t span = 0; span < spline.spans(); ++span) {
        const double h = spline.width(span);
        middles.push_back(spline.knot(span) + h / 2);
        const Cubic cubic = from_bezier(spline.bezier(span));
        const double bend =
            std::max(cubic.acceleration(0).norm(), cubic.acceleration(1).norm()) / (h * h);
        speeds.push_back(pace.at(pace.speed, bend, cubic.jerk().norm() / (h * h * h)));
    }
    pace.sweep(middles, speeds);
    std::vector<double> smooth = speeds;
    for (std::size_t i = 1; i + 1 < speeds.size(); ++i) {
        smooth[i] = (speeds[i - 1] + 2 * speeds[i] + speeds[i + 1]) / 4;
    }
    return smooth;
}

}  // namespace

std::vector<TubePiece> tube_run(const ProgrammedPath& path, const TubeTask& task,
                                const Pace& pace) {
    const std::vector<Site> sites = tube_sites(path, task.from, task.to, task.tolerance, pace);
    std::vector<double> knots = tube_knots(sites, task.knots);
    std::optional<TubeSpline> tube;
    bool found = false;
    const std::size_t most = kMostKnots * knots.size();
    for (int round = 0; !found && round < kRefinements && knots.size() < most; ++round) {
        if (round > 0) knots = refined(*tube, task.tolerance, sites);
        tube.emplace(path, task.tolerance, knots, task.start, task.end);
        found = tube->fit();
    }
    if (!found) return {};
    std::vector<double> speeds = first_speeds(tube->spline(), sites);
    for (const TubeSpline::Stages& stages : kWeightings) {
        tube->smooth(speeds, stages);
        speeds = speeds_of(tube->spline(), pace);
    }
    std::vector<TubePiece> pieces;
    for (std::size_t span = 0; span < tube->spline().spans(); ++span) {
        const double s = tube->spline().knot(span);
        pieces.push_back(
            {s, tube->spline().knot(span + 1), tube->spline().bezier(span), tube->deviation(span)});
        if (span > 0) pieces[span].points[0] = pieces[span - 1].points[3];
    }
    return pieces;
}

}  // namespace curvecore::ref
