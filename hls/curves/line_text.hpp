// SPDX-License-Identifier: Apache-2.0
// A line of a table as a statement of C++, over the functions of hls/curves/curve_steps.hpp.
#pragma once

#include <string>
#include <vector>

#include "hls/curves/order_limits.hpp"
#include "hls/curves/row_names.hpp"
#include "ref/curves/curve_table.hpp"

namespace curvecore {
namespace hls {

/// CoefBits and a number, as C++.
std::string coef_bits(int more);

class LineText {
  public:
    LineText(const ref::CurveTable& table, const RowNames& names, const OrderLimits& limits)
        : table_(table), names_(names), limits_(limits) {}

    /// The statement of a line of a section, and of a guarded row that is carried another one.
    /// @throws ref::InputError: there is none
    std::vector<std::string> statements(const ref::TableLine& line,
                                        const std::string& section) const;
    /// @throws ref::InputError: what a kernel of C++ does not do, at the line
    [[noreturn]] void refuse(const ref::TableLine& line, const std::string& reason) const;

  private:
    /// A part of a line's sum, with fraction bits beyond CoefBits or, of a product, beyond twice
    /// that.
    struct Part {
        std::string text;
        bool product = false;
        bool wide = false;  // a product, or as wide
        bool constant = false;
        int fraction = 0;
        int number = 1;
    };
    std::string guarded(const ref::TableLine& line) const;
    std::string value(const ref::TableLine& line, const std::string& section,
                      const std::string& axis) const;
    std::string series(const ref::RowOperand& of, const ref::TableLine& line,
                       const std::string& axis) const;
    std::string polynomial(const ref::TableLine& line, const std::string& axis) const;
    std::string entry(const ref::RowOperand& operand, bool order, const std::string& axis) const;
    Part part(const ref::TableTerm& term, bool order, const std::string& axis) const;
    std::string meeting(const ref::TableTerm& term, const std::string& axis) const;
    std::string sum_of(const std::vector<Part>& parts, bool products, int most) const;
    std::string rounded(const std::vector<Part>& parts, const ref::TableLine& line) const;

    const ref::CurveTable& table_;
    const RowNames& names_;
    const OrderLimits& limits_;
};

}  // namespace hls
}  // namespace curvecore
