// SPDX-License-Identifier: Apache-2.0
// Bound of the distance between the words of a curve's table and the curve: of any table, from its
// lines alone.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "ref/curves/curve_table.hpp"
#include "ref/format/parameters.hpp"

namespace curvecore::ref {

/// A segment of a table: rows of the bus by name, with their exact values.
struct TableSegment {
    std::map<std::string, std::array<double, 3>> values;
    int k = 0;       // a step is 2^k length units
    int lambda = 0;  // of `place`; k where the table has none
    int steps = 1;
    double last = 1;  // the part of the last step that is drawn, (0, 1]
};

/// | field   | unit         | meaning                                                            |
/// |---------|--------------|--------------------------------------------------------------------|
/// | errors  | length units | bound of each axis in each step, before the final rounding;        |
/// |         |              | infinite in steps in which a series shrinks too slowly for it       |
/// | largest |              | largest magnitude of each row that is made, its error counted; of   |
/// |         |              | `sample` at those places                                           |
/// | beyond  |              | rows that may leave their range: if there are any, nothing is bound |
struct TableError {
    std::vector<std::array<double, 3>> errors;
    std::map<std::string, double> largest;
    std::vector<std::string> beyond;

    double worst() const;
};

/// Follows all roundings through the segment: what is carried from step to step is a matrix of
/// independent errors. What the series leave out is the difference to the same table with 8 orders
/// more, in double precision, and once more by how much that differs from 4 orders more: enough
/// where four orders are at most half of the four before, which is asked of every series that is
/// summed. All are polynomials in tau, known from as many places of a step as bound them everywhere
/// in it.
TableError table_error(const CurveTable& table, const CoreParameters& core,
                       const TableSegment& segment);

}  // namespace curvecore::ref
