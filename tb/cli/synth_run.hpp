// SPDX-License-Identifier: Apache-2.0
// A run of scripts/synth.py as a user starts it, with Yosys and nextpnr replaced by
// tb/cli/tools/fake_synthesis.py, and results in the test's own folder.
#pragma once

#include <string>
#include <vector>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb {

class SynthRun : public ProgramRun {
  public:
    /// Creates the run; `tools`: the installed ones of yosys, nextpnr-ecp5, sbatch ..
    explicit SynthRun(const std::vector<std::string>& tools = {"yosys", "nextpnr-ecp5"});

    /// Runs synth.py with `options` and --output out.
    ProgramResult synth(const std::vector<std::string>& options) const;
    /// Runs a script of /bin/sh; $SYNTH is the program, $HLS scripts/hls.py, with --output out.
    ProgramResult shell(const std::string& script) const;
    /// Returns the number of times that a tool ran.
    int runs(const std::string& tool) const;
};

}  // namespace curvecore::tb
