// SPDX-License-Identifier: Apache-2.0
// Boards that `scripts/synth.sh --board` makes bitstreams of (scripts/boards): their core, clock,
// sample period and queues.
#pragma once

#include <string>

#include "sysc/host/core_file.hpp"

namespace curvecore::sysc {

struct BoardFile {
    CoreFile core;
    std::string device;  // as sysc/widths/devices.def names it, if it is there
    int segment_queue_words = 0;
    int profile_queue_words = 0;
};

/// By its name, or a file (.json).
/// @throws UsageError: no such board; ref::InputError: no board in the file, a parameter that the
///         core cannot have
BoardFile read_board_file(const std::string& name);

}  // namespace curvecore::sysc
