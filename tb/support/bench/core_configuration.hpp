// SPDX-License-Identifier: Apache-2.0
// Configuration of the core that a test is linked with: CONFIGURATION, "Name=Value ..." as its
// model was made (tb/cmake/core_test.cmake).
#pragma once

#include <cstddef>
#include <string>

#include "ref/format/parameters.hpp"

namespace curvecore::tb {

struct CoreConfiguration {
    ref::CoreParameters parameters;
    std::size_t segment_queue_words = 0;
    std::size_t profile_queue_words = 0;
};

/// Configuration that the executable was linked with: tb/support/bench/curve_model.cpp or
/// motion_model.cpp.
const CoreConfiguration& core_configuration();

/// Reads a configuration. @throws sysc::UsageError if a parameter is invalid
CoreConfiguration read_configuration(const std::string& text);

}  // namespace curvecore::tb
