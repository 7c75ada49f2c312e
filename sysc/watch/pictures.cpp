// SPDX-License-Identifier: Apache-2.0
#include "sysc/watch/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace curvecore::sysc {

Pictures::Pictures(const Job& job, std::uint64_t ticks)
    : span_(static_cast<std::uint64_t>(std::max(1.0, std::round(kSpan / job.plan.tick_s)))),
      span_s_(static_cast<double>(span_) * job.plan.tick_s),
      quantum_mm_(std::ldexp(job.plan.unit_mm, -16)),
      unit_mm_(job.plan.unit_mm),
      length_(std::max<std::uint64_t>(job.plan.path_length(), 1)),
      ticks_(std::max<std::uint64_t>(ticks, 1)),
      errors_(kBins, 0.0),
      bounds_(kBins, 0.0) {
    const auto bins = static_cast<std::size_t>(
        std::min<std::uint64_t>(kBins, std::max<std::uint64_t>(ticks_ / span_, 1)));
    speed_.resize(bins);
    acceleration_.resize(bins);
    total_.resize(bins);
    jerk_.resize(bins);
    path_.reserve(2 * kPoints);
}

std::size_t Pictures::path_bin(std::uint64_t s) const {
    const double part = static_cast<double>(s) / static_cast<double>(length_);
    return std::min(static_cast<std::size_t>(part * kBins), kBins - 1);
}

void Pictures::tick(std::int64_t ds, double curvature) {
    gathered_ += ds;
    if (++tick_ % span_ != 0) return;
    const double speed = static_cast<double>(gathered_) * quantum_mm_ / span_s_;
    gathered_ = 0;
    const double acceleration = (speed - speed_now_) / span_s_;
    const double jerk = (acceleration - acceleration_now_) / span_s_;
    const auto bin =
        static_cast<std::size_t>(static_cast<double>(std::min(tick_ - 1, ticks_ - 1)) /
                                 static_cast<double>(ticks_) * static_cast<double>(speed_.size()));
    speed_[bin].add(speed);
    acceleration_[bin].add(acceleration);
    // Where the curve stands still, the curvature is infinite and the speed is not yet that of it.
    const double across = std::isfinite(curvature) ? speed * speed * curvature / unit_mm_ : 0;
    total_[bin].add(std::hypot(acceleration, across));
    jerk_[bin].add(jerk);
    speed_now_ = speed;
    acceleration_now_ = acceleration;
}

bool Pictures::wants(std::uint64_t s, std::size_t segment, bool at_end) const {
    if (path_.empty()) return true;
    const std::uint64_t moved = s - path_.back().s;
    const bool corner = at_end || segment != last_segment_;
    return moved >= length_ / kPoints + 1 || (corner && moved >= length_ / (4 * kPoints) + 1) ||
           (s == length_ && moved > 0);
}

void Pictures::sample(std::uint64_t s, std::size_t segment, const ref::Vec3& point, bool at_end) {
    if (!wants(s, segment, at_end)) return;
    path_.push_back({s, point, speed_now_});
    last_segment_ = segment;
}

void Pictures::error(std::uint64_t s, double error, double bound) {
    const std::size_t bin = path_bin(s);
    errors_[bin] = std::max(errors_[bin], error);
    bounds_[bin] = std::max(bounds_[bin], bound);
}

}  // namespace curvecore::sysc
