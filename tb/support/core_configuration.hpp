// SPDX-License-Identifier: Apache-2.0
// The configuration of the core that a test is linked with: CONFIGURATION, "Name=Value ..." as its
// model was made (tb/cmake/core_test.cmake).
#pragma once

#include <sstream>
#include <string>

#include "sysc/host/core_parameters.hpp"

namespace curvecore::tb {

struct CoreConfiguration {
    sysc::CoreParameters parameters;
    std::size_t segment_queue_words = 0;
    std::size_t profile_queue_words = 0;
};

/// What the executable was linked with: tb/support/curve_model.cpp or motion_model.cpp.
const CoreConfiguration& core_configuration();

/// @throws sysc::UsageError where a parameter cannot be
inline CoreConfiguration read_configuration(const std::string& text) {
    CoreConfiguration core;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const auto equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const std::string value = word.substr(equals + 1);
        if (name == "Build") {
            core.parameters.build = value == "1" ? sysc::Build::kSerial : sysc::Build::kParallel;
        } else if (name == "SegmentQueueWords") {
            core.segment_queue_words = std::stoul(value);
        } else if (name == "ProfileQueueWords") {
            core.profile_queue_words = std::stoul(value);
        } else {
            sysc::set_parameter(core.parameters, word);
        }
    }
    return core;
}

}  // namespace curvecore::tb
