// SPDX-License-Identifier: Apache-2.0
// Random motions of one axis for the step generator: positions whose steps stay below a rate.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "ref/numeric/step_crossings.hpp"

namespace curvecore::tb {

/// Returns floor(position scale / 2^bits), in wide integers.
inline int64_t exact_place(int64_t position, int64_t scale, int bits) {
    const ref::StepCrossings::Wide product = ref::StepCrossings::Wide(position) * scale;
    return static_cast<int64_t>(product >> bits);
}

class StepMotion {
  public:
    enum class Kind { kWander, kReverse, kRipple, kMiddles, kKinds };

    /// Creates a motion of at most `most` steps per sample.
    template <class Random>
    StepMotion(Random& random, int fine_bits, int scale_bits, double most)
        : bits_(fine_bits), range_((int64_t{1} << (fine_bits - 1)) - 1) {
        kind_ = static_cast<Kind>(random() % static_cast<unsigned>(Kind::kKinds));
        // Steps in the whole range, so that the axis finds room for some samples at full speed.
        const int least = std::min(scale_bits - 1, 20 + static_cast<int>(std::log2(1 + most)));
        const int scale_log2 = least + static_cast<int>(random() % (scale_bits - least));
        scale_ = int64_t{1} << scale_log2;
        if (kind_ != Kind::kMiddles) scale_ += static_cast<int64_t>(random() % scale_);
        units_ = most * std::exp2(fine_bits + 16) / static_cast<double>(scale_);
        position_ = last_ = static_cast<int64_t>(random() % range_) - range_ / 2;
    }

    int64_t scale() const { return scale_; }
    int64_t position() const { return position_; }

    template <class Random>
    int64_t next(Random& random) {
        wander(random);
        if (kind_ == Kind::kReverse) speed_ = -speed_;
        const bool seeks = kind_ == Kind::kRipple || kind_ == Kind::kMiddles;
        if (seeks && random() % 2 == 0) seek_middle();
        if (kind_ == Kind::kRipple && random() % 16 != 0) {
            position_ = last_ + static_cast<int64_t>(random() % 3) - 1;
        }
        const auto most = static_cast<int64_t>(units_);
        position_ = std::clamp(position_, last_ - most, last_ + most);
        position_ = std::clamp(position_, -range_, range_);
        last_ = position_;
        return position_;
    }

  private:
    template <class Random>
    void wander(Random& random) {
        if (random() % 4 == 0) {
            const double part = static_cast<double>(random() % 4001) / 2000 - 1;
            speed_ = units_ * part * std::exp2(-static_cast<int>(random() % 4));
            if (random() % 8 == 0) speed_ = part < 0 ? -units_ : units_;
            if (random() % 16 == 0) speed_ = 0;
        }
        const auto moved = static_cast<int64_t>(speed_);
        if (std::abs(position_ + moved) > range_) speed_ = -speed_;
        position_ += static_cast<int64_t>(speed_);
    }

    /// Moves down to a place just below a middle between two steps, or on it.
    void seek_middle() {
        const int64_t here = exact_place(position_, scale_, bits_);
        const int64_t beyond = (here - 32768) & 65535;
        const double units = static_cast<double>(beyond) * std::exp2(bits_) / scale_;
        position_ -= static_cast<int64_t>(std::ceil(units));
    }

    int bits_;
    int64_t range_;
    Kind kind_;
    int64_t scale_ = 0;
    double units_ = 0;  // greatest change of the position per sample
    double speed_ = 0;
    int64_t position_ = 0;
    int64_t last_ = 0;
};

}  // namespace curvecore::tb
