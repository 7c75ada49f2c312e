// SPDX-License-Identifier: Apache-2.0
// What the command line of `curvecore compare` asks for.
#pragma once

#include "tb/command/options.hpp"
#include "tb/compare/built_in_curves.hpp"
#include "tb/compare/sweep.hpp"

namespace curvecore::tb {

struct CompareOptions {
    Options common;  // file (empty: built-in curves), folder, machine, points, unit, quiet
    CurveSet curves = CurveSet::kAll;
    std::vector<Setting> settings;
    SweepOptions sweep;
};

/// The command line as text.
struct RawCompareOptions {
    std::string curves = "all";
    std::string order = "4:8:2";
    std::string coef_bits = "20:36:4";
    std::string guard_bits = "10";
    std::string mode = "0,1";
    std::string anchor = "1";
    std::string turn_bits = "0";
    std::string parameter_guard = "0";
    std::string limit = "0.1";
    std::string segments = "4";
    std::string samples = "100000";
    std::string device = "ecp5-85";
    std::string build = "parallel";
    std::string interval = "1";
};

/// `options.common` is interpreted already.
/// @throws UsageError with the option's name and the reason
void interpret(const RawCompareOptions& raw, CompareOptions& options);

/// Every combination, the scheme varying fastest.
std::vector<Setting> all_settings(const std::vector<int>& orders, const std::vector<int>& coef_bits,
                                  const std::vector<int>& guard_bits, const std::vector<int>& modes,
                                  const std::vector<int>& turn_bits,
                                  const std::vector<int>& parameter_guards,
                                  const std::vector<int>& anchors);

}  // namespace curvecore::tb
