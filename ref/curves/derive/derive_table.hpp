// SPDX-License-Identifier: Apache-2.0
// A curve that is given by formulas, as a table at constant path speed.
//
// r(t) = x(t) e1 + y(t) e2 + z(t) e3, in any frame. With s the path and L the largest |dr/dt|:
//
//     dt/ds = mu phi      mu = 1/L      phi = 1 / |V|      V = (dr/dt) / L
//
// Every function in V is a row that its own differential equation carries on (sine and cosine as
// Shannon's two integrators), sums and products are made of these. Source: C. E. Shannon,
// Mathematical Theory of the Differential Analyzer, 1941, Theorem VIII: any function of one
// variable without hypertranscendental parts is generated so.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "ref/curves/derive/formula.hpp"

namespace curvecore::ref {

/// | field      | unit | meaning                                          |
/// |------------|------|--------------------------------------------------|
/// | name       |      | of the table                                     |
/// | coordinates|      | x, y and, in space, z by t                       |
/// | constants  |      | numbers by the names that formulas have for them |
/// | from, to   |      | t at both ends, from < to                        |
struct CurveFormula {
    std::string name;
    std::vector<std::string> coordinates;
    std::map<std::string, double> constants;
    double from = 0;
    double to = 1;
};

/// | field  | unit | meaning                                                          |
/// |--------|------|------------------------------------------------------------------|
/// | text   |      | of the table; its fractions hold steps of 1/64 of the length     |
/// | rows   |      | of the bus at the start, where the path is as long as formulas say |
/// | length |      | of the path                                                      |
/// | start  |      | r(from)                                                          |
struct DerivedTable {
    std::string text;
    std::map<std::string, std::array<double, 3>> rows;
    double length = 0;
    std::array<double, 3> start{};
};

/// @throws FormulaError: no formula, a curve that stands still or has no end there, a straight
/// line, more rows than a segment has words, a row that no word holds
DerivedTable derive_table(const CurveFormula& formula);

}  // namespace curvecore::ref
