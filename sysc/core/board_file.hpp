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
    std::string device;  // as sysc/cost/devices.def names it, if it is there
    int segment_queue_words = 0;
    int profile_queue_words = 0;
};

/// By its name, or a file (.json).
/// @throws UsageError: no such board; ref::InputError: no board in the file, a parameter that the
///         core cannot have
BoardFile read_board_file(const std::string& name);

/// The name in sysc/cost/devices.def of what a board's table calls family and device: "25k" of
/// ECP5 is ecp5-25, die GW2A-18C is gw2a-18, up5k is itself; empty: not said.
std::string device_of_board(const nlohmann::json& board);
/// The core that motion_board has with these parameters, all of them.
CoreParameters core_of_board(const std::map<std::string, int>& parameters);

}  // namespace curvecore::sysc
