// SPDX-License-Identifier: Apache-2.0
#include "sysc/cam/cam_options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ref/program/program_reader.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {

void complete(CamOptions& options) {
    if (!ref::is_points_file(options.common.file)) {
        throw UsageError(fmt::format("{}: a cam table is a .csv", options.common.file));
    }
    if ((options.kappa > 0) == (options.scallop > 0)) {
        throw UsageError(
            "give the helix by --kappa N (half-turns per section) or by --scallop and --cutter");
    }
    if (options.scallop > 0 && options.cutter == 0) {
        throw UsageError("--scallop wants the radius of the cutter: --cutter");
    }
    if (options.scallop > 0 && options.scallop >= options.cutter) {
        throw UsageError("--scallop must be lower than the cutter's radius");
    }
    options.feed = options.common.points.feed;
    if (options.generatrix && !ref::has_generatrix(options.kind.surface)) {
        throw UsageError(
            fmt::format("--generatrix is for --surface tamm and blend; {} has cubics",
                        ref::kSurfaceNames.at(static_cast<std::size_t>(options.kind.surface))));
    }
    options.kind.generatrix = options.generatrix.value_or(ref::Generatrix::kParabola);
}

ref::CamHelix helix_of(const CamOptions& options, int angles, double dx) {
    ref::CamHelix helix;
    helix.kind = options.kind;
    helix.delta = options.delta;
    helix.ends = options.ends;
    helix.kappa = options.kappa;
    if (helix.kappa == 0) {
        helix.kappa =
            ref::kappa_for(ref::scallop_pitch(options.cutter, options.scallop), dx, angles);
    }
    const double steps = ref::CamPath::intervals(helix.kappa, angles);
    if (steps < 0.5 || std::abs(steps - std::round(steps)) > ref::kWholeIntervals) {
        throw UsageError(fmt::format(
            "--kappa {:g}: kappa n / 2 = {:g} x {} / 2 = {:g} must be a whole number above 0",
            helix.kappa, helix.kappa, angles, steps));
    }
    return helix;
}

}  // namespace curvecore::sysc
