// SPDX-License-Identifier: Apache-2.0
// The result of a command, in one place: source of report.json, the table of report.html and the
// summary on the terminal.
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

/// Data of a report; a board's results are absent for `plan`.
struct Report {
    const Job& job;
    std::uint64_t samples;
    const LimitLoads& limits;  // loads of the drawn motion
    const BoardResult* drawn;
    std::optional<double> period_clocks;  // least that keeps time; none: not measured

    double duration_s() const;
    bool has_clock() const { return drawn->status.clocks > 0; }
    double clocks_per_sample() const;
    double clocks_per_second() const;
    double clocks_available() const;  // clocks of a sample period
    std::vector<Check> checks() const;
    bool held() const;
    nlohmann::ordered_json json() const;
    /// Returns the rows of terminal and page, name and value.
    std::vector<std::pair<std::string, std::string>> table() const;
};

/// Names x y z, then those of a b c u v w that the program uses.
std::vector<std::string> axis_names(const Job& job);

/// Name of the length unit as --unit takes it.
std::string unit_text(const Job& job);

/// Duration as h min s, as short as the value allows.
std::string time_text(double seconds);

}  // namespace curvecore::sysc
