// SPDX-License-Identifier: Apache-2.0
#include "sysc/watch/pictures.hpp"

#include <algorithm>
#include <cmath>

#include "ref/machine/path_quantum.hpp"

namespace curvecore::sysc {

Pictures::Pictures(const Job& job, std::uint64_t ticks)
    : span_(static_cast<std::uint64_t>(std::max(1.0, std::round(kSpan / job.plan.tick_s)))),
      span_s_(static_cast<double>(span_) * job.plan.tick_s),
      quantum_mm_(ref::path_quantum_mm(job.machine, job.plan.unit_mm)),
      length_(std::max<std::uint64_t>(job.plan.path_length(), 1)),
      ticks_(std::max<std::uint64_t>(ticks, 1)),
      duration_s_(static_cast<double>(ticks_) * job.plan.tick_s),
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

void Pictures::add(std::vector<Envelope>& bins, double time, double value) const {
    if (time < 0 || time >= duration_s_) return;
    const auto bin =
        static_cast<std::size_t>(time / duration_s_ * static_cast<double>(bins.size()));
    bins[std::min(bin, bins.size() - 1)].add(value);
}

void Pictures::watch(LimitMeter& meter) {
    window_ = meter.look_with([this](double end, double acceleration, double jerk) {
        add(total_, end - window_->seconds / 2, acceleration);
        add(jerk_, end - window_->seconds, jerk);
    });
}

void Pictures::tick(std::int64_t ds) {
    gathered_ += ds;
    if (++tick_ % span_ != 0) return;
    const double speed = static_cast<double>(gathered_) * quantum_mm_ / span_s_;
    gathered_ = 0;
    const double acceleration = (speed - speed_now_) / span_s_;
    const double time = static_cast<double>(tick_ - 1) / static_cast<double>(ticks_) * duration_s_;
    add(speed_, time, speed);
    add(acceleration_, time, acceleration);
    speed_now_ = speed;
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
    const double time = static_cast<double>(tick_) / static_cast<double>(ticks_) * duration_s_;
    path_.push_back({s, point, speed_now_, time, segment});
    last_segment_ = segment;
}

void Pictures::error(std::uint64_t s, double error, double bound) {
    const std::size_t bin = path_bin(s);
    errors_[bin] = std::max(errors_[bin], error);
    bounds_[bin] = std::max(bounds_[bin], bound);
}

}  // namespace curvecore::sysc
