// SPDX-License-Identifier: Apache-2.0
// `curvecore choose`: the smallest configuration that is proven to keep a wish.
#include "tb/program/choose_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "tb/choose/choose_report.hpp"
#include "tb/command/interrupt.hpp"
#include "tb/program/output_folder.hpp"

namespace curvecore::tb {
namespace {

constexpr std::size_t kListed = 5;

}  // namespace

int choose_command(const ChooseOptions& options) {
    const InterruptGuard guard;
    std::optional<OutputFolder> folder;
    if (!options.folder.empty()) folder.emplace(options.folder);
    const auto begin = std::chrono::steady_clock::now();
    ChooseReport report{options.wish, Chooser(options.wish).smallest(kListed), {}, {}, 0};
    if (report.choices.empty()) report.concessions = concessions(options.wish);
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    bool held = true;
    if (options.confirm && !report.choices.empty()) {
        const Choice& winner = report.choices.front();
        try {
            report.confirmation = place_and_route(winner.candidate, *options.wish.device);
        } catch (const ConfirmationError& error) {
            fmt::print(stderr, "curvecore: --confirm: {}\n", error.what());
            return 1;
        }
        const double needed = std::max(winner.need.least(), options.wish.clock_hz.value_or(0));
        held = report.confirmation->mhz * 1e6 >= needed;
    }
    if (folder) {
        folder->write("choose.json", report.json().dump(2) + "\n");
        folder->commit();
    }
    if (!options.quiet) fmt::print("{}", report.text());
    if (report.choices.empty()) return kImpossibleWish;
    if (!held) fmt::print(stderr, "curvecore: check failed: slower than the wish needs\n");
    return held ? 0 : 1;
}

}  // namespace curvecore::tb
