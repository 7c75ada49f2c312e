// SPDX-License-Identifier: Apache-2.0
// Wait, for a limited time, until a file or socket can be read.
#pragma once

#include <poll.h>

#include <algorithm>

#include "sysc/link/link.hpp"

namespace curvecore::sysc {

inline bool readable(int handle, WireClock::duration wait) {
    using std::chrono::milliseconds;
    pollfd one{handle, POLLIN, 0};
    const auto time = std::chrono::ceil<milliseconds>(std::max(wait, WireClock::duration::zero()));
    return poll(&one, 1, static_cast<int>(time.count())) > 0;
}

}  // namespace curvecore::sysc
