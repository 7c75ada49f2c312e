// SPDX-License-Identifier: Apache-2.0
// Fanuc's lines: numbers of axes without a point, G4, M98 and '/2'. Macros are not among them.
#pragma once

#include "ref/program/dialect_lines.hpp"

namespace curvecore::ref {

class FanucLines : public DialectLines {
  public:
    void read(std::string_view text, ProgramLine& line, const Place& place) override;

  private:
    bool inches_ = false;
};

}  // namespace curvecore::ref
