// SPDX-License-Identifier: Apache-2.0
#include "sysc/cam/cam_options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ref/program/program_reader.hpp"
#include "sysc/cli/choice.hpp"
#include "sysc/cli/quantity.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace {

constexpr double kMostKappa = 1e6;

void interpret_helix(const RawCamOptions& raw, CamOptions& options) {
    if (raw.kappa.empty() == raw.scallop.empty()) {
        throw UsageError(
            "give the helix by --kappa N (half-turns per section) or by --scallop and --cutter");
    }
    if (!raw.cutter.empty()) options.cutter = length("--cutter", raw.cutter, 1e-3, 1e4);
    if (!raw.kappa.empty()) {
        options.kappa = quantity("--kappa", raw.kappa, {{"", 0}});
        if (!(options.kappa > 0 && options.kappa <= kMostKappa)) {
            throw UsageError(fmt::format("--kappa must be above 0, up to {:g}", kMostKappa));
        }
        return;
    }
    if (raw.cutter.empty()) {
        throw UsageError("--scallop wants the radius of the cutter: --cutter");
    }
    options.scallop = length("--scallop", raw.scallop, 1e-6, 10);
    if (options.scallop >= options.cutter) {
        throw UsageError("--scallop must be lower than the cutter's radius");
    }
}

}  // namespace

void interpret(const RawCamOptions& raw, CamOptions& options) {
    if (!ref::is_points_file(options.common.file)) {
        throw UsageError(fmt::format("{}: a cam table is a .csv", options.common.file));
    }
    interpret_helix(raw, options);
    options.delta = length("--delta", raw.delta, ref::kLeastDelta, 10);
    options.feed = options.common.points.feed;
    if (!raw.ends.empty()) {
        options.ends = static_cast<ref::CamEnds>(choice("--ends", raw.ends, ref::kCamEndNames));
    }
    options.kind.surface =
        static_cast<ref::Surface>(choice("--surface", raw.surface, ref::kSurfaceNames));
    if (raw.generatrix.empty()) {
        options.kind.generatrix = ref::Generatrix::kParabola;
        return;
    }
    if (!ref::has_generatrix(options.kind.surface)) {
        throw UsageError(fmt::format("--generatrix is for --surface tamm and blend; {} has cubics",
                                     raw.surface));
    }
    options.kind.generatrix =
        static_cast<ref::Generatrix>(choice("--generatrix", raw.generatrix, ref::kGeneratrixNames));
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
