// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/terminal/summary.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "sysc/commands/terminal/json_result.hpp"

namespace curvecore::sysc {

void print_warnings(const Job& job) {
    constexpr std::size_t kMost = 10;
    const std::vector<std::string>& warnings = job.program.warnings;
    for (std::size_t i = 0; i < warnings.size() && i < kMost; ++i) {
        fmt::print(stderr, "{}\n", warnings[i]);
    }
    if (warnings.size() > kMost) {
        fmt::print(stderr, "{} more warnings in the report\n", warnings.size() - kMost);
    }
}

void print_summary(const Report& report) {
    print_warnings(report.job);
    if (report.job.options.json) {
        print_json(report.json());
    } else if (!report.job.options.quiet) {
        for (const auto& [name, value] : report.table()) fmt::print("{:<22} {}\n", name, value);
        fmt::print("{:<22} {}\n", "result", report.held() ? "every check held" : "A CHECK FAILED");
        fmt::print("{:<22} {}/report.html\n", "report", report.job.options.folder);
    }
    for (const Check& check : report.checks()) {
        if (!check.held) {
            fmt::print(stderr, "curvecore: check failed: {}: {}\n", check.name, check.detail);
        }
    }
}

}  // namespace curvecore::sysc
