// SPDX-License-Identifier: Apache-2.0
// A place in the input.
#pragma once

#include <string>

#include "ref/text/input_error.hpp"

namespace curvecore::ref {

struct Place {
    const std::string& file;
    int line;
    int program_line = line;  // line of the program that calls this file, if it is another

    [[noreturn]] void refuse(const std::string& reason) const {
        throw InputError(file, line, reason);
    }
};

}  // namespace curvecore::ref
