// SPDX-License-Identifier: Apache-2.0
// Boards that `scripts/synth.sh --board` makes bitstreams of (scripts/boards): their core, clock,
// sample period and queues.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "sysc/core/core_file.hpp"

namespace curvecore::sysc {

struct BoardFile {
    CoreFile core;
    std::string device;  // name in sysc/cost/devices.def, if the device is listed there
    int segment_queue_words = 0;
    int profile_queue_words = 0;
};

/// Reads a board by its name, or from a file (.json).
/// @throws UsageError: no such board; ref::InputError: no board in the file, a parameter that the
/// core cannot have
BoardFile read_board_file(const std::string& name);

/// Translates a board table's family and device to the name in sysc/cost/devices.def: "25k" of ECP5
/// is ecp5-25, die GW2A-18C is gw2a-18, up5k is itself; empty: not given.
/// @throws JsonFlaw (sysc/formats/json_file.hpp)
std::string device_of_board(const nlohmann::ordered_json& board);
/// Returns the core that motion_board has with all these parameters.
CoreParameters core_of_board(const std::map<std::string, int>& parameters);

}  // namespace curvecore::sysc
