// SPDX-License-Identifier: Apache-2.0
// Facts of a curve's table that `curvecore curve check` prints: rows, what the engine needs for
// it, and how far the words of a segment may be off.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ref/bound/table_bound.hpp"
#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

struct CheckedRow {
    std::string name;
    bool of_axis;
    int bits;
    double range;    // its words are in [-range, range)
    int orders;      // highest that is needed
    double largest;  // of a segment, its error counted; 0: not known
};

/// Memory and clocks of the engine for the curve alone.
struct EngineNeed {
    std::size_t instructions;
    int segment_clocks;
    int step_clocks;
    int sample_clocks;
    int table_number;  // parameter Table
};

/// A row that may leave its range.
struct BeyondRow {
    std::string row;
    int line;
    std::string reason;
};

struct TableCheck {
    std::string table;
    std::string title;
    std::vector<CheckedRow> rows;
    std::optional<EngineNeed> engine;
    std::string refused;  // why the engine does not draw it
    bool of_segment;      // the rest is of a segment
    int steps;
    int step_exponent;
    std::vector<BeyondRow> beyond;
    double error = 0;  // length units on any axis; infinite: nothing bounds it

    /// Returns true unless a row leaves its range, or nothing bounds the error.
    bool held() const;
    /// Returns rows and needs, without the segment's error.
    std::string text() const;
    nlohmann::ordered_json json() const;
};

/// `segment`: null, or what is bounded.
TableCheck check_table(const ref::CurveTable& table, const CoreParameters& core,
                       const ref::TableSegment* segment);

}  // namespace curvecore::sysc
