// SPDX-License-Identifier: Apache-2.0
// A model of an axis: a drive of the second order with dry friction, and its encoder.
//
//     x'' = w^2 (u - x) - 2 D w x' - friction against the motion       u: where the steps point
//
// At a constant speed v the axis lags by 2 D v / w + friction / w^2.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sysc/core/system_settings.hpp"

namespace curvecore::sysc {

class DriveAxis {
  public:
    /// Creates an axis that advances by `period` seconds at a time.
    DriveAxis(const AxisSettings& settings, double step_mm, double period)
        : settings_(settings),
          step_mm_(step_mm),
          omega_(2 * M_PI * settings.frequency_hz),
          parts_(static_cast<int>(std::ceil(omega_ * period / kLargestPart))),
          part_(period / parts_) {}

    void step(bool back) { count_ += back ? -1 : 1; }

    void advance() {
        for (int n = 0; n < parts_; ++n) move();
        worst_ = std::max(worst_, std::abs(following_error()));
    }

    double command() const { return static_cast<double>(count_) * step_mm_; }
    double place() const { return place_; }
    /// Following error at the drive, mm: the steps' place less the encoder's.
    double following_error() const {
        return command() - std::floor(place_ / settings_.encoder_mm + 0.5) * settings_.encoder_mm;
    }
    double worst_following_error() const { return worst_; }

  private:
    /// Largest step as a share of 1 / w, for which the sums below are within a percent of the
    /// equation.
    static constexpr double kLargestPart = 0.02;

    void move() {
        const double driven =
            omega_ * (omega_ * (command() - place_) - 2 * settings_.damping * speed_);
        const double against = speed_ != 0 ? speed_ : driven;
        const double next = speed_ + part_ * (driven - std::copysign(settings_.friction, against));
        // Friction stops an axis and holds it; it never reverses it.
        speed_ = against * next <= 0 && std::abs(driven) <= settings_.friction ? 0 : next;
        place_ += part_ * speed_;
    }

    AxisSettings settings_;
    double step_mm_;
    double omega_;
    int parts_;
    double part_;
    std::int64_t count_ = 0;
    double place_ = 0;  // mm
    double speed_ = 0;
    double worst_ = 0;
};

}  // namespace curvecore::sysc
