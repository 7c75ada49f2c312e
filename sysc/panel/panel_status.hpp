// SPDX-License-Identifier: Apache-2.0
// State of a machine under way, as a person sees it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace curvecore::sysc {

struct PanelQueue {
    const char* name;
    int waiting = 0;  // words
    int words = 0;
};

struct PanelOutputs {
    unsigned bits = 0;
    double power = 0;  // 0 .. 1
};

struct PanelAxis {
    char name;
    double place_mm;                     // of the program, as its steps were counted
    std::optional<double> following_mm;  // error, where it has an encoder
};

/// | field             | unit   | remark                                                   |
/// |-------------------|--------|----------------------------------------------------------|
/// | state             |        | "runs", "holds", "waits for words", "off", or how it ended |
/// | path_mm           | mm     | drawn                                                    |
/// | planned_mm        | mm     | planned so far, `all_planned`: of the whole program      |
/// | feed_mm_min       | mm/min | along the path, now                                      |
/// | rate_percent      |        | of time, now                                             |
/// | override_percent  |        | that was asked for                                       |
/// | left_s            | s      | to the end of what is planned, at that override          |
/// | line              |        | of the program                                           |
/// | from              |        | length: where a rest was planned anew, for --rest        |
/// | rest              |        | of a board that is lost, or a program that was stopped:  |
/// |                   |        | options that draw what is left                           |
/// | faults            |        | empty: none                                              |
struct PanelStatus {
    std::string state;
    std::vector<PanelAxis> axes;
    double path_mm = 0;
    double planned_mm = 0;
    bool all_planned = false;
    double feed_mm_min = 0;
    double rate_percent = 0;
    int override_percent = 100;
    double left_s = 0;
    int line = 0;
    std::vector<PanelQueue> queues;
    std::optional<PanelOutputs> outputs;
    std::string from;
    std::string rest;
    std::string faults;
};

/// Returns its lines for a terminal of so many columns; the last one names the keys.
std::vector<std::string> panel_lines(const PanelStatus& status, std::size_t columns);

/// Returns it as JSON, fields named as above.
std::string panel_json(const PanelStatus& status);

}  // namespace curvecore::sysc
