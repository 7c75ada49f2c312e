// SPDX-License-Identifier: Apache-2.0
// Configurations that microcode of curves is tested in: those of tb/configurations.csv.
#pragma once

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tb/support/microcode/curve_comparison.hpp"

namespace curvecore::tb {

/// The configurations of the table; of `engine` those that it has: anchored, without guard bits.
inline std::vector<CurveCase> configurations(bool engine = true) {
    std::ifstream table(std::string(DATA_DIR) + "/../configurations.csv");
    std::vector<CurveCase> cases;
    std::set<std::string> seen;
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
        CurveCase one;
        one.core.order = std::stoi(cells[3]);
        one.core.coef_bits = std::stoi(cells[4]);
        one.core.position_bits = std::stoi(cells[5]);
        one.core.guard_bits = std::stoi(cells[6]);
        one.core.aux_axes = std::stoi(cells[7]);
        one.core.mode = std::stoi(cells[9]);
        if (!engine && cells[10] != "-") one.core.anchor = std::stoi(cells[10]);
        if (!engine && cells[12] != "-") one.core.parameter_guard = std::stoi(cells[12]);
        for (const bool spline : {false, true}) {
            one.spline = spline;
            if (spline && cells[0].find("spherical") == 0) continue;
            if (!spline && cells[0].find("spline") == 0) continue;
            std::string key = spline ? "s" : "a";
            for (std::size_t n = 3; n <= 9; ++n) key += n == 8 ? "" : "," + cells[n];
            key += fmt::format(",{},{}", one.core.anchor, one.core.parameter_guard);
            if (seen.insert(key).second) cases.push_back(one);
        }
    }
    return cases;
}

inline std::string text(const CurveCase& of) {
    std::ostringstream out;
    out << (of.spline ? "spline" : "arc") << " Order " << of.core.order << " CoefBits "
        << of.core.coef_bits << " PositionBits " << of.core.position_bits << " GuardBits "
        << of.core.guard_bits << " AuxAxes " << of.core.aux_axes << " Mode " << of.core.mode
        << " Anchor " << of.core.anchor << " ParameterGuard " << of.core.parameter_guard;
    return out.str();
}

/// The store of all configurations; that of Order 6 is 256 words of data, a page for an axis.
constexpr assembler::StoreSize kLargeStore{4096, 512, 2};

}  // namespace curvecore::tb
