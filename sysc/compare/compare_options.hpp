// SPDX-License-Identifier: Apache-2.0
// What the command line of `curvecore compare` asks for.
#pragma once

#include <array>

#include "sysc/compare/sweep.hpp"
#include "sysc/curves/built_in_curves.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {

struct CompareOptions {
    Options common;  // file (empty: built-in curves), folder, machine, points, unit, quiet
    CurveSet curves = CurveSet::kAll;
    std::vector<CoreParameters> settings;
    std::vector<CoreParameters> drawn;  // those that our segments and steps draw
    bool schemes = false;               // --scheme is given
    SweepOptions sweep;
};

/// What is compared without --core, where --set says nothing else.
constexpr std::array<const char*, 3> kComparedSets{"Order=4:8:2", "CoefBits=20:36:4", "Mode=0,1"};

constexpr const char* kComparedDevice = "ecp5-85";

/// The command line as text.
struct RawCompareOptions {
    std::string curves = "all";
    std::string scheme;
    std::string tick;
    std::string feed;         // without --scheme: along points, an option of `common`
    bool core_given = false;  // --core, of the common options
    std::vector<std::string> set;
    std::string segments = "4";
    std::string samples = "100000";
};

/// `options.common` is interpreted already.
/// @throws UsageError with the option's name and the reason
void interpret(const RawCompareOptions& raw, CompareOptions& options);

/// Gives the settings the axes of the program, and splines where it has them.
/// @throws UsageError: one of them is not built
void complete_settings(const ref::Program& program, std::vector<CoreParameters>& settings);

/// @throws ref::InputError: an arc or a line, which the schemes of --tick do not draw; UsageError:
///         too many ticks
void check_ticked(const ref::Program& program, const CompareOptions& options);

}  // namespace curvecore::sysc
