// SPDX-License-Identifier: Apache-2.0
// Options of `curvecore curve`, and the curve that they ask for: by a table and its rows, or by
// formulas.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ref/curve/vec3.hpp"
#include "ref/curves/curve_table.hpp"
#include "ref/curves/derive/derive_table.hpp"
#include "ref/moves/move.hpp"
#include "sysc/commands/options/part_options.hpp"

namespace curvecore::sysc {

enum class CurveAction { kCheck, kRun, kDerive, kKernel };
constexpr std::array<std::string_view, 4> kCurveActions{"check", "run", "derive", "kernel"};

/// A row's values of a segment, of X Y Z where it has axes.
struct RowValues {
    std::string row;
    std::vector<double> values;
};

struct CurveOptions {
    CurveAction action = CurveAction::kCheck;
    PartOptions part;
    std::vector<RowValues> rows;
    int step_exponent = 20;
    int down = 0;
    int steps = 1;
    double feed = 1000.0 / 60;           // mm/s
    double length = 0;                   // mm, of what is drawn
    std::vector<double> start{0, 0, 0};  // mm
    ref::CurveFormula formula;           // mm; without coordinates: there is none
    std::string x, y, z;
    std::vector<RowValues> constants;

    bool has_formulas() const { return !x.empty() || !y.empty() || !z.empty(); }
};

/// A table with the rows of a curve's start, and how long it is, mm.
struct NamedCurve {
    std::shared_ptr<const ref::CurveTable> table;
    std::map<std::string, std::array<double, 3>> rows;
    double length = 0;
    ref::Vec3 start;
    std::string text;  // of a table that is derived
};

/// The rows that are asked for, by their names: all that the table takes.
/// @throws UsageError: a row that the bus has not, twice or without its values
std::map<std::string, std::array<double, 3>> rows_of(const ref::CurveTable& table,
                                                     const CurveOptions& asked);

/// Derives the table of the formulas that are asked for. @throws UsageError
NamedCurve derived(const CurveOptions& asked);

/// The curve that is asked for: of formulas, or of a table with its rows. @throws UsageError
NamedCurve named_curve(const CurveOptions& asked);

/// The curve as a move. @throws UsageError: its series do not converge
ref::Move move_along(const NamedCurve& curve);

}  // namespace curvecore::sysc
