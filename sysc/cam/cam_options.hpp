// SPDX-License-Identifier: Apache-2.0
// Options of `curvecore cam`.
#pragma once

#include <optional>
#include <string>

#include "ref/cam/cam_path.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {

struct CamOptions {
    Options common;
    ref::SurfaceKind kind;
    std::optional<ref::Generatrix> generatrix;  // asked for; none: the surface's own
    double kappa = 0;     // half-turns per section pitch; 0: derived from scallop and cutter
    double scallop = 0;   // mm
    double cutter = 0;    // radius, mm; 0: not given
    double delta = 5e-3;  // mm
    ref::CamEnds ends = ref::CamEnds::kTurn;
    double feed = 0;      // feed over the surface, mm/s
    std::string against;  // file of a finer table; empty: the table's own tensor surface
};

/// Completes the options and checks that they go together. @throws UsageError
void complete(CamOptions& options);

/// Returns the helix on a table of `angles` angles with a section every dx mm.
/// @throws UsageError: kappa n / 2 is not whole
ref::CamHelix helix_of(const CamOptions& options, int angles, double dx);

}  // namespace curvecore::sysc
