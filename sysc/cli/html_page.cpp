// SPDX-License-Identifier: Apache-2.0
#include "sysc/cli/html_page.hpp"

#include <nlohmann/json.hpp>

namespace curvecore::sysc {

std::string page_json(const nlohmann::ordered_json& data) {
    return data.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string html_page(std::string_view page, std::string_view json) {
    constexpr std::string_view kMark = "/*DATA*/";
    const std::size_t mark = page.find(kMark);
    std::string filled(page.substr(0, mark));
    for (const char letter : json) {
        if (letter == '<') {  // occurs only in texts: in </script>, in <!--
            filled += "\\u003c";
        } else {
            filled += letter;
        }
    }
    return filled.append(page.substr(mark + kMark.size()));
}

}  // namespace curvecore::sysc
