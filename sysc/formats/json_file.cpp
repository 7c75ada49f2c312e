// SPDX-License-Identifier: Apache-2.0
#include "sysc/formats/json_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace curvecore::sysc {
namespace {

using Json = nlohmann::ordered_json;

int line_at(const std::string& text, std::size_t at) {
    at = std::min(at, text.size());
    return 1 + static_cast<int>(
                   std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// Line of the first `"key"`, or 1.
int line_of(const std::string& text, const std::string& key) {
    const std::size_t at = text.find('"' + key + '"');
    return at == std::string::npos ? 1 : line_at(text, at);
}

}  // namespace

const Json& member(const Json& json, const char* key, const char* inside) {
    if (json.is_object() && json.contains(key)) return json[key];
    throw JsonFlaw{inside != nullptr ? inside : key, fmt::format("'{}' is missing", key)};
}

double number(const Json& value, const std::string& key) {
    if (!value.is_number()) throw JsonFlaw{key, fmt::format("'{}': not a number", key)};
    return value.get<double>();
}

int whole_number(const Json& value, const std::string& key) {
    const double found = number(value, key);
    if (found == std::floor(found) && std::abs(found) <= std::numeric_limits<int>::max()) {
        return static_cast<int>(found);
    }
    throw JsonFlaw{key, fmt::format("'{}': {:g} is no whole number", key, found)};
}

ref::InputError input_error(const JsonFlaw& flaw, const std::string& text,
                            const std::string& file) {
    return {file, line_of(text, flaw.key), flaw.reason};
}

Json parse_json(const std::string& text, const std::string& file, const std::string& source) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const std::size_t at = std::min(error.byte, text.size());
        const std::size_t last = text.find_last_not_of(" \t\r\n");
        if (last == std::string::npos || error.byte > last + 1) {
            throw ref::InputError(file, line_at(text, last == std::string::npos ? 0 : last),
                                  "the JSON ends too early: is the file cut off? " + source);
        }
        const std::size_t begin = at < 2 ? std::string::npos : text.rfind('\n', at - 2);
        const std::size_t column = begin == std::string::npos ? at : at - begin - 1;
        throw ref::InputError(file, line_at(text, at > 0 ? at - 1 : 0),
                              fmt::format("column {}: is no JSON here; {}", column, source));
    } catch (const Json::out_of_range&) {
        throw ref::InputError(file, 0, "is no JSON: a number is out of range");
    }
}

}  // namespace curvecore::sysc
