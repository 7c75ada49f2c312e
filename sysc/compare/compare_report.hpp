// SPDX-License-Identifier: Apache-2.0
// Report of `curvecore compare`, as text and data.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sysc/compare/answer.hpp"

namespace curvecore::sysc {

struct CompareReport {
    const CompareOptions& options;
    const ref::Program& program;
    const SweepResult& result;
    std::vector<Answer> answers;

    bool held() const;  // true: every row within its bound, every end exact
    nlohmann::ordered_json json() const;
    std::string csv() const;
    /// Returns the table, a line for each row.
    std::string table() const;
    /// Returns the worst distance on every curve, a line for each; only with --scheme.
    std::string curves_table() const;
    std::string html() const;
    /// Returns which configuration to take on each device.
    std::string answer_text() const;
    /// Returns the number of rows that were asked for.
    std::size_t asked() const;

  private:
    std::string title() const;
    std::string curve_name(std::size_t move) const;
    int axes() const { return 3 + program.aux_axes; }
};

/// Returns the rows that no other row beats in both worst error and cost, by rising cost. Rows that
/// are no core (bits missing, not drawn) do not count.
std::vector<std::size_t> pareto_front(const std::vector<Row>& rows);

/// Returns the worst errors of any axis, as the core puts them out; the other figures are of the
/// same axes.
ErrorFigures worst_axis(const PositionFigures& figures);

}  // namespace curvecore::sysc
