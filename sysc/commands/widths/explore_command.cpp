// SPDX-License-Identifier: Apache-2.0
// `curvecore explore`: the shortest queues that a program does not outrun, for each host.
#include "sysc/commands/widths/explore_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/progress_bar.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/commands/part/commands.hpp"
#include "sysc/commands/part/planned_job.hpp"
#include "sysc/commands/terminal/device_clock.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/commands/terminal/output_folder.hpp"
#include "sysc/commands/terminal/summary.hpp"
#include "sysc/explore/explore_report.hpp"

namespace curvecore::sysc {
namespace {

std::vector<std::string> items_of(const char* option, const std::string& list) {
    std::vector<std::string> items;
    std::istringstream stream(list);
    for (std::string item; std::getline(stream, item, ',');) items.push_back(item);
    if (items.empty()) throw UsageError(fmt::format("{}: a list is expected", option));
    return items;
}

/// Reads each item as the option of one value does; ascending, each once.
template <class Value, class Read>
std::vector<Value> list_of(const char* option, const std::string& list, Read&& read) {
    std::vector<Value> values;
    for (const std::string& item : items_of(option, list)) values.push_back(read(item));
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::vector<double> times_of(const char* name, const std::string& list,
                             double SystemSettings::*member) {
    const std::string option = fmt::format("--{}", name);
    return list_of<double>(option.c_str(), list, [&](const std::string& item) {
        SystemSettings settings;
        set_system(settings, fmt::format("{}={}", name, item));
        return settings.*member;
    });
}

/// Reads the values of an option, each as its single value is read.
template <class Value>
std::vector<Value> values_of(const char* option, const RawOptions& raw,
                             std::string RawOptions::*text, const Options& options,
                             Value Options::*member) {
    return list_of<Value>(option, raw.*text, [&](const std::string& item) {
        RawOptions one = raw;
        one.sample_period.clear();
        one.segment_queue = RawOptions().segment_queue;
        one.profile_queue = RawOptions().profile_queue;
        one.*text = item;
        Options read = options;
        interpret(one, read);
        return read.*member;
    });
}

}  // namespace

RawExplore::RawExplore() {
    common.segment_queue = "256,512,1024,2048,4096,8192";
    common.profile_queue = "64,128,256,512,1024,2048,4096";
}

void add_explore(CLI::App& command, RawExplore& explore) {
    begin_group(command, group::kBoard);
    const auto add = [&command](const char* name, std::string& text, const char* type,
                                const char* help) {
        command.add_option(name, text, help)->type_name(type)->capture_default_str();
    };
    add("--host", explore.host, "LIST", "from one look of the host to the next");
    add("--word", explore.word, "LIST", "of a word of 48 bits on the bus");
    add("--jitter", explore.jitter, "TIME", "the host looks up to so much later, at random");
    command.footer(
        "--segment-queue, --profile-queue and --sample-period take lists, too.\n"
        "Exit status: 0 there is an answer; 2 the input is wrong; 3 no queues fit any host.");
}

int explore_command(const RawExplore& explore, Options options) {
    RawOptions raw = explore.common;
    ExploreGrid grid;
    grid.host_s = times_of("host", explore.host, &SystemSettings::host_s);
    grid.word_s = times_of("word", explore.word, &SystemSettings::word_s);
    if (!raw.sample_period.empty()) {
        grid.sample_s = values_of("--sample-period", raw, &RawOptions::sample_period, options,
                                  &Options::sample_period_s);
    }
    grid.segment_queue = values_of("--segment-queue", raw, &RawOptions::segment_queue, options,
                                   &Options::segment_queue_words);
    grid.profile_queue = values_of("--profile-queue", raw, &RawOptions::profile_queue, options,
                                   &Options::profile_queue_words);
    raw.on = "systemc";
    raw.system = {"jitter=" + explore.jitter};
    raw.sample_period.clear();
    raw.segment_queue = fmt::format("{}", grid.segment_queue.back());
    raw.profile_queue = fmt::format("{}", grid.profile_queue.back());
    interpret(raw, options);
    if (grid.sample_s.empty()) grid.sample_s = {options.sample_period_s};
    options.sample_period_s = grid.sample_s.front();

    const InterruptGuard guard;
    hold_input(options);
    JobStream stream(options);
    const Job planned = plan_and_check(stream);
    OutputFolder folder(options.folder);
    constexpr std::uint64_t kParts = 1000;
    std::optional<ProgressBar> bar(std::in_place, kParts, options.quiet);
    const auto progress = [&bar](double share) {
        InterruptGuard::check();
        bar->update(static_cast<std::uint64_t>(share * kParts));
    };
    const std::vector<ExploreRow> rows = Explorer(planned.options, grid, progress).explore();
    bar.reset();  // before the first line of the results
    const ExploreReport report{planned, grid, rows};
    folder.write("explore.json", report.json().dump(1) + "\n");
    folder.write("explore.html", report.html());
    folder.commit();
    print_warnings(planned);
    if (!options.quiet) fmt::print("{}report  {}/explore.html\n", report.table(), options.folder);
    return report.answered() ? 0 : 3;
}

}  // namespace curvecore::sysc
