// SPDX-License-Identifier: Apache-2.0
// A page of one file, with its data in it: the script of its template has the mark /*DATA*/ where
// the data's JSON goes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace curvecore::sysc {

/// Of texts that may be any bytes, as file names are.
std::string page_json(const nlohmann::ordered_json& data);

/// No text in the data ends the script, or keeps it from its end.
std::string html_page(std::string_view page, std::string_view json);

}  // namespace curvecore::sysc
