// SPDX-License-Identifier: Apache-2.0
// Foreign text in a comment of a file that is written.
#pragma once

#include <string>

namespace curvecore::sysc {

/// Makes a file's name safe for a comment line: a line break in the name would end the comment.
inline std::string comment_safe(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < ' ') c = '?';
    }
    return text;
}

}  // namespace curvecore::sysc
