// SPDX-License-Identifier: Apache-2.0
#include "sysc/cli/number_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace {

/// Reader of one list, which names the list in its errors.
class ListReader {
  public:
    ListReader(const std::string& option, const std::string& text) : option_(option), text_(text) {}

    [[noreturn]] void refuse(const std::string& reason) const {
        throw UsageError(fmt::format("{} '{}': {}", option_, text_, reason));
    }

    int number(const std::string& part) const {
        int value = 0;
        const char* end = part.data() + part.size();
        const auto result = std::from_chars(part.data(), end, value);
        if (result.ec != std::errc() || result.ptr != end) {
            refuse("numbers like 6 or 4,6,8 or 24:36:4 are expected");
        }
        return value;
    }

    static std::vector<std::string> split(const std::string& text, char mark) {
        std::vector<std::string> parts(1);
        for (const char c : text) {
            if (c == mark) {
                parts.emplace_back();
            } else {
                parts.back() += c;
            }
        }
        return parts;
    }

  private:
    const std::string& option_;
    const std::string& text_;
};

}  // namespace

std::vector<int> number_list(const std::string& option, const std::string& text, int low,
                             int high) {
    const ListReader reader(option, text);
    std::vector<int> numbers;
    for (const std::string& item : ListReader::split(text, ',')) {
        std::vector<int> ends;
        for (const std::string& part : ListReader::split(item, ':')) {
            ends.push_back(reader.number(part));
        }
        if (ends.size() > 3) reader.refuse("a range is first:last or first:last:step");
        const int first = ends.front();
        const int last = ends.size() > 1 ? ends[1] : first;
        const int step = ends.size() > 2 ? ends[2] : 1;
        if (std::min(first, last) < low || std::max(first, last) > high) {
            throw UsageError(fmt::format("{} must be in [{}, {}]", option, low, high));
        }
        if (step < 1) reader.refuse("a step of 1 or more is expected");
        if (last < first) reader.refuse("the range runs backwards");
        for (int value = first; value <= last; value += step) {
            if (std::find(numbers.begin(), numbers.end(), value) == numbers.end()) {
                numbers.push_back(value);
            }
            if (step > last - value) break;
        }
    }
    return numbers;
}

}  // namespace curvecore::sysc
