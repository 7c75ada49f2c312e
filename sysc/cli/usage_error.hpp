// SPDX-License-Identifier: Apache-2.0
// An invalid command line: what() gives the reason.
#pragma once

#include <stdexcept>

namespace curvecore::sysc {

class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace curvecore::sysc
