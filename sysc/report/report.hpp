// SPDX-License-Identifier: Apache-2.0
// What a command found, in one place: report.json, the table of report.html and the summary on the
// terminal all come from here.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sysc/watch/board_run.hpp"

namespace curvecore::sysc {

struct Check {
    std::string name;
    bool held;
    std::string detail;
};

/// What a board drew is absent for `plan`.
struct Report {
    const Job& job;
    std::uint64_t samples;
    const LimitLoads& limits;  // of the motion as it is drawn
    const BoardResult* drawn;
    std::optional<double> period_clocks;  // the least that keeps time; none: not measured

    double duration_s() const;
    bool has_clock() const { return drawn->status.clocks > 0; }
    double clocks_per_sample() const;
    double clocks_per_second() const;
    double clocks_available() const;  // of a sample period
    std::vector<Check> checks() const;
    bool held() const;
    nlohmann::ordered_json json() const;
    /// What the terminal and the page show: name and value, one row each.
    std::vector<std::pair<std::string, std::string>> table() const;
};

/// x y z, then a b c u v w as far as the program uses them.
std::vector<std::string> axis_names(const Job& job);

/// The length unit as --unit names it.
std::string unit_text(const Job& job);

/// h min s, as short as the value allows.
std::string time_text(double seconds);

}  // namespace curvecore::sysc
