// SPDX-License-Identifier: Apache-2.0
// The page report.html: one file with its data and its code inside, made from report.html here.
#pragma once

#include <string>

#include "sysc/report/report.hpp"

namespace curvecore::sysc {

/// Data of the page, as JSON.
std::string report_data(const Report& report, const Pictures& pictures);

std::string report_html(const Report& report, const Pictures& pictures);

}  // namespace curvecore::sysc
