// SPDX-License-Identifier: Apache-2.0
// Data of the report's pictures, thinned out while the samples pass: memory and report stay small
// however long the program is.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "sysc/job/job.hpp"
#include "sysc/watch/limit_meter.hpp"

namespace curvecore::sysc {

/// Least and largest value of a stretch.
struct Envelope {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value) {
        if (value < low) low = value;
        if (value > high) high = value;
    }
    bool empty() const { return low > high; }
};

struct PathPoint {
    std::uint64_t s;  // quanta
    ref::Vec3 point;  // length units
    double feed;      // mm/s along the path
    double time;      // s
    std::size_t segment;
};

class Pictures {
  public:
    static constexpr std::size_t kBins = 1200;
    static constexpr std::uint64_t kPoints = 12000;
    static constexpr double kSpan = 1e-4;  // s: over less, differences show the quanta of s

    Pictures(const Job& job, std::uint64_t ticks);

    /// Shows the values that the meter compares with the limits; to be called before its first
    /// point.
    void watch(LimitMeter& meter);
    /// Adds a tick's increment, quanta.
    void tick(std::int64_t ds);
    /// Returns true if this sample is drawn. Stops and other corners are, unless there are too
    /// many.
    bool wants(std::uint64_t s, std::size_t segment, bool at_end) const;
    void sample(std::uint64_t s, std::size_t segment, const ref::Vec3& point, bool at_end);
    /// Adds a sample's worst error on any axis before rounding, and the bound there, length units.
    void error(std::uint64_t s, double error, double bound);

    const std::vector<PathPoint>& path() const { return path_; }
    std::uint64_t ticks() const { return ticks_; }

    // Over path length
    const std::vector<double>& errors() const { return errors_; }
    const std::vector<double>& bounds() const { return bounds_; }
    // Over time, along the path in mm and s
    const std::vector<Envelope>& speed() const { return speed_; }
    const std::vector<Envelope>& acceleration() const { return acceleration_; }
    // Over time, as vectors: the limited values, over the window that is named
    const std::optional<LimitMeter::Longest>& window() const { return window_; }
    const std::vector<Envelope>& total_acceleration() const { return total_; }
    const std::vector<Envelope>& jerk() const { return jerk_; }

  private:
    std::size_t path_bin(std::uint64_t s) const;
    void add(std::vector<Envelope>& bins, double time, double value) const;

    std::uint64_t span_;  // ticks over which speed is measured
    double span_s_;
    double quantum_mm_;
    std::uint64_t length_;
    std::uint64_t ticks_;
    double duration_s_;
    std::uint64_t tick_ = 0;
    std::int64_t gathered_ = 0;  // quanta in the present span
    double speed_now_ = 0;
    std::optional<LimitMeter::Longest> window_;
    std::size_t last_segment_ = 0;
    std::vector<PathPoint> path_;
    std::vector<double> errors_;
    std::vector<double> bounds_;
    std::vector<Envelope> speed_;
    std::vector<Envelope> acceleration_;
    std::vector<Envelope> total_;
    std::vector<Envelope> jerk_;
};

}  // namespace curvecore::sysc
