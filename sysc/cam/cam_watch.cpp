// SPDX-License-Identifier: Apache-2.0
#include "sysc/cam/cam_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace curvecore::sysc {

void SurfaceError::add(double error, double at_x, double at_degrees) {
    square_sum += error * error;
    if (std::abs(error) <= most) return;
    most = std::abs(error);
    x = at_x;
    degrees = at_degrees;
}

double SurfaceError::rms(std::uint64_t samples) const {
    return samples == 0 ? 0 : std::sqrt(square_sum / static_cast<double>(samples));
}

ErrorMap::ErrorMap(double first_x, double last_x)
    : first_x_(first_x),
      per_mm_(kAlong / (last_x - first_x)),
      cells_(static_cast<std::size_t>(kAround) * kAlong, std::numeric_limits<double>::quiet_NaN()) {
}

void ErrorMap::add(double x, double degrees, double error) {
    const int row = std::clamp(static_cast<int>((x - first_x_) * per_mm_), 0, kAlong - 1);
    const double turn = degrees / 360 - std::floor(degrees / 360);
    const int column = std::min(static_cast<int>(turn * kAround), kAround - 1);
    double& cell =
        cells_[static_cast<std::size_t>(row) * kAround + static_cast<std::size_t>(column)];
    if (std::isnan(cell) || std::abs(error) > std::abs(cell)) cell = error;
}

CamWatch::CamWatch(const ref::CamShape& surface, const ref::CamShape& truth, double delta,
                   const std::vector<float>& jumps)
    : surface_(surface),
      truth_(truth),
      delta_(delta),
      jumps_(jumps),
      surface_map_(surface.first_x(), surface.last_x()),
      truth_map_(surface.first_x(), surface.last_x()) {}

void CamWatch::draws(const Job& job) {
    if (job.plan.moves.size() != jumps_.size()) {
        throw std::logic_error("a cam's program has a move for every piece, and one to the start");
    }
    job_ = &job;
    unit_ = job.plan.unit_mm;
}

/// Returns the allowed jump: a sample at a piece's end may be read on the next piece's side of it.
double CamWatch::jump_at(std::size_t move) const {
    const double here = jumps_[move];
    return move + 1 < jumps_.size() ? std::max<double>(here, jumps_[move + 1]) : here;
}

void CamWatch::sample(std::size_t segment, const std::int64_t* position) {
    const std::size_t move = job_->plan.segments[segment].move;
    if (job_->plan.moves[move].rapid) return;
    const double rho = static_cast<double>(position[0]) * unit_;
    const double x = static_cast<double>(position[2]) * unit_;
    const double degrees = static_cast<double>(position[3]) * unit_;
    const ref::CamShape::Place place = surface_.at(x, degrees);
    const double error = rho - place.rho;
    const double units = (1 + std::abs(place.by_theta) * M_PI / 180 + std::abs(place.by_x)) * unit_;
    ++samples_;
    from_surface_.add(error, x, degrees);
    surface_map_.add(x, degrees, error);
    of_allowed_ = std::max(of_allowed_, std::abs(error) / (delta_ + jump_at(move) + units));
    const double missed = rho - truth_.at(x, degrees).rho;
    from_truth_.add(missed, x, degrees);
    truth_map_.add(x, degrees, missed);
}

}  // namespace curvecore::sysc
