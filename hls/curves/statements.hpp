// SPDX-License-Identifier: Apache-2.0
// The lines of a table's section as statements of C++, each below its line: what neighbours share
// of a condition or a loop over the axes stands once.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "hls/curves/line_text.hpp"

namespace curvecore {
namespace hls {

constexpr std::size_t kColumns = 100;

inline std::string pad(int depth) { return std::string(4 * static_cast<std::size_t>(depth), ' '); }

/// A remark's line without the \ at its end that would join the next line to it.
inline std::string without_splice(const std::string& line) {
    return line.substr(0, line.find_last_not_of("\\ \t") + 1);
}

class Statements {
  public:
    /// `lines`: the table's file.
    Statements(const ref::CurveTable& table, const RowNames& names, const OrderLimits& limits,
               std::vector<std::string> lines)
        : table_(table),
          names_(names),
          limits_(limits),
          line_(table, names, limits),
          lines_(std::move(lines)) {}

    /// @throws ref::InputError: a line that has no statement
    std::string section(const std::string& name, int depth) const;

  private:
    std::set<std::string> rows_of_all_axes(const ref::TableLine& line) const;
    std::string remark(const ref::TableLine& line) const;
    std::string condition(const ref::TableLine& line, bool order) const;
    void check(const ref::TableLine& line, const std::string& section,
               const std::set<std::string>& all) const;

    const ref::CurveTable& table_;
    const RowNames& names_;
    const OrderLimits& limits_;
    LineText line_;
    std::vector<std::string> lines_;
};

}  // namespace hls
}  // namespace curvecore
