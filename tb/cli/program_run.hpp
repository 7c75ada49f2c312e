// SPDX-License-Identifier: Apache-2.0
// The built program as a user starts it, in a temporary folder that is removed when the test ends.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace curvecore::tb {

struct ProgramResult {
    int status = -1;  // exit status; -1: ended by a signal
    std::string out;
    std::string err;
    long peak_kib = 0;  // resident memory
};

/// Name of a test with these arguments: "on_kernel_set_Mode_1"; "default" without any.
std::string name_of(const std::vector<std::string>& arguments);

class ProgramRun {
  public:
    /// Creates the folder; `program`: a path, by default the built `curvecore`.
    explicit ProgramRun(std::string program = CURVECORE_PROGRAM);
    ~ProgramRun();
    ProgramRun(const ProgramRun&) = delete;
    ProgramRun& operator=(const ProgramRun&) = delete;

    const std::filesystem::path& folder() const { return folder_; }
    void write(const std::string& name, const std::string& text) const;
    std::string read(const std::string& name) const;
    bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
    /// Returns the names in the folder, sorted, without the program's printed output.
    std::vector<std::string> files() const;

    /// Runs the program with arguments as an array, no shell; the folder is the working directory.
    /// `interrupt_ms`: processor time after which Ctrl-C is sent.
    ProgramResult run(const std::vector<std::string>& arguments, int interrupt_ms = 0) const;

  private:
    std::string program_;
    std::filesystem::path folder_;
    std::filesystem::path streams_;
};

}  // namespace curvecore::tb
