// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/drawn/table_piece.hpp"

#include <cmath>

#include "ref/curve/drawn/table_curve.hpp"

namespace curvecore::ref {

double& TablePiece::at(const std::string& place, int axis) {
    const BusPlace of = bus_place(place);
    if (of.field == "theta") return theta;
    if (of.further())
        return further[static_cast<std::size_t>(of.number) + static_cast<std::size_t>(axis)];
    return (of.field == "tangent" ? tangent : of.field == "normal" ? normal : advance)[axis];
}

double TablePiece::at(const std::string& place, int axis) const {
    return const_cast<TablePiece*>(this)->at(place, axis);
}

std::map<std::string, std::array<double, 3>> TablePiece::rows(double h) const {
    std::map<std::string, std::array<double, 3>> rows;
    for (const auto& [field, row] : table->bus) {
        const double scale = std::pow(h, table->powers.at(row));
        auto& values = rows[row];
        const int axes = table->rows.at(row).of_axis ? 3 : 1;
        for (int axis = 0; axis < axes; ++axis) {
            values[static_cast<std::size_t>(axis)] = scale * at(field, axis);
        }
    }
    return rows;
}

TablePiece TablePiece::rescaled(double factor) const {
    TablePiece piece = *this;
    for (const auto& [field, row] : table->bus) {
        const double scale = std::pow(factor, -table->powers.at(row));
        const int axes = table->rows.at(row).of_axis ? 3 : 1;
        for (int axis = 0; axis < axes; ++axis) piece.at(field, axis) *= scale;
    }
    return piece;
}

std::unique_ptr<PathCurve> TablePiece::path(const Vec3& start, double length) const {
    return std::make_unique<TableCurve>(*this, start, length);
}

}  // namespace curvecore::ref
