// SPDX-License-Identifier: Apache-2.0
#include "sysc/cli/html_page.hpp"
#include "sysc/compare/compare_report.hpp"
#include "sysc/compare/compare_template.hpp"

namespace curvecore::sysc {

std::string CompareReport::html() const { return html_page(kCompareTemplate, page_json(json())); }

}  // namespace curvecore::sysc
