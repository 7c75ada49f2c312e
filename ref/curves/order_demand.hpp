// SPDX-License-Identifier: Apache-2.0
// Orders to which the rows of a table are needed: from what is drawn and carried back to what makes
// it.
#pragma once

#include <map>
#include <string>

#include "ref/curves/curve_table.hpp"

namespace curvecore::ref {

/// Highest order of each row of a series that is needed for one of Order; rows that are not needed
/// are not there. `polynomial`: the mode of the sampler; `anchored`: the core's Anchor.
std::map<std::string, int> order_demand(const CurveTable& table, int order, bool polynomial,
                                        bool anchored = true);

/// Returns the row that a row stands for, with the orders that it is lower by.
RowOperand same_row(const CurveTable& table, RowOperand operand);

/// Returns whether a line of a section makes a row.
bool makes(const CurveTable& table, const std::string& section, const std::string& row);

/// The first order of a row that `order` makes: 2 where `anchor` gives order 1.
int first_order(const CurveTable& table, const std::string& row);

/// Returns whether two rows meet as in a Stieltjes integrator or as factors, over all orders.
bool meet_as_series(const CurveTable& table, const TableTerm& term);

}  // namespace curvecore::ref
