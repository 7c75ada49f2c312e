// SPDX-License-Identifier: Apache-2.0
// The result on the terminal.
#pragma once

#include "sysc/report/report.hpp"

namespace curvecore::sysc {

/// Prints the program's warnings to stderr.
void print_warnings(const Job& job);

/// Prints warnings and failed checks to stderr, the table to stdout; with -q only the former, with
/// --json the report instead of the table.
void print_summary(const Report& report);

}  // namespace curvecore::sysc
