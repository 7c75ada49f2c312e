// SPDX-License-Identifier: Apache-2.0
// Contents of a frame as a board reads it: rtl/line/frame_reader.sv.
#pragma once

#include <cstddef>

#include "sysc/link/slip.hpp"

namespace curvecore::sysc {

struct FrameContents {
    bool whole = true;  // no invalid command
    bool writes = false;
    std::size_t words_read = 0;
};
FrameContents contents_of(const Bytes& frame);

}  // namespace curvecore::sysc
