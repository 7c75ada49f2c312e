// SPDX-License-Identifier: Apache-2.0
// The table of a further curve, by the name of one that is shipped or of a file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "ref/curves/curve_table.hpp"

namespace curvecore::sysc {

/// Returns FILE.net, or the file of a shipped table's name. @throws UsageError: none has it
std::string table_file(const std::string& option, const std::string& name);

/// Reads FILE.net, or NAME.net of the shipped ref/curves, for segments of a program: with the
/// powers of its rows. @throws ref::InputError; UsageError: there is no such name
std::shared_ptr<const ref::CurveTable> named_table(const std::string& name);

/// Returns the shipped table of that number (curvecore_table_number()); null: none has it.
std::shared_ptr<const ref::CurveTable> numbered_table(std::uint32_t number);

/// @throws UsageError if a table has the name of what cores draw anyway
void check_table_name(const ref::CurveTable& table);

}  // namespace curvecore::sysc
