// SPDX-License-Identifier: Apache-2.0
// Search for the shortest queues: a program drawn by systems with the kernel, one for each queue,
// host, bus and sample period.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "sysc/job/job.hpp"

namespace curvecore::sysc {

struct ExploreGrid {
    std::vector<double> sample_s;
    std::vector<double> word_s;
    std::vector<double> host_s;
    std::vector<int> segment_queue;  // words, ascending
    std::vector<int> profile_queue;

    std::size_t size() const {
        return sample_s.size() * word_s.size() * host_s.size() * segment_queue.size() *
               profile_queue.size();
    }
};

/// Result of a program with two queues. It slows where it takes over a hundredth longer than with
/// the longest queues, because moves that do not outlast a stop in them are planned slower. It
/// holds where one of them runs low; it never begins where a full queue does not last for a stop.
enum class Fate { kFits, kSlows, kHolds, kNeverBegins };
constexpr std::array<std::string_view, 4> kFateNames{"fits", "slows", "holds", "never begins"};

/// Values that stay the same while the queues are swept.
struct Surroundings {
    double sample_s;
    double word_s;
    double host_s;
};

struct ExplorePoint {
    int segment_queue;
    int profile_queue;
    Fate fate;
    double duration_s;  // planned duration
    double stop_s;      // longest stop of a hold: fewer stop branches fit shorter queues
};

/// A row of all pairs of queues, the longest of each first.
struct ExploreRow {
    Surroundings surroundings;
    std::vector<ExplorePoint> points;

    /// Returns the fitting pair with the fewest words.
    std::optional<ExplorePoint> answer() const;
};

class Explorer {
  public:
    /// Creates the search; `options` tell what draws the program; `progress` is called with the
    /// finished share.
    Explorer(const Options& options, const ExploreGrid& grid,
             std::function<void(double share)> progress);

    /// @throws ref::InputError, UsageError: plan_job()
    std::vector<ExploreRow> explore();

  private:
    std::vector<ExploreRow> explore_period(double sample_s);
    /// Adds one more point to each row.
    void explore_queues(int segment_queue, int profile_queue, std::vector<ExploreRow>& rows);

    const Options& options_;
    const ExploreGrid& grid_;
    std::function<void(double share)> progress_;
    double done_ = 0;
};

}  // namespace curvecore::sysc
