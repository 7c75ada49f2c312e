// SPDX-License-Identifier: Apache-2.0
// The lines of a curve's table that declare: what they mean stands in table_reader.hpp.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ref/curves/curve_table.hpp"
#include "ref/text/place.hpp"

namespace curvecore::ref {

class Declarations {
  public:
    explicit Declarations(CurveTable& table) : table_(table) {}

    /// Reads a line `KEY ITEM ..`. @throws InputError
    void line(const std::string& key, const std::vector<std::string>& items, const Place& place);

    CurveRow& row(const std::string& name) { return table_.rows[name]; }
    /// A row that a line before makes. @throws InputError
    CurveRow& known(const std::string& name, const Place& place, bool in_sample = false);

    /// Notes that a line reads orders of a row, which a line further down may make.
    void reads_orders(const std::string& row, int line) { in_order_.emplace_back(row, line); }
    const std::vector<std::pair<std::string, int>>& in_order() const { return in_order_; }

  private:
    void on_bus(const std::string& field, const std::string& name, const Place& place);
    void declare(std::string name, int fraction, bool start, const Place& place);

    CurveTable& table_;
    std::vector<std::pair<std::string, int>> in_order_;
};

}  // namespace curvecore::ref
