// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/terminal/output_folder.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include "ref/text/input_error.hpp"

namespace curvecore::sysc {
namespace fs = std::filesystem;
namespace {

/// Every name that a command may write: an older run's files must not stay beside newer ones.
constexpr std::array<const char*, 23> kOwnFiles{
    "samples.csv",  "report.json",   "report.html", "segments.json", "waves.fst",   "waves.gtkw",
    "segments.hex", "profile.hex",   "words.json",  "compare.json",  "compare.csv", "choose.json",
    "core.json",    "junit.xml",     "cam.ngc",     "cam.json",      "cam.html",    "INCOMPLETE",
    "path.hex",     "positions.hex", "fine.hex",    "vectors.npz",   "curve.json"};

}  // namespace

OutputFolder::OutputFolder(const std::string& folder)
    : given_(folder), folder_(fs::path(folder).lexically_normal()) {
    if (!folder_.has_filename()) folder_ = folder_.parent_path();
    std::error_code error;
    const fs::file_status status = fs::status(folder_, error);
    if (fs::exists(status) && !fs::is_directory(status)) refuse("exists and is not a folder");
    fs::path parent = folder_.parent_path();
    while (parent.has_relative_path() && !fs::exists(parent, error)) parent = parent.parent_path();
    if (parent.empty()) parent = ".";
    if (!fs::is_directory(parent, error)) refuse(parent.string() + " is not a folder");
    std::string name = (parent / ("." + folder_.filename().string() + ".XXXXXX")).string();
    if (mkdtemp(name.data()) == nullptr)
        refuse("cannot be made: " + std::generic_category().message(errno));
    temporary_ = name;
    fs::permissions(temporary_, fs::perms(0755), error);
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;
    fs::remove_all(temporary_, ignored);
}

void OutputFolder::refuse(const std::string& reason) const {
    throw ref::InputError(given_, 0, reason);
}

void OutputFolder::write(const std::string& name, const std::string& text) const {
    std::ofstream file(path(name), std::ios::binary);
    file << text;
    file.close();
    if (!file) refuse("cannot write " + name);
}

void OutputFolder::commit() {
    std::error_code error;
    if (folder_.has_parent_path()) fs::create_directories(folder_.parent_path(), error);
    if (!fs::exists(folder_, error)) {
        fs::rename(temporary_, folder_, error);
        if (error) refuse(error.message());
        return;
    }
    for (const char* name : kOwnFiles) fs::remove(folder_ / name, error);
    for (const fs::directory_entry& entry : fs::directory_iterator(temporary_)) {
        fs::rename(entry.path(), folder_ / entry.path().filename(), error);
        if (error) refuse(error.message());
    }
}

OutputFile::OutputFile(const OutputFolder& folder, const std::string& name)
    : name_(name), stream_(folder.path(name), std::ios::binary) {}

void OutputFile::close() {
    stream_.close();
    if (!stream_) throw std::runtime_error("cannot write " + name_ + ": is the disk full?");
}

}  // namespace curvecore::sysc
