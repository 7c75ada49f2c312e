// SPDX-License-Identifier: Apache-2.0
// The interpreter's curves of tables: an active comment, and the G1 that ends the curve. The
// program's point is off its end by its own rounding; the curve is drawn as it is, and what follows
// starts where it ends.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "ref/curve/drawn/table_curve.hpp"
#include "ref/gcode/interpreter/interpreter.hpp"

namespace curvecore::ref {
namespace {

constexpr double kMiss = 3e-3;  // mm: a point of four decimals of an inch is off by 2.2 um

}  // namespace

void Interpreter::name_curve(const std::string& text, const Place& place) {
    if (curve_) refuse_curve(place);
    curve_ = read_named_curve(text, table_, place);
}

void Interpreter::refuse_curve(const Place& place) const {
    place.refuse(fmt::format(
        "the curve of line {} waits for the G1 that ends it, with X, Y and Z alone", curve_->line));
}

void Interpreter::table_curve(Block& block, const Place& place) {
    if (motion_ != 10 || block.has_any("ABCUVW")) refuse_curve(place);
    if (coordinates_.is_turned()) place.refuse("a curve of a table in turned coordinates");
    Point target = coordinates_.target(block, false, place);
    Move move = move_to(target, place);
    move.kind = Move::Kind::kTable;
    move.table = curve_->piece.rescaled(coordinates_.unit());
    move.table_length = curve_->length * coordinates_.unit();
    curve_.reset();
    try {
        const TableCurve curve(move.table, move.start, move.table_length);
        curve.check_path();
        const Vec3 end = curve.position(move.table_length);
        const double miss = (end - move.end).norm();
        if (!(miss <= kMiss)) {
            place.refuse(fmt::format(
                "this {} ends {:.6g} mm from here: its end is X{:.4f} Y{:.4f} Z{:.4f} of the "
                "machine, in mm",
                move.table.name(), miss, end.x(), end.y(), end.z()));
        }
        move.end = end;
        for (int axis = 0; axis < 3; ++axis) target[static_cast<std::size_t>(axis)] = end[axis];
    } catch (const std::domain_error& error) {
        place.refuse(fmt::format("this {}: {}", move.table.name(), error.what()));
    }
    add(move, target, place);
}

}  // namespace curvecore::ref
