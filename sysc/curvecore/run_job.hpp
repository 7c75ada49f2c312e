// SPDX-License-Identifier: Apache-2.0
// A job drawn by a board into a folder: what `run` does, and every command that makes a program.
#pragma once

#include <functional>

#include "sysc/cores/compiled_core.hpp"
#include "sysc/curvecore/output_folder.hpp"
#include "sysc/report/report.hpp"
#include "sysc/watch/samples_writer.hpp"

namespace curvecore::sysc {

/// What a command wants of a run besides its report.
struct RunExtras {
    TakeSample sample;  // in a thread of the run's own
    /// Before the folder is published: writes more files; false: a check of the command's failed.
    std::function<bool(const Report& report, OutputFolder& folder)> finish;
};

class Runner {
  public:
    /// Plans the job and finds or makes its core.
    /// @throws ref::InputError, UsageError
    explicit Runner(Options options);

    const Job& job() const { return job_; }

    /// Draws the job, checks every sample, writes and publishes the folder. The exit status.
    int run(OutputFolder& folder, const RunExtras& extras = {});

  private:
    Job job_;
    MakeBoard* make_ = nullptr;  // of a Verilated core, null for the kernel
};

}  // namespace curvecore::sysc
