// SPDX-License-Identifier: Apache-2.0
// What is shown of a cam: cam.json, cam.html and its rows of the summary.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sysc/cam/cam_options.hpp"
#include "sysc/cam/cam_watch.hpp"

namespace curvecore::sysc {

/// Of the helix as it was cut into pieces.
struct CamCut {
    ref::CamHelix helix;
    double pitch = 0;  // of the helix, mm a turn
    double turns = 0;
    std::size_t pieces = 0;
    double deviation = 0;         // mm: the worst piece from the surface, jumps left out
    double jump = 0;              // mm: the greatest on the path
    std::vector<float> jumps{0};  // of every move, mm; the first goes to the start
};

struct CamReport {
    const CamOptions& options;
    const ref::CamShape& surface;
    const CamCut& cut;
    const CamWatch& watch;
    double duration_s;

    /// Every sample as near to the surface as it has to be.
    bool held() const { return watch.of_allowed() <= 1; }
    nlohmann::ordered_json json() const;
    /// Name and value, a row each.
    std::vector<std::pair<std::string, std::string>> table() const;
    std::string html() const;

  private:
    double scallop() const;       // mm; 0: no cutter was said
    double asymptotic() const;    // pieces a turn, mean over the sections
    double radii() const;         // of the table
    double linear_radii() const;  // of a table that is read linearly, for the same error
};

}  // namespace curvecore::sysc
