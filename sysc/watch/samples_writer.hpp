// SPDX-License-Identifier: Apache-2.0
// The file samples.csv: one row per sample, written as fast as the simulation makes them.
#pragma once

#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "sysc/job/job.hpp"

namespace curvecore::sysc {

/// Receiver of a sample's segment and its position as the board returned it.
using TakeSample = std::function<void(std::size_t segment, const std::int64_t* position)>;

class SamplesWriter {
  public:
    /// Creates the file. The first, the last and every n-th of `samples` samples get a row, so that
    /// the job's options are not exceeded. `also` receives all samples.
    /// @throws std::runtime_error when the file cannot be written
    SamplesWriter(const std::string& file, const Job& job, std::uint64_t samples,
                  TakeSample also = {});

    /// Writes a row; `position` has 3 + aux_axes words.
    void row(std::uint64_t k, std::size_t segment, std::uint64_t s, const std::int64_t* position);

    /// @throws std::runtime_error when the disk is full
    void close();

  private:
    void append(std::uint64_t k, std::size_t segment, std::uint64_t s,
                const std::int64_t* position);
    void flush();

    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    int axes_;
    std::uint64_t samples_;
    std::uint64_t stride_;
    TakeSample also_;
    std::string buffer_;
};

}  // namespace curvecore::sysc
