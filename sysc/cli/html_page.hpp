// SPDX-License-Identifier: Apache-2.0
// An HTML page in one file, with its data inside: the script of its template has the mark /*DATA*/
// where the data's JSON goes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace curvecore::sysc {

/// Writes data as JSON; its texts may be any bytes, as file names are.
std::string page_json(const nlohmann::ordered_json& data);

/// Inserts the data; no text in it ends the script early or hides its end.
std::string html_page(std::string_view page, std::string_view json);

}  // namespace curvecore::sysc
