// SPDX-License-Identifier: Apache-2.0
// `curvecore run`: plan, words, RTL, every sample checked, report.
#include "tb/command/interrupt.hpp"
#include "tb/command/progress_bar.hpp"
#include "tb/program/commands.hpp"
#include "tb/program/gtkw_writer.hpp"
#include "tb/program/output_folder.hpp"
#include "tb/program/path_source.hpp"
#include "tb/program/publish.hpp"

namespace curvecore::tb {

int run_command(const Options& options) {
    if (options.aux_axes_set) find_core(options);  // before the file is looked at
    Job job = read_job(options);
    const CompiledCore& core = find_core(job.options);
    job.options.core = core.parameters;
    plan_job(job);

    const InterruptGuard guard;
    OutputFolder folder(options.folder);
    const std::uint64_t samples =
        count_samples(job.plan, options.samples_per_tick_log2(), options.override_word());
    Pictures pictures(job, samples / static_cast<std::uint64_t>(options.samples_per_tick));
    SamplesWriter writer(folder.path("samples.csv"), job);
    ProgressBar bar(samples, options.quiet);
    const std::string waveform = options.trace ? folder.path("waves.fst") : "";
    const auto progress = [&bar](std::uint64_t done) {
        InterruptGuard::check();
        bar.update(done);
    };
    const RtlResult rtl = core.run({job, samples, writer, pictures, waveform, progress});
    writer.close();

    const Report report{job, samples, &rtl};
    if (options.trace) folder.write("waves.gtkw", gtkw(core.parameters, waveform, options.folder));
    return publish(report, pictures, folder);
}

}  // namespace curvecore::tb
