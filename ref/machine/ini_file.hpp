// SPDX-License-Identifier: Apache-2.0
// LinuxCNC's .ini syntax, [SECTION], NAME = VALUE and comments, without meaning.
//
// Names are the same in upper and lower case. A line that ends in a backslash continues in the
// next.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace curvecore::ref {

struct IniEntry {
    std::string value;
    int line = 0;
};

class IniFile {
  public:
    /// @throws InputError for a line that is neither a section nor NAME = VALUE, for text that is
    ///         binary, and for #INCLUDE.
    IniFile(std::string_view text, const std::string& file);

    const std::string& file() const { return file_; }
    bool has_section(const std::string& section) const { return sections_.count(section) > 0; }
    /// Returns the entry, if there is one. @throws InputError if it has two values
    std::optional<IniEntry> find(const std::string& section, const std::string& name) const;
    /// Returns the entry as a number. @throws InputError if it is none
    std::optional<double> number(const std::string& section, const std::string& name) const;
    /// Returns every entry that is a number, the first of each name, as "[SECTION]NAME".
    std::map<std::string, double> numbers() const;

  private:
    void read_line(std::string_view line, int number);

    std::string file_;
    std::string section_;
    std::set<std::string> sections_;
    std::map<std::pair<std::string, std::string>, std::vector<IniEntry>> entries_;
};

/// Length of [TRAJ]'s LINEAR_UNITS in mm, 1 if it names none. @throws InputError for units other
/// than mm and inches
double mm_per_unit(const IniFile& ini);

}  // namespace curvecore::ref
