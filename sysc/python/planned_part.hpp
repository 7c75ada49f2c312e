// SPDX-License-Identifier: Apache-2.0
// A part that is planned, and drawn by the bit-true kernel, for other languages: its words and
// positions as plain arrays.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sysc/job/job.hpp"

namespace curvecore::sysc {

class PlannedPart {
  public:
    /// Plans a part. @param arguments FILE and options, as `curvecore plan` takes them
    /// @throws ref::InputError, UsageError
    explicit PlannedPart(const std::vector<std::string>& arguments);

    const Job& job() const { return job_; }
    /// Number of axes that are drawn.
    int axes() const { return job_.options.core.axes(); }

    /// Words of 48 bits, as the bus carries them (hls/words.hpp).
    std::vector<std::uint64_t> segment_words() const;
    std::vector<std::uint64_t> profile_words() const;

    /// Samples one after the other, each with axes() numbers.
    struct Samples {
        std::vector<std::int64_t> position;  // length units
        std::vector<std::int64_t> fine;      // before rounding: 2^-GuardBits length units
    };
    /// Draws the part: its start, and the samples that follow; the RTL gives the same words.
    Samples draw() const;

  private:
    Job job_;
};

}  // namespace curvecore::sysc
