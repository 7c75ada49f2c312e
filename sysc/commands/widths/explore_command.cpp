// SPDX-License-Identifier: Apache-2.0
// `curvecore explore`: the shortest queues that a program does not outrun, for each host.
#include <fmt/format.h>

#include <algorithm>

#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/progress_bar.hpp"
#include "sysc/commands/options/part_options.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/part/planned_job.hpp"
#include "sysc/commands/terminal/device_clock.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/commands/terminal/json_result.hpp"
#include "sysc/commands/terminal/output_folder.hpp"
#include "sysc/commands/terminal/summary.hpp"
#include "sysc/commands/widths/commands.hpp"
#include "sysc/explore/explore_report.hpp"

namespace curvecore::sysc {
namespace {

struct ExploreOptions {
    PartOptions part;
    std::vector<double> host_s;
    std::vector<double> word_s;
};

/// Reads what the setting NAME of --system takes.
auto setting(const char* name, double SystemSettings::*member) {
    return [=](const std::string&, const std::string& text) {
        SystemSettings settings;
        set_system(settings, fmt::format("{}={}", name, text));
        return settings.*member;
    };
}

/// Returns the values ascending, each once.
template <class Value>
std::vector<Value> ascending(std::vector<Value> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

int explore_command(ExploreOptions& asked) {
    Options options = asked.part.complete();
    const CoreChoice& core = asked.part.core;
    ExploreGrid grid;
    grid.host_s = ascending(asked.host_s);
    grid.word_s = ascending(asked.word_s);
    grid.sample_s = core.sample_periods_s.empty() ? std::vector{options.sample_period_s}
                                                  : ascending(core.sample_periods_s);
    grid.segment_queue = ascending(core.segment_queues_words);
    grid.profile_queue = ascending(core.profile_queues_words);

    const InterruptGuard guard;
    hold_input(options);
    JobStream stream(options);
    const Job planned = plan_and_check(stream);
    OutputFolder folder(options.folder);
    constexpr std::uint64_t kParts = 1000;
    std::optional<ProgressBar> bar(std::in_place, kParts, options.quiet,
                                   ProgressBar::Counts::kParts);
    const auto progress = [&bar](double share) {
        InterruptGuard::check();
        bar->update(static_cast<std::uint64_t>(share * kParts));
    };
    const std::vector<ExploreRow> rows = Explorer(planned.options, grid, progress).explore();
    bar.reset();  // before the first line of the results
    const ExploreReport report{planned, grid, rows};
    const nlohmann::ordered_json json = report.json();
    folder.write("explore.json", json.dump(1) + "\n");
    folder.write("explore.html", report.html());
    folder.commit();
    print_warnings(planned);
    if (options.json) {
        print_json(json);
    } else if (!options.quiet) {
        fmt::print("{}report  {}/explore.html\n", report.table(), options.folder);
    }
    return report.answered() ? 0 : 3;
}

}  // namespace

void add_explore(CLI::App& app, int& status) {
    auto [command, asked] =
        add_command(app, status, "explore", "the shortest queues that FILE needs", explore_command);
    PartOptions& part = asked.part;
    part.options.board = BoardKind::kSystemc;
    add_common(command, part,
               {true, "256,512,1024,2048,4096,8192", "64,128,256,512,1024,2048,4096"});
    begin_group(command, group::kBoard);
    add_value(command, "--host", asked.host_s, "LIST", "from one look of the host to the next",
              list_of(setting("host", &SystemSettings::host_s)))
        ->default_val("1ms,20ms,100ms,500ms");
    add_value(command, "--word", asked.word_s, "LIST", "of a word of 48 bits on the bus",
              list_of(setting("word", &SystemSettings::word_s)))
        ->default_val("1us,500us");
    add_value(command, "--jitter", part.options.system.jitter_s, "TIME",
              "the host looks up to so much later, at random",
              setting("jitter", &SystemSettings::jitter_s))
        ->default_val("0ms");
    command.footer(
        "--segment-queue, --profile-queue and --sample-period take lists, too.\n"
        "Exit status: 0 there is an answer; 2 the input is wrong; 3 no queues fit any host.");
}

}  // namespace curvecore::sysc
