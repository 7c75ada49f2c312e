// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/terminal/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace curvecore::sysc {
namespace {

/// Number of letters to insert, delete, change or swap with the next one.
std::size_t distance(std::string a, std::string b) {
    for (std::string* text : {&a, &b}) {
        std::transform(text->begin(), text->end(), text->begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    }
    std::vector<std::size_t> before;
    std::vector<std::size_t> last;
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before = std::move(last);
        last = row;
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({changed, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
    }
    return row.back();
}

}  // namespace

std::string nearest_text(const std::string& word, const std::vector<std::string>& names,
                         const std::string& otherwise) {
    constexpr std::size_t kMost = 2;
    const auto nearest = std::min_element(names.begin(), names.end(),
                                          [&](const std::string& a, const std::string& b) {
                                              return distance(word, a) < distance(word, b);
                                          });
    const std::size_t wrong = distance(word, *nearest);
    const auto letters = std::count_if(word.begin(), word.end(), [](char c) { return c != '-'; });
    if (wrong <= kMost && 2 * wrong < static_cast<std::size_t>(letters)) {
        return fmt::format("did you mean '{}'?", *nearest);
    }
    return otherwise;
}

std::string names_text(const std::vector<std::string>& names) {
    return fmt::format("there are {}", fmt::join(names, ", "));
}

}  // namespace curvecore::sysc
