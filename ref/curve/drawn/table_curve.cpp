// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/drawn/table_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ref/curves/table_machine.hpp"

namespace curvecore::ref {
namespace {

using Machine = TableMachine<double>;

constexpr double kLeftOutOfStep =
    1e-15;                           // of a step: the last orders of a series that is long enough
constexpr double kOffUnit = 1e-5;    // of |r'|, by rounded rows
constexpr double kNoMotion = 1e-12;  // of a step
constexpr double kSamePlace = 1e-9;  // the same
constexpr std::size_t kMostSteps = 100'000;
constexpr int kPlacesOfStep = 64;

/// Begins a segment of a step of h at a machine's origin.
void set_rows(const TablePiece& piece, double h, Machine& machine) {
    for (const auto& [row, values] : piece.rows(h)) {
        const int axes = piece.table->rows.at(row).of_axis ? 3 : 1;
        for (int axis = 0; axis < axes; ++axis) {
            machine.set(row, values[static_cast<std::size_t>(axis)], axis);
        }
    }
    machine.begin({}, 0, 0);
}

/// The rows that a machine, in steps of h, has come to.
TablePiece piece_of(const Machine& machine, const CurveTable& table, double h) {
    TablePiece piece;
    piece.table = &table;
    for (const auto& [field, row] : table.bus) {
        const double scale = std::pow(h, -table.powers.at(row));
        const int axes = table.rows.at(row).of_axis ? 3 : 1;
        for (int axis = 0; axis < axes; ++axis) {
            piece.at(field, axis) = scale * machine.value(row, 0, axis);
        }
    }
    return piece;
}

}  // namespace

TableCurve::TableCurve(const TablePiece& piece, const Vec3& start, double length)
    : piece_(piece), length_(length) {
    double h = length;
    while (!made_in_steps(start, h)) {
        h /= 2;
        if (length / h > kMostSteps) {
            throw std::domain_error("its series do not converge, in however short steps");
        }
    }
}

void TableCurve::check_path() const {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        for (const double part : {0.0, 0.5, 1.0}) {
            const double speed = direction((static_cast<double>(i) + part) * h_).norm();
            if (std::abs(speed - 1) < kOffUnit) continue;
            throw std::domain_error(
                fmt::format("its rows are none of a path: |dr/ds| is {:.6g}, not 1", speed));
        }
    }
}

bool TableCurve::moves(int axis) const {
    return std::any_of(steps_.begin(), steps_.end(), [&](const Step& step) {
        return step.series.row(axis).tail(kOrder).cwiseAbs().maxCoeff() > kNoMotion * h_;
    });
}

bool TableCurve::made_in_steps(const Vec3& start, double h) {
    const CurveTable& table = *piece_.table;
    h_ = h;
    steps_.clear();
    Machine machine(table, kOrder, false);
    set_rows(piece_, h, machine);
    Vec3 origin = start;
    const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(length_ / h - 1e-9)));
    for (std::size_t i = 0; i < count; ++i) {
        Step step;
        step.piece = i == 0 ? piece_ : piece_of(machine, table, h);
        step.origin = origin;
        machine.open();
        for (int axis = 0; axis < 3; ++axis) {
            step.series(axis, 0) = origin[axis];
            for (int n = 1; n <= kOrder; ++n) {
                step.series(axis, n) = h * machine.value(table.output, n, axis);
            }
        }
        const double left_out = step.series.rightCols<2>().cwiseAbs().maxCoeff();
        if (!(left_out < kLeftOutOfStep * h)) return false;  // also what is not a number
        origin = step.series.rowwise().sum();
        steps_.push_back(step);
        machine.leave();
    }
    return true;
}

std::size_t TableCurve::step_at(double s) const {
    // The end of a step, i h, may be a little below i steps.
    const double step = std::floor(std::clamp(s, 0.0, length_) / h_ + kSamePlace);
    return std::min(static_cast<std::size_t>(step), steps_.size() - 1);
}

Vec3 TableCurve::derivative(double s, int n) const {
    const std::size_t index = step_at(s);
    const double tau = std::clamp(s, 0.0, length_) / h_ - static_cast<double>(index);
    const auto& series = steps_[index].series;
    Vec3 sum = Vec3::Zero();
    for (int order = kOrder; order >= n; --order) {
        double falling = 1;
        for (int i = 0; i < n; ++i) falling *= order - i;
        sum = sum * tau + falling * series.col(order);
    }
    return sum / std::pow(h_, n);
}

double TableCurve::most_derivative(double s, int n) const {
    const auto& series = steps_[step_at(s)].series;
    double sum = 0;
    for (int order = n; order <= kOrder; ++order) {
        double falling = 1;
        for (int i = 0; i < n; ++i) falling *= order - i;
        sum += falling * series.col(order).norm();
    }
    return sum / std::pow(h_, n);
}

std::vector<double> TableCurve::step_ends() const {
    std::vector<double> ends{0};
    for (std::size_t i = 1; i < steps_.size(); ++i) ends.push_back(static_cast<double>(i) * h_);
    ends.push_back(length_);
    return ends;
}

SharpestPlace TableCurve::sharpest() const {
    SharpestPlace sharpest;
    const std::size_t places = kPlacesOfStep * steps_.size();
    for (std::size_t i = 0; i <= places; ++i) {
        const double s = length_ * static_cast<double>(i) / static_cast<double>(places);
        if (curvature(s) > sharpest.curvature) sharpest = {curvature(s), s};
    }
    return sharpest;
}

TablePiece TableCurve::piece_at(double s) const {
    const std::size_t index = step_at(s);
    const double rest = std::clamp(s, 0.0, length_) - static_cast<double>(index) * h_;
    const TablePiece& begin = steps_[index].piece;
    if (rest <= 0) return begin;
    Machine machine(*begin.table, kOrder, false);
    set_rows(begin, rest, machine);
    machine.open();
    machine.leave();
    return piece_of(machine, *begin.table, rest);
}

}  // namespace curvecore::ref
