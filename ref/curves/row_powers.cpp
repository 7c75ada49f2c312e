// SPDX-License-Identifier: Apache-2.0
#include "ref/curves/row_powers.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <cmath>
#include <vector>

#include "ref/curves/order_demand.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr double kSame = 1e-9;

/// The linear equations of the powers: sum of weights = right.
class PowerEquations {
  public:
    explicit PowerEquations(const CurveTable& table) : table_(table) {
        for (const auto& [name, row] : table.rows) {
            if (!row.same_as) columns_.emplace(name, static_cast<int>(columns_.size()));
        }
        add({{table.output, 1}}, -1, 0);
        for (const auto& [name, row] : table.rows) {
            if (row.value && !row.series && !row.start) add({{name, 1}}, 0, row.line);
        }
        for (const auto& [name, power] : table.said_powers) {
            add({{name, 1}}, power, table.rows.at(name).line);
        }
        for (const char* section : {"load", "anchor", "order", "next", "sample"}) {
            for (const TableLine& line : table.section(section)) {
                if (line.down == 0 && line.row != "place") continue;
                refuse(line.number, "the powers of a table that scales by s are not derived");
            }
        }
        for (const TableLine& line : table.section("anchor")) lines(line, false);
        for (const TableLine& line : table.section("order")) lines(line, true);
    }

    std::map<std::string, int> solve() const {
        const auto rows = static_cast<Eigen::Index>(right_.size());
        const auto columns = static_cast<Eigen::Index>(columns_.size());
        Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(rows, columns);
        Eigen::VectorXd right(rows);
        for (Eigen::Index i = 0; i < rows; ++i) {
            const auto of = static_cast<std::size_t>(i);
            for (const auto& [column, weight] : weights_[of]) weights(i, column) += weight;
            right(i) = right_[of];
        }
        const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors(weights);
        const Eigen::VectorXd powers = factors.solve(right);
        const Eigen::VectorXd missed = weights * powers - right;
        Eigen::Index worst = 0;
        if (missed.cwiseAbs().maxCoeff(&worst) > kSame) {
            refuse(lines_[static_cast<std::size_t>(worst)],
                   "its terms do not grow alike with the step");
        }
        const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> across(weights.transpose());
        std::map<std::string, int> found;
        for (const auto& [field, row] : table_.bus) {
            // Known if the row alone is a sum of equations.
            Eigen::VectorXd alone = Eigen::VectorXd::Zero(columns);
            alone(columns_.at(row)) = 1;
            const double left =
                (weights.transpose() * across.solve(alone) - alone).cwiseAbs().maxCoeff();
            const double power = powers(columns_.at(row));
            if (left > kSame || std::abs(power - std::round(power)) > kSame) {
                refuse(table_.rows.at(row).line,
                       fmt::format("how {} grows with the step is open: `power {} ..` says it", row,
                                   row));
            }
            found[row] = static_cast<int>(std::lround(power));
        }
        return found;
    }

  private:
    using Weights = std::vector<std::pair<std::string, int>>;

    [[noreturn]] void refuse(int line, const std::string& reason) const {
        throw InputError(table_.file, line, reason);
    }

    void add(const Weights& weights, int right, int line) {
        std::vector<std::pair<int, int>> row;
        for (const auto& [name, weight] : weights) row.emplace_back(columns_.at(name), weight);
        weights_.push_back(row);
        right_.push_back(right);
        lines_.push_back(line);
    }

    /// An equation for each term: what it grows with is what the row does. Of `order`, order i of
    /// the row, whatever i is.
    void lines(const TableLine& line, bool of_order) {
        for (const TableTerm& term : line.terms) {
            Weights weights{{line.row, 1}};
            int right = of_order ? 0 : -line.order.value_or(0);
            bool in_order = false;
            const auto operand = [&](const RowOperand& read) {
                const RowOperand of = same_row(table_, read);
                weights.emplace_back(of.row, -1);
                if (!table_.rows.at(of.row).series) return;
                right += of.order.value_or(0) - of.primes;
                in_order = in_order || !of.order;
            };
            if (term.meeting == TableTerm::Meeting::kOrderByOrder) {
                refuse(line.number,
                       "how a row grows that series give order by order is not derived");
            }
            if (term.meeting != TableTerm::Meeting::kConstant) operand(term.a);
            if (term.meeting == TableTerm::Meeting::kProduct) operand(term.b);
            if (of_order && !in_order) {
                refuse(line.number, "its terms do not grow alike with the step");
            }
            add(weights, right, line.number);
        }
    }

    const CurveTable& table_;
    std::map<std::string, int> columns_;
    std::vector<std::vector<std::pair<int, int>>> weights_;
    std::vector<int> right_;
    std::vector<int> lines_;
};

}  // namespace

std::map<std::string, int> row_powers(const CurveTable& table) {
    return PowerEquations(table).solve();
}

}  // namespace curvecore::ref
