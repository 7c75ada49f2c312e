// SPDX-License-Identifier: Apache-2.0
// The whole of a program as it will be drawn, while it is planned a second ahead: for who watches.
#pragma once

#include <atomic>
#include <thread>

#include "sysc/job/options.hpp"
#include "sysc/panel/planned_path.hpp"

namespace curvecore::sysc {

class Forecast {
  public:
    /// Begins to plan the program in a thread of its own; an error ends that without a word, since
    /// whoever draws the program meets it, too.
    explicit Forecast(const Options& options);
    ~Forecast();
    Forecast(const Forecast&) = delete;
    Forecast& operator=(const Forecast&) = delete;

    /// Returns the path, as far as it is planned.
    PlannedPath& path() { return path_; }
    /// Returns true once that is all of it.
    bool all() const { return all_; }

  private:
    void plan(Options options);

    PlannedPath path_;
    std::atomic<bool> all_ = false;
    std::atomic<bool> stop_ = false;
    std::thread thread_;  // last member: it uses the others
};

}  // namespace curvecore::sysc
