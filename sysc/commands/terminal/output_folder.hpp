// SPDX-License-Identifier: Apache-2.0
// The folder that a command writes, completely or not at all.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace curvecore::sysc {

/// Files are written into a temporary sibling and moved into place by commit(); without commit()
/// nothing stays behind. An existing folder keeps what is not this program's.
class OutputFolder {
  public:
    /// @throws ref::InputError when the folder cannot be made, with the system's reason
    explicit OutputFolder(const std::string& folder);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    /// Path at which a file of this name is written now.
    std::string path(const std::string& name) const { return (temporary_ / name).string(); }

    void write(const std::string& name, const std::string& text) const;
    void commit();

  private:
    [[noreturn]] void refuse(const std::string& reason) const;

    std::string given_;  // name as the user gave it
    std::filesystem::path folder_;
    std::filesystem::path temporary_;
};

/// A growing file of the folder.
class OutputFile {
  public:
    OutputFile(const OutputFolder& folder, const std::string& name);

    void write(const std::string& text) { stream_ << text; }
    /// @throws std::runtime_error when not all of it could be written
    void close();

  private:
    std::string name_;
    std::ofstream stream_;
};

}  // namespace curvecore::sysc
