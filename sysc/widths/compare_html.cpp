// SPDX-License-Identifier: Apache-2.0
#include "sysc/widths/compare_report.hpp"
#include "sysc/widths/compare_template.hpp"

namespace curvecore::sysc {

std::string CompareReport::html() const {
    std::string page(kCompareTemplate);
    std::string data = json().dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    // A file name must not close the script.
    for (std::size_t at = 0; (at = data.find("</", at)) != std::string::npos; at += 3) {
        data.replace(at, 2, "<\\/");
    }
    constexpr std::string_view kDataMark = "/*DATA*/";
    page.replace(page.find(kDataMark), kDataMark.size(), data);
    return page;
}

}  // namespace curvecore::sysc
