// SPDX-License-Identifier: Apache-2.0
// A job drawn by a board into a folder, for `run` and for every command that makes a program.
#pragma once

#include <functional>

#include "sysc/commands/terminal/output_folder.hpp"
#include "sysc/cores/compiled_core.hpp"
#include "sysc/report/report.hpp"
#include "sysc/watch/samples_writer.hpp"

namespace curvecore::sysc {

/// Extra work of a command on its run.
struct RunExtras {
    TakeSample sample;  // called in a thread of the run
    /// Writes more files before the folder is published; returns false if a check of the command
    /// failed.
    std::function<bool(const Report& report, OutputFolder& folder)> finish;
};

class Runner {
  public:
    /// Plans the job and finds or builds its core.
    /// @throws ref::InputError, UsageError
    explicit Runner(Options options);

    const Job& job() const { return job_; }

    /// Draws the job, checks every sample, writes and publishes the folder. Returns the exit
    /// status.
    int run(OutputFolder& folder, const RunExtras& extras = {});

  private:
    Job job_;
    MakeBoard* make_ = nullptr;  // of a Verilated core; null: the kernel
};

}  // namespace curvecore::sysc
