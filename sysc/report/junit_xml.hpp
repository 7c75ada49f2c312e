// SPDX-License-Identifier: Apache-2.0
// The checks of a run as test cases, in JUnit's XML, which CI systems show.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sysc/report/report.hpp"

namespace curvecore::sysc {

inline std::string xml_escaped(const std::string& text) {
    std::string made;
    for (const char c : text) {
        switch (c) {
            case '&':
                made += "&amp;";
                break;
            case '<':
                made += "&lt;";
                break;
            case '"':
                made += "&quot;";
                break;
            default:
                // Other control characters have no place in XML.
                made += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
        }
    }
    return made;
}

/// One test suite named after the program, a test case for each check.
inline std::string junit_xml(const Report& report) {
    const std::vector<Check> checks = report.checks();
    const auto failed =
        std::count_if(checks.begin(), checks.end(), [](const Check& check) { return !check.held; });
    const std::string suite = xml_escaped(report.job.options.file);
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n",
        suite, checks.size(), failed);
    for (const Check& check : checks) {
        text += fmt::format("  <testcase classname=\"{}\" name=\"{}\">\n", suite,
                            xml_escaped(check.name));
        text += fmt::format(
            check.held ? "    <system-out>{}</system-out>\n" : "    <failure message=\"{}\"/>\n",
            xml_escaped(check.detail));
        text += "  </testcase>\n";
    }
    return text + "</testsuite>\n";
}

}  // namespace curvecore::sysc
