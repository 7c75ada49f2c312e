// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/terminal/device_clock.hpp"

#include <fmt/format.h>

#include "sysc/cli/usage_error.hpp"
#include "sysc/cost/cost_model.hpp"

namespace curvecore::sysc {

void take_device(Options& options) {
    if (options.device.empty()) return;
    const Device& device = *device_of(options.device);
    options.core.multiplier_form = device.form;
    if (options.clock_set) return;
    const Core core = core_for(true, options.core.splines != 0, options.core.build);
    const auto cost = estimate(core, options.core, device);
    if (!cost) {
        throw UsageError(fmt::format(
            "--device {}: there are no measured runs of the {} build for it yet: say --clock",
            device.name, build_name(options.core.build)));
    }
    if (!cost->mhz) throw UsageError(clock_unknown(device));
    options.clock_hz = *cost->reached();
}

}  // namespace curvecore::sysc
