// SPDX-License-Identifier: Apache-2.0
// The rest of a held program, planned anew from where the axes stand. It begins as fast as the
// machine may; time that is let run again has to respect bounds for whatever is drawn then.
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <memory>

#include "sysc/wire/word_source.hpp"

namespace curvecore::sysc {

class RestPlan {
  public:
    using Check = std::function<void(const WordSource& rest)>;

    /// @param options of the program, which is a file, as planning has completed them
    /// @param check throws UsageError if a rest begins elsewhere than where the axes stand
    RestPlan(Options options, Check check);

    /// Begins to plan the rest behind the path drawn, in a thread of its own, at this override.
    /// Returns false if one that nobody waits for any more is still being read.
    bool plan(const DrawnBefore& before, double percent);
    /// Returns true while its first words are not there.
    bool plans() const;
    /// Returns the source of the rest's words; null: they are not there, cannot be planned, or the
    /// file has changed.
    std::unique_ptr<WordSource> take();
    /// Returns true if the rest begins where the axes stand, once their last steps are made.
    bool fits(const WordSource& rest) const;

  private:
    Options options_;
    double quantum_mm_;  // of the path
    Check check_;
    std::filesystem::file_time_type written_;
    std::future<std::unique_ptr<WordSource>> planned_;
};

}  // namespace curvecore::sysc
