// SPDX-License-Identifier: Apache-2.0
// Report of a cam: cam.json, cam.html and its rows of the summary.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sysc/cam/cam_options.hpp"
#include "sysc/cam/cam_watch.hpp"

namespace curvecore::sysc {

/// The helix as it was cut into pieces.
struct CamCut {
    ref::CamHelix helix;
    double pitch = 0;  // pitch of the helix, mm a turn
    double turns = 0;
    std::size_t pieces = 0;
    double deviation = 0;  // mm: greatest distance of a piece from the surface, jumps left out
    double jump = 0;       // mm: greatest jump on the path
    std::vector<float> jumps{0};  // jump of every move, mm; the first move goes to the start
};

struct CamReport {
    const CamOptions& options;
    const ref::CamShape& surface;
    const CamCut& cut;
    const CamWatch& watch;
    double duration_s;

    /// Returns true if every sample is as near to the surface as required.
    bool held() const { return watch.of_allowed() <= 1; }
    nlohmann::ordered_json json() const;
    /// Returns the rows of the summary, name and value.
    std::vector<std::pair<std::string, std::string>> table() const;
    std::string html() const;

  private:
    double scallop() const;       // mm; 0: no cutter given
    double asymptotic() const;    // pieces a turn, mean over the sections
    double radii() const;         // radii of the table
    double linear_radii() const;  // radii of a table read linearly, for the same error
};

}  // namespace curvecore::sysc
