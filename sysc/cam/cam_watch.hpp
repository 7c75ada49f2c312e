// SPDX-License-Identifier: Apache-2.0
// Checks a drawn cam against surfaces: maps every sample from the core's positions to (x, theta,
// rho).
#pragma once

#include "ref/cam/cam_shape.hpp"
#include "sysc/job/job.hpp"

namespace curvecore::sysc {

/// Errors of samples, mm, and where the worst is.
struct SurfaceError {
    double most = 0;
    double square_sum = 0;
    double x = 0, degrees = 0;

    void add(double error, double at_x, double at_degrees);
    double rms(std::uint64_t samples) const;
};

/// Worst error of the samples in each cell of a grid, signed, mm; NaN where there is none.
class ErrorMap {
  public:
    static constexpr int kAround = 180;
    static constexpr int kAlong = 160;

    ErrorMap(double first_x, double last_x);
    void add(double x, double degrees, double error);
    const std::vector<double>& cells() const { return cells_; }  // row after row along x

  private:
    double first_x_;
    double per_mm_;
    std::vector<double> cells_;
};

/// | held against | what                                                                         |
/// |--------------|------------------------------------------------------------------------------|
/// | the surface  | that the helix was cut on: no further than delta, the jump where the piece   |
/// |              | begins, and (1 + |drho/dtheta| + |drho/dx|) length units (theta in degrees)  |
/// | the truth    | a finer table, or the table's tensor surface: an error, shown                |
class CamWatch {
  public:
    /// Creates the check; `jumps` holds for every move the surface's jump where the move begins,
    /// mm.
    CamWatch(const ref::CamShape& surface, const ref::CamShape& truth, double delta,
             const std::vector<float>& jumps);

    /// Sets the job whose segments name the moves; to be called before the first sample.
    void draws(const Job& job);
    void sample(std::size_t segment, const std::int64_t* position);

    std::uint64_t samples() const { return samples_; }
    const SurfaceError& from_surface() const { return from_surface_; }
    const SurfaceError& from_truth() const { return from_truth_; }
    /// Returns the worst error from the surface as a share of the allowed error: the check.
    double of_allowed() const { return of_allowed_; }
    const ErrorMap& surface_map() const { return surface_map_; }
    const ErrorMap& truth_map() const { return truth_map_; }

  private:
    double jump_at(std::size_t move) const;

    const ref::CamShape& surface_;
    const ref::CamShape& truth_;
    double delta_;
    const std::vector<float>& jumps_;
    const Job* job_ = nullptr;
    double unit_ = 0;
    std::uint64_t samples_ = 0;
    SurfaceError from_surface_;
    SurfaceError from_truth_;
    double of_allowed_ = 0;
    ErrorMap surface_map_;
    ErrorMap truth_map_;
};

}  // namespace curvecore::sysc
