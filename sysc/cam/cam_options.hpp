// SPDX-License-Identifier: Apache-2.0
// Options of `curvecore cam`.
#pragma once

#include <string>

#include "ref/cam/cam_path.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {

struct CamOptions {
    Options common;
    ref::SurfaceKind kind;
    double kappa = 0;     // half-turns per section pitch; 0: derived from scallop and cutter
    double scallop = 0;   // mm
    double cutter = 0;    // radius, mm; 0: not given
    double delta = 5e-3;  // mm
    ref::CamEnds ends = ref::CamEnds::kTurned;
    double feed = 0;      // feed over the surface, mm/s
    std::string against;  // file of a finer table; empty: the table's own tensor surface
};

/// The command line as text; empty: not given.
struct RawCamOptions {
    std::string kappa;
    std::string scallop;
    std::string cutter;
    std::string delta = "5um";
    std::string surface = "lagrange";
    std::string generatrix;
    std::string ends;
};

/// Converts the texts into `options`.
void interpret(const RawCamOptions& raw, CamOptions& options);

/// Returns the helix on a table of `angles` angles with a section every dx mm.
/// @throws UsageError: kappa n / 2 is not whole
ref::CamHelix helix_of(const CamOptions& options, int angles, double dx);

}  // namespace curvecore::sysc
