// SPDX-License-Identifier: Apache-2.0
// report.html: one file with its data and its code in it; report.html in this folder is its shape.
#pragma once

#include <string>

#include "sysc/report/report.hpp"

namespace curvecore::sysc {

std::string report_html(const Report& report, const Pictures& pictures);

}  // namespace curvecore::sysc
