// SPDX-License-Identifier: Apache-2.0
// JSON that a user gives: what is wrong with it is named with its file and line.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "ref/text/input_error.hpp"

namespace curvecore::sysc {

/// A flaw of a value, and its key, whose line is named.
struct JsonFlaw {
    std::string key;
    std::string reason;
};

/// The value of a key. @throws JsonFlaw: there is none; the line is that of the key `inside`
const nlohmann::ordered_json& member(const nlohmann::ordered_json& json, const char* key,
                                     const char* inside = nullptr);
/// The number that the value of `key` is. @throws JsonFlaw
double number(const nlohmann::ordered_json& value, const std::string& key);
int whole_number(const nlohmann::ordered_json& value, const std::string& key);

/// Checks that an object has no other keys than these. @throws JsonFlaw
template <std::size_t Count>
void check_keys(const nlohmann::ordered_json& json, const std::array<std::string_view, Count>& keys,
                const char* what) {
    for (const auto& [key, value] : json.items()) {
        if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
        throw JsonFlaw{key, fmt::format("'{}': {} has {}", key, what, fmt::join(keys, ", "))};
    }
}

/// The error of a flaw in the file's text.
ref::InputError input_error(const JsonFlaw& flaw, const std::string& text, const std::string& file);

/// The text as JSON. `source`: where such a file comes from, "choose -o writes one".
/// @throws ref::InputError with line and column
nlohmann::ordered_json parse_json(const std::string& text, const std::string& file,
                                  const std::string& source);

/// Returns `read` of the JSON in the file's text.
/// @throws ref::InputError, also for a JsonFlaw of `read`
template <class Read>
auto read_json(const std::string& text, const std::string& file, const std::string& source,
               Read&& read) {
    try {
        return std::forward<Read>(read)(parse_json(text, file, source));
    } catch (const JsonFlaw& flaw) {
        throw input_error(flaw, text, file);
    }
}

}  // namespace curvecore::sysc
