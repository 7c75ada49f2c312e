// SPDX-License-Identifier: Apache-2.0
// The numbers of a configuration that rtl/engine/programs read: places in the store, limb by limb,
// sizes of the queues, widths of words.
#pragma once

#include <cstdint>

#include "hls/registers/board_facts.h"
#include "hls/words.hpp"
#include "ref/curves/curve_table.hpp"
#include "ref/format/parameters.hpp"
#include "ref/format/path_words.hpp"
#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::assembler {

/// Entries of the table of powers.asm, at 0, and words of the last piece behind the profile's end.
constexpr int kPowerEntries = 240;
constexpr int kWordsBehind = 4;

/// Changes of ports.asm that programs made before do not know of. Twin: engine_pkg::PortNumbers.
constexpr std::uint16_t kPortNumbers = 2;

/// Number of the core's table, as CORE has it; 0: none.
inline std::uint32_t table_number(const ref::CoreParameters& core) {
    return core.table ? curvecore_table_number(core.table->text.c_str()) : 0;
}

/// CORE of a core: the widths that words are planned for, and its table.
inline std::uint32_t core_word(const ref::CoreParameters& core) {
    return CURVECORE_PUT(CORE_ORDER, core.order) | CURVECORE_PUT(CORE_MODE, core.mode) |
           CURVECORE_PUT(CORE_COEF_BITS, core.coef_bits) |
           CURVECORE_PUT(CORE_POSITION_BITS, core.position_bits) |
           CURVECORE_PUT(CORE_GUARD_BITS, core.guard_bits) |
           CURVECORE_PUT(CORE_TABLE, table_number(core));
}

/// Returns what programs are made for. Twin: engine_pkg::made_for.
inline int made_for(const ref::CoreParameters& core, int segment_words, int profile_words,
                    int rate_bits = 0) {
    std::uint16_t digest = kPortNumbers;
    for (const std::uint32_t word :
         {core_word(core),
          static_cast<std::uint32_t>((rate_bits << 8) + 2 * core.aux_axes + core.splines),
          static_cast<std::uint32_t>(segment_words), static_cast<std::uint32_t>(profile_words)}) {
        digest = curvecore_digest(digest, word);
    }
    return digest & 0x7fff;
}

/// Defines them for queues of so many words; that of segments holds whole ones.
inline void define_words(const ref::CoreParameters& core, int segment_words, int profile_words,
                         Assembly& assembly, int rate_bits = 0) {
    constexpr int kLimbs = 3;  // of a queued word
    assembly.define("own", made_for(core, segment_words, profile_words, rate_bits));
    const int frame = core.segment_words();
    segment_words -= segment_words % frame;  // whole segments
    const int profile = kPowerEntries + kLimbs * segment_words;
    const int profile_end = profile + kLimbs * profile_words;
    const int stops = profile_end + kLimbs * kWordsBehind;
    assembly.define("segment_begin", kPowerEntries);
    assembly.define("segment_end", profile);
    assembly.define("profile_begin", profile);
    assembly.define("profile_end", profile_end);
    assembly.define("stop_begin", stops);
    assembly.define("stop_middle", stops + kLimbs * ref::kStopSteps);
    assembly.define("segment_queue_words", segment_words);
    assembly.define("profile_queue_words", profile_words);
    assembly.define("frame_words", frame);
    assembly.define("segments_full", segment_words - frame + 1);  // without room for another one
    assembly.define("profile_full", profile_words - ref::kProfileBusWords + 1);

    assembly.define("aux_axes", core.aux_axes);
    assembly.define("coef_room", hls::kCoefField.bits - core.coef_bits);
    assembly.define("fine_room", hls::kPointField.bits - core.position_bits - core.guard_bits);
    assembly.define("kinds", core.splines != 0 ? 2 : 1);
    assembly.define("further_words", core.further_words);
    assembly.define("least_phi", core.coef_bits - 2 + 9);  // words.asm has 2^9 times the word
}

}  // namespace curvecore::assembler
