// SPDX-License-Identifier: Apache-2.0
// `curvecore run`: plan, words, a board, every sample checked, report.
#include "sysc/commands/part/commands.hpp"
#include "sysc/commands/part/run_job.hpp"

namespace curvecore::sysc {

int run_command(const Options& options) {
    Runner runner(options);
    OutputFolder folder(options.folder);
    return runner.run(folder);
}

}  // namespace curvecore::sysc
