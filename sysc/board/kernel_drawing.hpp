// SPDX-License-Identifier: Apache-2.0
// A job drawn by the kernel, for who wants its samples and nothing compared.
#pragma once

#include <functional>

#include "sysc/board/board.hpp"
#include "sysc/job/job.hpp"

namespace curvecore::sysc {

/// Returns the place at which a job begins; the first sample follows it.
Sample start_of(const Job& job);

/// Number of a job's samples.
std::uint64_t count_samples(const Job& job);

/// Draws a job of so many samples, and hands over each. Returns how the board ends.
BoardStatus draw_by_kernel(const Job& job, std::uint64_t samples,
                           const std::function<void(const Sample& sample)>& take);

}  // namespace curvecore::sysc
