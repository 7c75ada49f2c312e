// SPDX-License-Identifier: Apache-2.0
// A table that is written line by line, and its text once the fractions of its rows are known.
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace curvecore::ref {

/// Lines of a formula's table: ref/curves/derive/derive_table.hpp has its rows mu, phi, e1 ..
class TableText {
  public:
    void line(const std::string& section, const std::string& row, const std::string& terms) {
        sections_[section].emplace_back(row, terms);
    }
    void head(const std::string& text) { head_.push_back(text); }
    void number(const std::string& row) { numbers_.push_back(row); }
    const std::vector<std::string>& numbers() const { return numbers_; }
    void state(const std::string& row) { states_.push_back(row); }
    const std::vector<std::string>& states() const { return states_; }

    std::string text(const std::map<std::string, int>& fractions) const {
        const auto of = [&](const std::string& row) {
            const auto found = fractions.find(row);
            return fmt::format("{:+}", found == fractions.end() ? 0 : found->second);
        };
        std::string text = "# SPDX-License-Identifier: Apache-2.0\n";
        for (const std::string& line : head_) text += line + "\n";
        text += fmt::format("word mu {}", of("mu"));
        for (int n = 1; n <= frame; ++n) text += fmt::format("  e{}[3] -2", n);
        for (const std::string& row : numbers_) text += fmt::format("  {} {}", row, of(row));
        text += "\nstart";
        for (const std::string& row : states_) text += fmt::format(" {} {}", row, of(row));
        text += "\n";
        const char* const fields[] = {"tangent", "normal", "advance"};
        text += "bus theta mu";
        for (int n = 1; n <= frame; ++n) text += fmt::format("  {} e{}", fields[n - 1], n);
        int further = 0;
        for (const auto* rows : {&states_, &numbers_}) {
            for (const std::string& row : *rows) {
                text += fmt::format("  further.{} {}", further++, row);
            }
        }
        text += "\npower e1 0";
        for (const auto* rows : {&states_, &numbers_}) {
            for (const std::string& row : *rows) text += fmt::format("  {} 0", row);
        }
        text += "\noutput x\n";
        for (const char* section : {"anchor", "order", "next"}) {
            text += std::string(section) + "\n";
            for (const auto& [row, terms] : sections_.at(section)) {
                const std::string name = row.substr(0, row.find('['));
                const bool axes = name != row;
                text += fmt::format("  {} : {} = {}\n", row, axes ? "-2" : of(name), terms);
            }
        }
        return text;
    }

    int frame = 2;  // vectors e1, e2 ..

  private:
    std::vector<std::string> head_;
    std::vector<std::string> numbers_;
    std::vector<std::string> states_;
    std::map<std::string, std::vector<std::pair<std::string, std::string>>> sections_;
};

}  // namespace curvecore::ref
