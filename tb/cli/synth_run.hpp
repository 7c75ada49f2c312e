// SPDX-License-Identifier: Apache-2.0
// scripts/synth.py as a user starts it, with Yosys and nextpnr replaced by
// tb/cli/tools/fake_synthesis.py, results in the test's own folder.
#pragma once

#include <string>
#include <vector>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb {

class SynthRun : public ProgramRun {
  public:
    /// `tools`: those of yosys, nextpnr-ecp5, sbatch .. that are installed.
    explicit SynthRun(const std::vector<std::string>& tools = {"yosys", "nextpnr-ecp5"});

    /// synth.py with `options` and --output out.
    ProgramResult synth(const std::vector<std::string>& options) const;
    /// A script of /bin/sh; $SYNTH is the program, $HLS scripts/hls.py, with --output out.
    ProgramResult shell(const std::string& script) const;
    /// How often a tool ran.
    int runs(const std::string& tool) const;
};

}  // namespace curvecore::tb
