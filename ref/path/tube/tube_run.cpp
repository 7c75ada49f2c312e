// SPDX-License-Identifier: Apache-2.0
#include "ref/path/tube/tube_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace curvecore::ref {
namespace {

constexpr int kRefinements = 24;
constexpr std::size_t kMostKnots = 50;      // times the first number
constexpr double kUneven = 4;               // ratio of neighbouring spans
constexpr double kStrongTurn = 0.3;         // rad: spans are cut at sharper turns
constexpr double kFull = 0.97;              // share of the tolerance
constexpr double kChange = 0.35;            // share of the jerk limit: jump of r''' v^3 at a knot
constexpr double kLongestSpanTime = 12e-3;  // s, a span where r''' hardly changes
// Newton's stages: first with the speeds of the programmed path, then with those of the curve.
constexpr TubeSpline::Stages kRough{0, 2};
constexpr TubeSpline::Stages kFine{1, 3};

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
    std::vector<PacePlace> places;
    for (std::size_t span = 0; span < spline.spans(); ++span) {
        const double h = spline.width(span);
        const Bezier points = spline.bezier(span);
        const Cubic cubic = from_bezier(points);
        const Vec3 direction = (points[3] - points[0]).normalized();
        const Vec3 swerve = cubic.jerk() / (h * h * h);
        const auto at = [&](double end) {
            return pace.at(direction, cubic.acceleration(end) / (h * h), swerve);
        };
        places.push_back({spline.knot(span) + h / 2, direction, std::min(at(0), at(1))});
    }
    pace.sweep(places);
    std::vector<double> smooth;
    smooth.reserve(places.size());
    for (const PacePlace& place : places) smooth.push_back(place.speed);
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
        smooth[i] = (places[i - 1].speed + 2 * places[i].speed + places[i + 1].speed) / 4;
    }
    return smooth;
}

/// Places for knots on the present curve: r''' is constant between them, so they are close where it
/// changes much at the machine's speed there.
std::vector<Site> change_sites(const CubicSpline& spline, const std::vector<double>& speeds,
                               const Pace& pace) {
    std::vector<Vec3> thirds;
    for (std::size_t span = 0; span < spline.spans(); ++span) {
        const double h = spline.width(span);
        thirds.push_back(from_bezier(spline.bezier(span)).jerk() / (h * h * h));
    }
    std::vector<Site> sites;
    for (std::size_t i = 0; i <= spline.spans(); ++i) {
        const std::size_t before = i > 0 ? i - 1 : 0;
        const std::size_t after = std::min(i, spline.spans() - 1);
        const double v = std::min(speeds[before], speeds[after]);
        const double jump = v * v * v * pace.jerk.load(thirds[after] - thirds[before]);
        const double apart = (spline.width(before) + spline.width(after)) / 2;
        sites.push_back({spline.knot(i), 0, v, kLongestSpanTime * v});
        if (jump > 0) sites[i].width = std::min(sites[i].width, kChange / jump * apart);
    }
    even_widths(sites);
    return sites;
}

/// Returns a spline within the tube, with more knots where it needs them; none if there is none.
std::optional<TubeSpline> kept(const ProgrammedPath& path, const TubeTask& task,
                               const std::vector<Site>& sites, std::vector<double> knots) {
    std::optional<TubeSpline> tube;
    const std::size_t most = kMostKnots * knots.size();
    for (int round = 0; round < kRefinements && knots.size() < most; ++round) {
        if (round > 0) knots = refined(*tube, task.tolerance, sites);
        tube.emplace(path, task.tolerance, knots, task.start, task.end);
        if (tube->fit()) return tube;
    }
    return std::nullopt;
}

}  // namespace

std::vector<TubePiece> tube_run(const ProgrammedPath& path, const TubeTask& task,
                                const Pace& pace) {
    const std::vector<Site> sites = tube_sites(path, task.from, task.to, task.tolerance, pace);
    std::optional<TubeSpline> tube = kept(path, task, sites, tube_knots(sites, task.knots));
    if (!tube) return {};
    tube->smooth(first_speeds(tube->spline(), sites), kRough);
    const std::vector<Site> seen =
        change_sites(tube->spline(), speeds_of(tube->spline(), pace), pace);
    if (auto thinned = kept(path, task, sites, tube_knots(seen, task.knots))) {
        tube = std::move(thinned);
        tube->smooth(first_speeds(tube->spline(), seen), kRough);
    }
    tube->smooth(speeds_of(tube->spline(), pace), kFine);
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
