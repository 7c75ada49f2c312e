// SPDX-License-Identifier: Apache-2.0
// `curvecore choose`: the smallest configuration that is proven to meet a requirement.
#include "sysc/commands/widths/choose_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "sysc/choose/choose_report.hpp"
#include "sysc/cli/interrupt.hpp"
#include "sysc/commands/terminal/output_folder.hpp"

namespace curvecore::sysc {
namespace {

constexpr std::size_t kListed = 5;

}  // namespace

int choose_command(const ChooseOptions& options) {
    const InterruptGuard guard;
    std::optional<OutputFolder> folder;
    if (!options.folder.empty()) {
        folder.emplace(options.folder);
    } else if (options.confirm) {  // not committed
        folder.emplace((std::filesystem::temp_directory_path() / "curvecore-choose").string());
    }
    const auto begin = std::chrono::steady_clock::now();
    ChooseReport report{
        options.requirement, Chooser(options.requirement).smallest(kListed), {}, {}, 0};
    if (report.choices.empty()) report.relaxations = relaxations(options.requirement);
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    bool held = true;
    if (folder && !report.choices.empty()) {
        folder->write("core.json", report.core().json().dump(2) + "\n");
    }
    if (options.confirm && !report.choices.empty()) {
        const Choice& winner = report.choices.front();
        try {
            report.confirmation = place_and_route(folder->path("core.json"));
        } catch (const ConfirmationError& error) {
            fmt::print(stderr, "curvecore: --confirm: {}\n", error.what());
            return 1;
        }
        const double needed =
            std::max(winner.need.least(), options.requirement.clock_hz.value_or(0));
        held = report.confirmation->mhz * 1e6 >= needed;
    }
    if (!options.folder.empty()) {
        folder->write("choose.json", report.json().dump(2) + "\n");
        folder->commit();
    }
    if (!options.quiet) fmt::print("{}", report.text());
    if (report.choices.empty()) return kImpossible;
    if (!held) fmt::print(stderr, "curvecore: check failed: slower than the requirement needs\n");
    return held ? 0 : 1;
}

}  // namespace curvecore::sysc
