// SPDX-License-Identifier: Apache-2.0
// Requests of an operator while a program is under way: keys of a terminal, lines of a file.
#pragma once

#include <fstream>
#include <memory>
#include <optional>
#include <string>

namespace curvecore::sysc {

struct Wish {
    enum class Kind { kHold, kResume, kOverride, kStop, kEstop };
    Kind kind;
    int percent = 0;  // for kOverride
};

class Console {
  public:
    /// Opens the inputs. Keys: h hold, r resume, + and - override, s stop, e e-stop, if standard
    /// input is a terminal. Lines of the file, as they are added: hold, resume, override N, stop,
    /// estop.
    /// @throws UsageError: no such file
    Console(const std::string& control_file, int override_percent);
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    /// Returns the next valid wish; messages about others go to stderr.
    std::optional<Wish> next();

  private:
    struct Terminal;

    std::optional<Wish> key();
    std::optional<Wish> line();

    std::unique_ptr<Terminal> terminal_;
    std::ifstream file_;
    std::string line_;
    int percent_;
};

}  // namespace curvecore::sysc
