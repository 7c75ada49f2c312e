// SPDX-License-Identifier: Apache-2.0
// Options of `curvecore compare`.
#pragma once

#include <array>

#include "sysc/compare/sweep.hpp"
#include "sysc/curves/built_in_curves.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {

struct CompareOptions {
    Options common;  // file (empty: built-in curves), folder, machine, points, unit, quiet
    CurveSet curves = CurveSet::kAll;
    std::vector<ParameterList> set;
    bool core_given = false;      // --core was given: what it has is not swept
    std::vector<Scheme> schemes;  // empty: --scheme was not given
    std::vector<double> ticks;    // s
    std::vector<double> feeds;    // mm/s
    std::vector<CoreParameters> settings;
    std::vector<const Device*> devices;  // that are asked about; empty: one, by `common`
    std::vector<Build> builds;           // .. and the builds that may be the answer
    std::vector<CoreParameters> drawn;   // configurations that our segments and steps draw
    SweepOptions sweep;
};

/// Values that are compared without --core, unless --set gives others.
constexpr std::array<const char*, 3> kComparedSets{"Order=4:8:2", "CoefBits=20:36:4", "Mode=0,1"};

constexpr const char* kComparedDevice = "ecp5-85";

/// Completes the options, of which `common` is complete, and checks that they go together.
/// @throws UsageError
void complete(CompareOptions& options);

/// Gives the settings the axes of the program, and splines if the program has them.
/// @throws UsageError: a setting is not built
void complete_settings(const ref::Program& program, std::vector<CoreParameters>& settings);

/// Checks that the schemes of --tick can draw the program.
///         too many ticks
void check_ticked(const ref::Program& program, const CompareOptions& options);

}  // namespace curvecore::sysc
