// SPDX-License-Identifier: Apache-2.0
#include "tb/support/bench/core_configuration.hpp"

#include <sstream>

#include "sysc/core/core_parameters.hpp"

namespace curvecore::tb {

CoreConfiguration read_configuration(const std::string& text) {
    CoreConfiguration core;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const auto equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const std::string value = word.substr(equals + 1);
        if (name == "Build") {
            core.parameters.build = static_cast<sysc::Build>(std::stoi(value));
        } else if (name == "SegmentQueueWords") {
            core.segment_queue_words = std::stoul(value);
        } else if (name == "ProfileQueueWords") {
            core.profile_queue_words = std::stoul(value);
        } else {
            sysc::single_parameter(word).set(core.parameters);
        }
    }
    return core;
}

}  // namespace curvecore::tb
