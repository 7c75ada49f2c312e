// SPDX-License-Identifier: Apache-2.0
// Answer of `curvecore curve check`: a table's rows, what the engine needs for it, and the bound of
// a segment; as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ref/bound/table_bound.hpp"
#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

struct CurveCheck {
    /// A row of the table; `largest` of a segment alone, 0: the segment does not make it.
    struct Row {
        std::string name;
        int fraction_bits = 0;
        double range = 0;
        int orders = 0;
        std::optional<double> largest;
    };
    /// Memory and clocks of the engine for the curve alone.
    struct Engine {
        std::size_t instructions = 0;
        int load = 0;  // clocks of a segment
        int step = 0;
        int sample = 0;
    };

    std::string name;
    std::string title;
    unsigned number = 0;  // parameter Table
    std::vector<Row> rows;
    std::optional<Engine> engine;
    std::string refusal;  // of the engine
    std::optional<ref::TableError> bound;

    std::string text() const;
    nlohmann::ordered_json json() const;
};

/// Checks a table for a core, and with a segment the bound of that.
CurveCheck check_curve(const ref::CurveTable& table, const CoreParameters& core,
                       const std::optional<ref::TableSegment>& segment);

}  // namespace curvecore::sysc
