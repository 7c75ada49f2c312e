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
    /// Starts the program; its stderr goes into a file. @throws std::runtime_error
    ChildProcess(const std::vector<std::string>& arguments, const std::filesystem::path& errors);
    /// Ends the program if it still runs.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Returns the next line without its end; none: no more will come. A last line without an end
    /// of line is discarded.
    std::optional<std::string> line();
    /// Waits for the end and describes it: "exit status 1", "signal 11 (Segmentation fault)".
    std::string end();

  private:
    pid_t process_ = -1;
    std::FILE* output_ = nullptr;
};

}  // namespace curvecore::sysc
