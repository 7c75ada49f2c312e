// SPDX-License-Identifier: Apache-2.0
// Lengths and diameters of tools from LinuxCNC's tool table: a tool a line, as "T3 Z51.7 D6 ;mill".
#pragma once

#include <map>
#include <string>

#include "ref/gcode/state/coordinates.hpp"

namespace curvecore::ref {

constexpr int kLargestTool = 99999;

class ToolTable {
  public:
    /// Makes an empty table.
    ToolTable() = default;
    /// @param unit mm per unit of its X Y Z U V W D
    /// @throws InputError
    ToolTable(const std::string& file, double unit);

    /// Name of the file in messages; empty: there is none.
    const std::string& file() const { return file_; }
    /// Offset of a tool, mm and degrees; null: the table has no such tool.
    const Point* find(int tool) const;
    /// Diameter of a tool, mm; 0: the table names none.
    double diameter(int tool) const;
    /// Executes G10 L1: the offset holds from now on.
    void set(int tool, const Point& offset) { tools_[tool] = offset; }
    void set_diameter(int tool, double diameter) { diameters_[tool] = diameter; }

  private:
    std::string file_;
    std::map<int, Point> tools_;
    std::map<int, double> diameters_;
};

}  // namespace curvecore::ref
