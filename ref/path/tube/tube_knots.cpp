// SPDX-License-Identifier: Apache-2.0
#include "ref/path/tube/tube_knots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ref/curve/angle_between.hpp"

namespace curvecore::ref {
namespace {

constexpr double kSpanTime = 3.5e-3;  // s, time of a cubic with constant r'''
constexpr double kSpanTurn = 0.5;     // rad
constexpr double kSlope = 0.6;        // slope of the width of spans by s
constexpr double kCorner = 4.53;      // tolerances over sin(turn / 2): a span beside a corner
constexpr double kReach = 3;          // tolerances: length of chords for turns
constexpr std::array<double, 3> kChords{12, 48, 200};  // tolerances: lengths of chords for bends
constexpr double kLeastSpans = 6;                      // three points are given at each end

double turn_at(const ProgrammedPath& path, double s, double reach) {
    const Vec3 here = path.position(s);
    const Vec3 in = here - path.position(std::max(0.0, s - reach));
    const Vec3 out = path.position(std::min(path.length(), s + reach)) - here;
    return angle_between(in, out);
}

/// Integral of 1 / width between sites, the width being a tent of slope kSlope.
struct Tent {
    double length, before, after;

    double top() const { return (after - before + kSlope * length) / (2 * kSlope); }
    double sum(double x) const {
        const double rise = std::min(x, top());
        double total = std::log1p(kSlope * rise / before) / kSlope;
        if (x > top()) {
            const double high = before + kSlope * top();
            total -= std::log1p(-kSlope * (x - top()) / high) / kSlope;
        }
        return total;
    }
    double place(double of_sum) const {
        const double half = sum(top());
        if (of_sum <= half) return before * std::expm1(kSlope * of_sum) / kSlope;
        const double high = before + kSlope * top();
        return top() - high * std::expm1(-kSlope * (of_sum - half)) / kSlope;
    }
};

Tent tent(const std::vector<Site>& sites, std::size_t i) {
    return {sites[i + 1].s - sites[i].s, sites[i].width, sites[i + 1].width};
}

}  // namespace

SeenBend seen_bend(const ProgrammedPath& path, double s, double tolerance) {
    SeenBend seen;
    double least = std::numeric_limits<double>::infinity();
    for (const double reach : kChords) {
        const double chord = reach * tolerance;
        const Vec3 here = path.position(s);
        const Vec3 in = (here - path.position(std::max(0.0, s - chord))).normalized();
        const Vec3 out = (path.position(std::min(path.length(), s + chord)) - here).normalized();
        if (reach == kChords.front()) {
            seen.direction = (in + out).normalized();
            seen.turn = angle_between(in, out);
        }
        const double bend = angle_between(in, out) / chord;
        if (bend >= least) continue;
        least = bend;
        const Vec3 across = (out - in) - (out - in).dot(seen.direction) * seen.direction;
        seen.bend = bend * across.normalized();
    }
    return seen;
}

double seen_turn(const ProgrammedPath& path, double s, double tolerance) {
    return turn_at(path, s, kReach * tolerance);
}

std::vector<Site> tube_sites(const ProgrammedPath& path, double from, double to, double tolerance,
                             const Pace& pace) {
    std::vector<double> places{from};
    for (std::size_t i = path.piece_at(from); i < path.pieces().size() && places.back() < to; ++i) {
        const ProgrammedPath::Piece& piece = path.pieces()[i];
        const double start = places.back();
        const double end = std::min(to, piece.end());
        if (!(end > start)) continue;
        const double longest = kSpanTime * pace.velocity.along(piece.cubic.velocity(0.5));
        const int parts = std::max(1, static_cast<int>((end - start) / longest));
        for (int part = 1; part < parts; ++part) {
            places.push_back(start + (end - start) * part / parts);
        }
        places.push_back(end);
    }
    std::vector<Site> sites;
    std::vector<PacePlace> paced;
    std::vector<double> bends;
    for (const double s : places) {
        // Takes the least of chords of several lengths: a joint of the path is no curvature.
        SeenBend seen = seen_bend(path, s, tolerance);
        const double turn = seen_turn(path, s, tolerance);
        const double own = turn / (kReach * tolerance);
        if (own < seen.bend.norm()) seen.bend *= own / seen.bend.norm();
        sites.push_back({s, turn, 0, 0});
        paced.push_back({s, seen.direction, pace.at(seen.direction, seen.bend, Vec3::Zero())});
        bends.push_back(seen.bend.norm());
    }
    pace.sweep(paced);
    for (std::size_t i = 0; i < sites.size(); ++i) {
        Site& site = sites[i];
        site.speed = paced[i].speed;
        const double bend = bends[i];
        site.width = kSpanTime * site.speed;
        if (site.turn > 0) {
            site.width = std::min(site.width, kCorner * tolerance / std::sin(site.turn / 2));
        }
        if (bend > 0) {
            site.width = std::min({site.width, kSpanTurn / bend,
                                   std::pow(24 * tolerance / (bend * bend * bend), 0.25)});
        }
    }
    even_widths(sites);
    return sites;
}

void even_widths(std::vector<Site>& sites) {
    const auto even = [&](std::size_t i, std::size_t j) {
        const double most = sites[i].width + kSlope * std::abs(sites[j].s - sites[i].s);
        sites[j].width = std::min(sites[j].width, most);
    };
    for (std::size_t i = 1; i < sites.size(); ++i) even(i - 1, i);
    for (std::size_t i = sites.size(); i-- > 1;) even(i, i - 1);
}

std::vector<double> tube_knots(const std::vector<Site>& sites, const std::vector<double>& fixed) {
    double all = 0;
    for (std::size_t i = 0; i + 1 < sites.size(); ++i) {
        all += tent(sites, i).sum(sites[i + 1].s - sites[i].s);
    }
    const double finer = std::max(1.0, kLeastSpans / all);
    std::vector<double> knots{sites.front().s};
    std::vector<double> ends = fixed;
    ends.push_back(sites.back().s);
    std::size_t i = 0;
    for (const double end : ends) {  // section by section, evenly
        const std::size_t first = i;
        double sum = 0;
        for (; i + 1 < sites.size() && sites[i + 1].s <= end; ++i) {
            sum += tent(sites, i).sum(sites[i + 1].s - sites[i].s);
        }
        const auto spans = std::max(1, static_cast<int>(std::ceil(finer * sum - 1e-9)));
        double reached = 0;
        std::size_t j = first;
        for (int k = 1; k < spans; ++k) {
            const double want = sum * k / spans;
            double own = tent(sites, j).sum(sites[j + 1].s - sites[j].s);
            while (reached + own < want && j + 2 < sites.size()) {
                reached += own;
                ++j;
                own = tent(sites, j).sum(sites[j + 1].s - sites[j].s);
            }
            knots.push_back(sites[j].s + tent(sites, j).place(want - reached));
        }
        knots.push_back(end);
    }
    return knots;
}

}  // namespace curvecore::ref
