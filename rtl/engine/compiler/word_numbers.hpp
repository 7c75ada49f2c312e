// SPDX-License-Identifier: Apache-2.0
// The numbers of a configuration that rtl/engine/programs/words.asm and ledger.asm read: places in
// the store, limb by limb, sizes of the queues, widths of words.
#pragma once

#include <cstdint>

#include "hls/words.hpp"
#include "ref/format/parameters.hpp"
#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::assembler {

/// Defines them for queues of so many words; that of segments holds whole ones.
inline void define_words(const ref::CoreParameters& core, int segment_words, int profile_words,
                         Assembly& assembly) {
    constexpr int kLimbs = 3;  // of a queued word
    const int frame = ref::segment_bus_words(core.aux_axes);
    const int profile = kLimbs * segment_words;
    const int stops = profile + kLimbs * profile_words;
    segment_words -= segment_words % frame;
    assembly.define("segment_begin", 0);
    assembly.define("segment_end", kLimbs * segment_words);
    assembly.define("profile_begin", profile);
    assembly.define("profile_end", stops);
    assembly.define("stop_begin", stops);
    assembly.define("segment_queue_words", segment_words);
    assembly.define("profile_queue_words", profile_words);
    // With more words a queue has no room for another frame
    assembly.define("segment_room", segment_words - frame);
    assembly.define("profile_room", profile_words - ref::kProfileBusWords);
    assembly.define("to_end_before", kLimbs * (frame - 1));

    assembly.define("aux_axes", core.aux_axes);
    assembly.define("coef_room", hls::kCoefField.bits - core.coef_bits);
    assembly.define("fine_room", hls::kPointField.bits - core.position_bits - core.guard_bits);
    // Of a spline's phi, 2^9 times; without splines no word has as much
    const int phi = core.coef_bits - 2 + 9;
    assembly.define("least_phi",
                    core.splines != 0 ? std::int64_t{1} << phi : (std::int64_t{1} << 44) - 1);
}

}  // namespace curvecore::assembler
