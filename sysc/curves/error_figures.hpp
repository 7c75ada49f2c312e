// SPDX-License-Identifier: Apache-2.0
// Worst, root mean square and the 99.9 % point of errors, a million at a time.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace curvecore::sysc {

constexpr double kSpeedChord = 1000;  // units: below it, one position's rounding hides the speed

struct ErrorFigures {
    double worst = 0;
    double rms = 0;
    double most = 0;  // 99.9 % of the errors are no larger
};

/// Counts errors in bins of 1/64 to 1/32 of an octave. The 99.9 % point is the upper edge of its
/// bin, so it is at most 1.6 % too large.
class ErrorCount {
  public:
    void add(double error) {
        const float size = static_cast<float>(std::abs(error));
        if (size > worst_) worst_ = size;
        squares_ += error * error;
        std::uint32_t bits = 0;
        std::memcpy(&bits, &size, sizeof bits);
        ++bins_[bits >> kDropped];
        ++count_;
    }

    ErrorFigures figures() const {
        ErrorFigures figures;
        if (count_ == 0) return figures;
        figures.worst = static_cast<double>(worst_);
        figures.rms = std::sqrt(squares_ / static_cast<double>(count_));
        const std::uint64_t above = count_ / 1000;  // number of errors that may be larger
        std::uint64_t seen = 0;
        for (std::uint32_t i = kBins; i-- > 0;) {
            seen += bins_[i];
            if (seen > above) {
                const std::uint32_t edge = (i + 1) << kDropped;
                float upper = 0;
                std::memcpy(&upper, &edge, sizeof upper);
                figures.most = std::min(static_cast<double>(upper), figures.worst);
                break;
            }
        }
        return figures;
    }

  private:
    // Bits of a float that are dropped; its exponent and six bits of its fraction are kept.
    static constexpr int kDropped = 17;
    static constexpr std::uint32_t kBins = 1U << (31 - kDropped);

    float worst_ = 0;
    double squares_ = 0;
    std::uint64_t count_ = 0;
    std::array<std::uint32_t, kBins> bins_{};
};

}  // namespace curvecore::sysc
