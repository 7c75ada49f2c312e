// SPDX-License-Identifier: Apache-2.0
// What the command line asks for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ref/plan/planner.hpp"
#include "ref/program/points_reader.hpp"
#include "tb/command/core_parameters.hpp"

namespace curvecore::tb {

struct Options {
    std::string file;
    std::string folder;
    std::string machine;  // empty: the built-in one
    ref::PointsOptions points;
    double unit_mm = 1e-6;
    double sample_period_s = 100e-6;
    int samples_per_tick = 1;
    double clock_hz = 100e6;
    double error_limit = 0.1;  // units: the planner keeps every segment's derived bound below it
    CoreParameters core;
    bool splines_set = false;   // by --set; otherwise if the program has splines
    bool aux_axes_set = false;  // by --set; otherwise as many as the program needs
    bool quiet = false;

    // `run` alone
    std::optional<std::uint64_t> stall_seed;
    double override_percent = 100;
    bool trace = false;
    std::uint64_t trace_clocks = 20000;

    int samples_per_tick_log2() const;
    /// The override as the hardware's word, 2^16 = 100 %.
    std::int32_t override_word() const;
    ref::PlanOptions plan_options() const;
};

/// The command line as text, checked and turned into options.
struct RawOptions {
    std::string fit = "bessel";
    std::string parameter = "chord";
    std::string feed = "1000";  // mm/min
    std::string unit = "1nm";
    std::string sample_period = "100us";
    std::string samples_per_tick = "1";
    std::string clock = "100MHz";
    std::string build = "parallel";
    std::string limit = "0.1";
    std::string override_percent = "100";
    std::string stall_seed;
    std::string trace_clocks = "20000";
    std::vector<std::string> set;
};

/// Values of --unit, in mm, and of --build. @throws UsageError
double unit_of(const std::string& text);
Build build_of(const std::string& text);

/// @throws UsageError with the option's name and the reason
void interpret(const RawOptions& raw, Options& options);

}  // namespace curvecore::tb
