// SPDX-License-Identifier: Apache-2.0
// The check of words over themselves and all words before them in their program: a CRC of 16 bits,
// its bytes' sum in each word that has room for it. A word that is lost, doubled, swapped, changed
// or of other frames changes the check, and so do whole frames whose numbers fit. The CRC begins
// with the digest of the configuration that the words are made for: words for another one fail the
// first check or the second, in their first frame. Twin: rtl/queue/frame_entry.sv.
//
//   check' = 2^8 check + [15:0] + [31:16] + [43:32]    of the word, modulo x^16 + x^3 + 1
//
// A word's check is the sum (xor) of both bytes of check': one detects every single changed bit,
// two every change of the sum before. A frame's number and the check itself are left out, so frames
// may be renumbered.
#pragma once

#include <cstddef>

#include "hls/words.hpp"

namespace curvecore {
namespace hls {

class WordCheck {
  public:
    explicit WordCheck(std::uint16_t digest = 0) : digest_(digest), check_(digest) {}

    /// Content of a word's bits [43:36]: the number of its frame, its check, or neither.
    enum class Above { kNumber, kCheck, kNeither };

    /// Returns the check of the next word, whether it has one or not.
    std::uint64_t of(std::uint64_t word, Above above) const {
        const std::uint64_t check = after(word, above);
        return (check >> 8 ^ check) & mask(kCheckField);
    }
    void pass(std::uint64_t word, Above above) { check_ = after(word, above); }
    void begin_program() { check_ = digest_; }

    /// Puts checks into a whole frame: a segment, or a piece with its stop branch.
    void seal(std::uint64_t* words, std::size_t count) {
        bool numbered = false;
        bool last = false;
        for (std::uint64_t* word = words; word != words + count; ++word) {
            const Tag tag = static_cast<Tag>(get(kTagField, *word));
            const bool number = !numbered && (tag == Tag::kTangent || tag == Tag::kPiece);
            const Above above = number           ? Above::kNumber
                                : has_check(tag) ? Above::kCheck
                                                 : Above::kNeither;
            numbered = numbered || number;
            last = last || (tag == Tag::kTheta && get(kLastField, *word) != 0) ||
                   (tag == Tag::kPiece && get(kFinalField, *word) != 0);
            if (above == Above::kCheck) {
                *word &= ~(mask(kCheckField) << kCheckField.low);
                *word |= of(*word, above) << kCheckField.low;
            }
            pass(*word, above);
        }
        if (last) begin_program();
    }

    static bool has_check(Tag tag) {
        return tag == Tag::kAdvance || tag == Tag::kC1 || tag == Tag::kC2 || tag == Tag::kC3;
    }

  private:
    std::uint64_t after(std::uint64_t word, Above above) const {
        word &= mask({0, kTagField.low});
        if (above != Above::kNeither) word &= ~(mask(kCheckField) << kCheckField.low);
        const std::uint64_t top = check_ >> 8;
        const std::uint64_t shifted = check_ << 8 ^ top << 3 ^ top;
        return (shifted ^ word ^ word >> 16 ^ word >> 32) & 0xffff;
    }

    std::uint64_t digest_;
    std::uint64_t check_;
};

}  // namespace hls
}  // namespace curvecore
