// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/part/publish.hpp"

#include "sysc/commands/terminal/summary.hpp"
#include "sysc/report/junit_xml.hpp"
#include "sysc/report/report_html.hpp"
#include "sysc/report/segments_json.hpp"

namespace curvecore::sysc {

int publish(const Report& report, const Pictures& pictures, OutputFolder& folder) {
    if (report.job.options.segments_file) {
        OutputFile segments(folder, "segments.json");
        write_segments(report.job, [&segments](const std::string& text) { segments.write(text); });
        segments.close();
    }
    folder.write("report.json", report.json().dump(2) + "\n");
    folder.write("report.html", report_html(report, pictures));
    if (report.job.options.junit) folder.write("junit.xml", junit_xml(report));
    folder.commit();
    print_summary(report);
    return report.held() ? 0 : 1;
}

}  // namespace curvecore::sysc
