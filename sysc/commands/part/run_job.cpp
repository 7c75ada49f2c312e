// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/part/run_job.hpp"

#include "sysc/board/feeder.hpp"
#include "sysc/board/kernel_board.hpp"
#include "sysc/cache/core_cache.hpp"
#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/progress_bar.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/commands/part/planned_job.hpp"
#include "sysc/commands/part/publish.hpp"
#include "sysc/cores/compiled_core.hpp"
#include "sysc/cores/gtkw_writer.hpp"
#include "sysc/system/pin_gtkw.hpp"
#include "sysc/system/system_board.hpp"
#include "sysc/watch/board_run.hpp"
#include "sysc/words/path_source.hpp"

namespace curvecore::sysc {
namespace {

/// Makes the board; `make` is that of a Verilated core, null for the kernel.
std::unique_ptr<Board> make_board(const Job& job, MakeBoard* make, const std::string& waveform,
                                  const std::string& pins) {
    const Options& options = job.options;
    const BoardSettings settings = board_settings(job);
    std::unique_ptr<Board> board;
    if (make == nullptr) {
        const QueueDepths asked{options.segment_queue_words, options.profile_queue_words};
        board = std::make_unique<KernelBoard>(options.core, settings,
                                              options.in_system() ? asked : QueueDepths());
    } else {
        board.reset(
            make({settings, options.stall_seed, waveform, options.trace_clocks, options.clock_hz}));
    }
    if (!options.in_system()) return board;
    return make_system_board(job, std::move(board), make_machine(job), pins);
}

/// Checks that the core has a path: that of the serial build has none; and that there is RTL.
void check_motion(const Options& options) {
    for (const auto& [name, given] :
         {std::pair("--rtl", !options.rtl.empty()), std::pair("--dut", !options.dut.empty())}) {
        if (!given || options.needs_rtl()) continue;
        throw UsageError(fmt::format("{}: with --on rtl or systemc-rtl", name));
    }
    if (!options.rtl.empty() && !options.dut.empty()) {
        throw UsageError("--rtl or --dut: one of them draws");
    }
    if (options.core.build != Build::kSerial || options.board == BoardKind::kKernel) return;
    throw UsageError(
        "--build serial: a curve core alone, which no motion has inside: take --build engine, or "
        "--on kernel");
}

}  // namespace

Runner::Runner(Options options) {
    check_motion(options);
    hold_input(options);
    JobStream stream(options);
    CoreParameters& core = stream.options().core;
    const bool own = options.rtl.empty() && options.dut.empty();
    const CompiledCore* const built_in =
        options.needs_rtl() && own ? find_core(stream.options()) : nullptr;
    if (built_in != nullptr) {
        const int form = core.multiplier_form;
        core = built_in->parameters;
        core.multiplier_form = form;
        make_ = built_in->make;
    }
    job_ = plan_and_check(stream);
    add_other_forms(job_);
    if (options.needs_rtl() && built_in == nullptr) {
        make_ = CoreCache(options.rtl, options.dut).open(job_.options.core, options.quiet);
    }
}

int Runner::run(OutputFolder& folder, const RunExtras& extras) {
    const InterruptGuard guard;
    const Options& options = job_.options;
    const std::uint64_t samples =
        count_samples(job_.plan, options.samples_per_tick_log2(), options.override_word());
    Pictures pictures(job_, samples / static_cast<std::uint64_t>(options.samples_per_tick));
    SamplesWriter writer(folder.path("samples.csv"), job_, samples, extras.sample);
    std::optional<ProgressBar> bar(std::in_place, samples, options.quiet);
    const std::string waveform =
        options.trace && options.needs_rtl() ? folder.path("waves.fst") : "";
    const std::string pins = options.trace && options.in_system() ? folder.path("system") : "";
    const auto progress = [&](std::uint64_t done) {
        InterruptGuard::check();
        bar->update(done);
    };
    std::unique_ptr<Board> board = make_board(job_, make_, waveform, pins);
    const BoardResult drawn = [&] {
        try {
            return run_board(*board, {job_, samples, writer, pictures, progress});
        } catch (const BoardError& error) {
            throw BoardError(fmt::format("{}; its words are for {} {}", error.what(),
                                         build_name(options.core.build),
                                         ref::parameters_text(options.core)));
        }
    }();
    bar.reset();    // before the first line of the results
    board.reset();  // closes the waveform
    writer.close();

    const Report report{job_, samples, drawn.check.drawn, &drawn, drawn.period_clocks};
    if (!pins.empty())
        folder.write("system.gtkw",
                     pin_gtkw(options.folder, axis_names(job_), report.duration_s()));
    if (!waveform.empty()) {
        folder.write("waves.gtkw", gtkw(options.core, waveform, options.folder,
                                        {options.clock_hz, drawn.first_clock}));
    }
    const bool held = !extras.finish || extras.finish(report, folder);
    const int status = publish(report, pictures, folder);
    return held ? status : 1;
}

}  // namespace curvecore::sysc
