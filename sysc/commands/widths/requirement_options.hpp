// SPDX-License-Identifier: Apache-2.0
// Options of `curvecore choose`.
#pragma once

#include "sysc/choose/requirement.hpp"

namespace curvecore::sysc {

struct ChooseOptions {
    Requirement requirement;
    std::string folder;   // empty: no choose.json
    std::string machine;  // LinuxCNC's .ini; empty: the built-in one
    bool confirm = false;
    bool quiet = false;
};

/// The command line as text; empty: not given.
struct RawRequirement {
    std::string error;
    std::string radius;
    std::string least_radius;
    std::string length;
    std::string feed;
    std::string device;
    std::string board;  // instead of device, sample rate and clock
    std::string unit;
    std::string travel;
    std::string sample_rate = "10kHz";
    std::string clock;
    std::string host_words = "100000";
    std::string build;
};

/// Converts the texts. @throws UsageError with the option's name and the reason; ref::InputError of
/// the machine's file
void interpret(const RawRequirement& raw, ChooseOptions& options);

}  // namespace curvecore::sysc
