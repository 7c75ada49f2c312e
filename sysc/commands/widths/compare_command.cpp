// SPDX-License-Identifier: Apache-2.0
// `curvecore compare`: configurations through the bit-true kernel, side by side.
#include <fmt/format.h>

#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/number_list.hpp"
#include "sysc/commands/options/part_options.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/commands/terminal/json_result.hpp"
#include "sysc/commands/terminal/output_folder.hpp"
#include "sysc/commands/terminal/summary.hpp"
#include "sysc/commands/widths/commands.hpp"
#include "sysc/compare/compare_report.hpp"

namespace curvecore::sysc {
namespace {

/// Reads one whole number from `low` to `high`.
auto single_in(int low, int high) {
    return [=](const std::string& option, const std::string& text) {
        const std::vector<int> numbers = number_list(option, text, low, high);
        if (numbers.size() > 1) {
            throw UsageError(fmt::format("{} '{}': one number is expected", option, text));
        }
        return numbers.front();
    };
}

/// Reads a list as list_of() does, and refuses an item that is there twice.
template <class Read>
auto list_of_different(Read read) {
    return [=](const std::string& option, const std::string& text) {
        std::vector<std::string> items = list_items(option, text);
        std::sort(items.begin(), items.end());
        const auto twice = std::adjacent_find(items.begin(), items.end());
        if (twice != items.end()) {
            throw UsageError(fmt::format("{} '{}': {} is there twice", option, text, *twice));
        }
        return list_of(read)(option, text);
    };
}

Scheme scheme_of(const std::string& option, const std::string& text) {
    const auto found = std::find(kSchemeNames.begin(), kSchemeNames.end(), text);
    if (found == kSchemeNames.end()) {
        throw UsageError(
            fmt::format("{} '{}': must be of {}", option, text, fmt::join(kSchemeNames, ", ")));
    }
    return static_cast<Scheme>(found - kSchemeNames.begin());
}

double tick_of(const std::string& option, const std::string& text) {
    return quantity(option, text, {{"us", -6}, {"ms", -3}, {"s", 0}});
}

const auto kTicks = list_of_different(within(tick_of, 1e-6, 10, "in [1us, 10s]"));
const auto kFeeds = list_of_different(speed);
const auto kDevices =
    list_of_different([](const std::string&, const std::string& name) { return device_of(name); });
constexpr const char* kStandardTick = "10ms";
constexpr const char* kStandardFeeds = "1.5m/min,2m/min";

struct CompareChoice {
    PartOptions part;
    CompareOptions compare;
};

CompareOptions& complete(CompareChoice& asked) {
    Options& options = asked.part.options;
    CompareOptions& compare = asked.compare;
    options.exact_path = true;  // the program's own curves
    if (options.file.empty() && options.folder.empty()) options.folder = "curves.out";
    compare.core_given = !asked.part.core.core.empty();
    if (compare.schemes.empty() && !compare.feeds.empty()) {
        if (compare.feeds.size() > 1) {
            throw UsageError(
                "--feed: one along points; lists are for --scheme paper, rk4 and scalar");
        }
        options.points.feed = compare.feeds.front();
    }
    if (std::any_of(compare.schemes.begin(), compare.schemes.end(), is_ticked)) {
        if (compare.ticks.empty()) compare.ticks = kTicks("--tick", kStandardTick);
        if (compare.feeds.empty()) compare.feeds = kFeeds("--feed", kStandardFeeds);
    }
    std::string& device = asked.part.core.said.device;
    if (!device.empty()) {
        compare.devices = kDevices("--device", device);
        device = compare.devices.front()->name;
    }
    compare.common = asked.part.complete();
    compare.builds = {Build::kParallel, Build::kSerial};
    if (asked.part.core.build || compare.core_given) compare.builds = {compare.common.core.build};
    complete(compare);
    return compare;
}

int compare_command(CompareChoice& asked) {
    CompareOptions& options = complete(asked);
    Job job;
    if (options.common.file.empty()) {
        job.program = built_in_curves(options.curves);
        job.machine = unlimited_machine();
    } else {
        refuse_joints(machine_of(options.common), "compare");
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
    CompareReport report{options, job.program, result, {}};
    if (!result.interrupted) report.answers = answers(options, job.program, result);
    const nlohmann::ordered_json json = report.json();
    folder.write("compare.json", json.dump(1) + "\n");
    folder.write("compare.csv", report.csv());
    folder.write("report.html", report.html());
    if (report.answers.size() == 1 && report.answers.front().take) {
        folder.write("core.json", report.answers.front().core(options).json().dump(2) + "\n");
    }
    folder.commit();
    print_warnings(job);
    if (options.common.json) {
        print_json(json);
    } else if (!options.common.quiet) {
        fmt::print("{}{}", report.table(), report.curves_table());
        fmt::print(
            "errors in units of {} at {} places; {} segments with the widest words, {} at most; "
            "{:.1f} s\nreport  {}/report.html\n",
            exact_length(options.common.unit_mm), result.samples, result.reference_segments,
            result.most_segments, result.seconds, options.common.folder);
        fmt::print("\n{}", report.answer_text());
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

}  // namespace

void add_compare(CLI::App& app, int& status) {
    auto [command, asked] = add_command(
        app, status, "compare",
        "orders, widths and samplers through the bit-true kernel, side by side", compare_command);
    CompareOptions& compare = asked.compare;
    add_file(command, asked.part);
    add_value(command, "--feed", compare.feeds, "LIST",
              fmt::format("of the schemes that step once a tick; {} if not given", kStandardFeeds),
              kFeeds);
    add_surroundings(command, asked.part);
    add_core(command, asked.part.core);
    command.get_option("--device")
        ->type_name("LIST")
        ->description(fmt::format("those that the answer is for: {}; default {}", device_names(),
                                  kComparedDevice));
    begin_group(command, "Comparison");
    add_choice(command, "--curves", compare.curves, kCurveSets,
               "without FILE, built-in curves: {}");
    add_values(command, "--set", compare.set, "NAME=LIST",
               fmt::format("values of a parameter, 4,6 or 4:8 or 4:8:2; {} if not given: {}",
                           fmt::join(kComparedSets, " "), ref::parameter_names()),
               [](const std::string&, const std::string& text) { return read_parameter(text); });
    add_value(command, "--scheme", compare.schemes, "LIST",
              fmt::format("of splines, side by side: {}; the last three step once a tick",
                          fmt::join(kSchemeNames, ", ")),
              list_of_different(scheme_of));
    add_value(command, "--tick", compare.ticks, "LIST",
              fmt::format("their ticks: 10ms, 250us; {} if not given", kStandardTick), kTicks);
    add_value(command, "--segments", compare.sweep.times_segments, "TIMES",
              "segments that a plan may have, in times of those with the widest words",
              single_in(1, 1000))
        ->default_val(compare.sweep.times_segments);
    add_value(command, "--samples", compare.sweep.samples, "N",
              "places at which each configuration is compared", single_in(100, 10000000))
        ->default_val(compare.sweep.samples);
}

}  // namespace curvecore::sysc
