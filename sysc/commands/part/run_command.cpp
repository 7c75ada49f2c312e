// SPDX-License-Identifier: Apache-2.0
// `curvecore run`: plan, words, a board, every sample checked, report.
#include "sysc/commands/options/part_options.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/part/commands.hpp"
#include "sysc/commands/part/run_job.hpp"

namespace curvecore::sysc {
namespace {

int run_command(PartOptions& part) {
    const Options& options = part.complete();
    Runner runner(options);
    OutputFolder folder(options.folder);
    return runner.run(folder);
}

}  // namespace

void add_run(CLI::App& app, int& status) {
    auto [command, part] = add_command(
        app, status, "run",
        "plan FILE and run it through the Verilated RTL or another board; compare every sample",
        run_command);
    add_common(command, part);
    add_report(command, part);
    add_drawing(command, part);
}

}  // namespace curvecore::sysc
