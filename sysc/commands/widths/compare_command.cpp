// SPDX-License-Identifier: Apache-2.0
// `curvecore compare`: configurations through the bit-true kernel, side by side.
#include "sysc/commands/widths/compare_command.hpp"

#include <fmt/format.h>

#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/quantity.hpp"
#include "sysc/commands/part/commands.hpp"
#include "sysc/commands/terminal/output_folder.hpp"
#include "sysc/commands/terminal/summary.hpp"
#include "sysc/compare/compare_report.hpp"

namespace curvecore::sysc {
int compare_command(CompareOptions options) {
    Job job;
    if (options.common.file.empty()) {
        job.program = built_in_curves(options.curves);
        job.machine = unlimited_machine();
    } else {
        job = read_job(options.common);
    }
    check_ticked(job.program, options);
    complete_settings(job.program, options.settings);
    complete_settings(job.program, options.drawn);
    const InterruptGuard guard;
    OutputFolder folder(options.common.folder);
    const SweepResult result = sweep(job.program, job.machine, options.drawn, options.sweep);
    if (result.rows.empty()) {
        fmt::print(stderr, "curvecore: interrupted: no configuration is finished\n");
        return 130;
    }
    const CompareReport report{options, job.program, result};
    folder.write("compare.json", report.json().dump(1) + "\n");
    folder.write("compare.csv", report.csv());
    folder.write("report.html", report.html());
    folder.commit();
    print_warnings(job);
    if (!options.common.quiet) {
        fmt::print("{}{}", report.table(), report.curves_table());
        fmt::print(
            "errors in units of {} at {} places; {} segments with the widest words, {} at most; "
            "{:.1f} s\nreport  {}/report.html\n",
            exact_length(options.common.unit_mm), result.samples, result.reference_segments,
            result.most_segments, result.seconds, options.common.folder);
    }
    if (!report.held()) {
        fmt::print(stderr,
                   "curvecore: check failed: an error beyond its derived bound, or an end "
                   "that is missed\n");
    }
    if (result.interrupted) {
        fmt::print(stderr, "curvecore: interrupted: {} of {} configurations are in {}\n",
                   result.rows.size(), report.asked(), options.common.folder);
        return 130;
    }
    return report.held() ? 0 : 1;
}

}  // namespace curvecore::sysc
