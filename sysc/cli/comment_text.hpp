// SPDX-License-Identifier: Apache-2.0
// Somebody's text in a comment of a file that is written.
#pragma once

#include <string>

namespace curvecore::sysc {

/// A file's name for a comment line: it may hold a line break, which would end it.
inline std::string comment_safe(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < ' ') c = '?';
    }
    return text;
}

}  // namespace curvecore::sysc
