// SPDX-License-Identifier: Apache-2.0
// Keys of a terminal and lines of a file that ask for something while a program is under way.
#pragma once

#include <fstream>
#include <memory>
#include <string>

#include "sysc/panel/wish.hpp"

namespace curvecore::sysc {

class Console {
  public:
    /// Opens the inputs. Keys: h hold, r resume, + and - override, s stop, e e-stop, if standard
    /// input is a terminal. Lines of the file, as they are added: hold, resume, override N, stop,
    /// estop.
    /// @throws UsageError: no such file
    explicit Console(const std::string& control_file);
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    /// Returns true if somebody can ask for something.
    bool heard() const { return terminal_ || file_.is_open(); }
    /// Adds what was asked for since the last time, while the override is this; messages about what
    /// is none go to stderr.
    void add_to(WishQueue& wishes, int override_percent);

  private:
    struct Terminal;

    void keys(WishQueue& wishes, int percent);
    void lines(WishQueue& wishes);

    std::unique_ptr<Terminal> terminal_;
    std::ifstream file_;
    std::string line_;
};

}  // namespace curvecore::sysc
