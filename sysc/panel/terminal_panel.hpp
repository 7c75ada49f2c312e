// SPDX-License-Identifier: Apache-2.0
// Lines at the bottom of a terminal that are written anew in place, and removed at the end.
#pragma once

#include <string>
#include <vector>

namespace curvecore::sysc {

class TerminalPanel {
  public:
    /// Shows nothing unless `wanted` and standard error is a terminal.
    explicit TerminalPanel(bool wanted);
    ~TerminalPanel();
    TerminalPanel(const TerminalPanel&) = delete;
    TerminalPanel& operator=(const TerminalPanel&) = delete;

    bool on() const { return on_; }
    /// Columns that a line may have.
    std::size_t columns() const;
    void show(const std::vector<std::string>& lines);

  private:
    void clear();

    bool on_;
    std::size_t shown_ = 0;  // lines
};

}  // namespace curvecore::sysc
