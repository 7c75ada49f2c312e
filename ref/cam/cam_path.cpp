// SPDX-License-Identifier: Apache-2.0
#include "ref/cam/cam_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace curvecore::ref {
namespace {

constexpr double kGridSlack = 1e-6;

double on_grid(double value) { return std::round(value / kCamGrid) * kCamGrid; }

/// Returns the patch along the helix: u = u0 + slope w.
PolarCurve along_helix(const Patch& patch, double u0, double slope) {
    PolarCurve f = PolarCurve::Zero();
    PolarCurve power = PolarCurve::Zero();  // powers of u
    power[0] = 1;
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i <= j; ++i) {
            for (int k = 0; k < 4; ++k) f[i + k] += power[i] * patch(j, k);
        }
        for (int i = j + 1; i > 0; --i) power[i] = power[i] * u0 + power[i - 1] * slope;
        power[0] *= u0;
    }
    return f;
}

/// Greatest d rho / du at the corners of a cell: what a rounding of x costs.
double steepest(const Patch& patch) { return patch.bottomRows<3>().cwiseAbs().sum() * 3; }

}  // namespace

CamPath::CamPath(const CamHelix& helix, int angles, Take take)
    : helix_(helix), angles_(angles), take_(std::move(take)) {
    const double steps = intervals(helix.kappa, angles);
    per_section_ = std::lround(steps);
    if (!(steps > 0.5) || std::abs(steps - static_cast<double>(per_section_)) > kWholeIntervals) {
        throw std::invalid_argument(
            fmt::format("kappa n / 2 = {:g} x {} / 2 = {:g} is not a whole number above 0",
                        helix.kappa, angles, steps));
    }
    if (helix.delta < kLeastDelta) {
        throw std::invalid_argument(
            fmt::format("delta {:g} um is below {:g} um", helix.delta * 1e3, kLeastDelta * 1e3));
    }
}

void CamPath::section(const CamSection& section) {
    if (sections_ == 0) x0_ = section.x;
    if (sections_ == 1) pitch_ = section.x - x0_;
    if (rows_.size() == 4) rows_.pop_front();
    rows_.push_back(section.rho);
    if (++sections_ < 4) return;
    if (sections_ == 4) {
        const std::vector<double> ghost =
            ghost_section({&rows_[0], &rows_[1], &rows_[2], &rows_[3]});
        between({&ghost, &rows_[0], &rows_[1], &rows_[2]}, false);
    }
    between({&rows_[0], &rows_[1], &rows_[2], &rows_[3]}, false);
}

void CamPath::finish() {
    std::vector<const std::vector<double>*> rows;
    for (const std::vector<double>& row : rows_) rows.push_back(&row);
    const std::size_t n = rows.size();
    const std::vector<double> before = ghost_section(rows);
    const std::vector<double> after = ghost_section({rows.rbegin(), rows.rend()});
    if (n == 2) {
        between({&before, rows[0], rows[1], &after}, true);
        return;
    }
    if (n == 3) between({&before, rows[0], rows[1], rows[2]}, false);
    between({rows[n - 3], rows[n - 2], rows[n - 1], &after}, true);
}

/// Makes the pieces between the window's middle sections; `last`: they are the last of all.
void CamPath::between(const SectionWindow& window, bool last) {
    const bool turns = helix_.ends == CamEnds::kTurn;
    if (turns && interval_ == 0) walk(window, angles_, {0, 0});
    walk(window, per_section_, {0, 1. / static_cast<double>(per_section_)});
    if (turns && last) walk(window, angles_, {1, 0});
    ++interval_;
}

void CamPath::walk(const SectionWindow& window, long steps, Advance u) {
    const int parts = has_generatrix(helix_.kind.surface) ? 2 : 1;
    for (long j = 0; j < steps; ++j, ++step_) {
        const int m = static_cast<int>(step_ % angles_);
        const Advance here{u.start + static_cast<double>(j) * u.slope, u.slope};
        for (int half = 0; half < parts; ++half) {
            // A mid-line between sections is a knot, or the middle of an interval of angle.
            const int half_u = here.start + here.slope * (half + 0.5) / parts < 0.5 ? 0 : 1;
            const double from = static_cast<double>(half) / parts;
            cell(surface_patch(helix_.kind, window, m, half_u, half), here, from,
                 from + 1. / parts);
        }
    }
}

/// Makes the pieces in one cell, between `from` and `to` of the interval of angle.
void CamPath::cell(const Patch& patch, Advance u, double from, double to) {
    const PolarCurve f = along_helix(patch, u.start, u.slope);
    // A piece's ends are off by half a grid in rho, and by what half a grid of x makes there.
    const double rounding = kCamGrid / 2 * (1 + steepest(patch) / pitch_);
    if (rounding > helix_.delta / 2) {
        throw std::domain_error(
            fmt::format("the surface is so steep before this section that points of {:g} mm do not "
                        "keep delta {:g} um",
                        kCamGrid, helix_.delta * 1e3));
    }
    const double delta = helix_.delta - rounding;
    double jump = last_ ? std::abs(value(f, from) - last_->rho) - kCamGrid / 2 : 0;
    if (jump < kCamGrid) jump = 0;
    if (!last_) last_ = point(f, u, from);
    for (double w = from; w < to;) {
        const double reach = longest_piece(f, w, to, delta);
        CamPiece piece;
        piece.from = *last_;
        piece.to = point(f, u, reach);
        double w1 = reach;
        if (reach < to) w1 = piece.to.angle * angles_ / 360 - static_cast<double>(step_);
        if (!(piece.to.angle > piece.from.angle)) {
            throw std::domain_error(
                fmt::format("delta {:g} um wants pieces of less than {:g} degrees before this "
                            "section",
                            helix_.delta * 1e3, kCamGrid));
        }
        piece.deviation = chord_deviation(f, w, w1) + rounding;
        piece.jump = jump;
        jump = 0;
        take_(piece);
        last_ = piece.to;
        w = w1;
    }
}

/// Returns the point at w of the interval of angle: its angle on the grid and the radius there.
CamPoint CamPath::point(const PolarCurve& f, Advance u, double w) const {
    const auto step = static_cast<double>(step_);
    CamPoint place;
    const double degrees = (step + w) * 360 / angles_;
    place.angle = std::floor(degrees / kCamGrid + kGridSlack) * kCamGrid;
    const double exact = place.angle * angles_ / 360 - step;
    place.rho = on_grid(value(f, exact));
    const double along = static_cast<double>(interval_) + u.start + u.slope * exact;
    place.x = on_grid(x0_ + pitch_ * along);
    return place;
}

double scallop_pitch(double cutter_radius, double scallop) {
    return 2 * std::sqrt(2 * cutter_radius * scallop - scallop * scallop);
}

double scallop_height(double cutter_radius, double pitch) {
    const double half = pitch / 2;
    return half * half / (cutter_radius + std::sqrt(cutter_radius * cutter_radius - half * half));
}

double kappa_for(double pitch, double dx, int angles) {
    const double half = angles / 2.0;
    return std::ceil(2 * dx / pitch * half - kGridSlack) / half;
}

}  // namespace curvecore::ref
