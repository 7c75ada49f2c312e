// SPDX-License-Identifier: Apache-2.0
// Another program whose output is read line by line while it runs.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace curvecore::sysc {

class ChildProcess {
  public:
    /// Starts it; what it writes to stderr goes into a file. @throws std::runtime_error
    ChildProcess(const std::vector<std::string>& arguments, const std::filesystem::path& errors);
    /// Ends it if it still runs.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// The next line without its end; none: no more will come. A last line that no end of line
    /// closes is none.
    std::optional<std::string> line();
    /// Waits for its end: "exit status 1", "signal 11 (Segmentation fault)".
    std::string end();

  private:
    pid_t process_ = -1;
    std::FILE* output_ = nullptr;
};

}  // namespace curvecore::sysc
