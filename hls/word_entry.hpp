// SPDX-License-Identifier: Apache-2.0
// The rule of entry into a core's queues: whole frames of valid words, frame after frame, each
// segment from the end of the last one, made for the required digest. The first other word cuts the
// stream.
// Twins: rtl/queue/segment_entry.sv, rtl/queue/piece_entry.sv.
#pragma once

#include "hls/word_check.hpp"

namespace curvecore {
namespace hls {

/// Result of a word at the entry.
enum class Entry {
    kPassed,     // it is in the queue
    kCompleted,  // and ends its frame
    kBadWord,    // invalid here: the stream is cut
    kBadOrder,   // a frame is missing, came twice or is foreign: the stream is cut
    kDropped     // the stream is cut
};

namespace detail {

/// Returns true if the low `bits` of a field of `field_bits` are sign-extended: all bits above
/// equal the sign.
inline bool sign_extended(std::uint64_t word, int bits, int field_bits) {
    const std::uint64_t above =
        (word & ((std::uint64_t(1) << field_bits) - 1)) >> static_cast<unsigned>(bits - 1);
    return above == 0 || above == (std::uint64_t(1) << (field_bits - bits + 1)) - 1;
}

/// The state that both streams share: the place in a frame, the frame's number, the check, the cut.
class FrameEntry {
  public:
    bool cut() const { return cut_; }

  protected:
    /// Properties of a word: it has the number of its frame; it follows on the frame before; it
    /// ends its frame.
    struct Place {
        bool numbered;
        bool follows;
        bool completes;
    };

    Entry verdict(std::uint64_t word, bool can_be, const Place& place) {
        if (cut_) return Entry::kDropped;
        const WordCheck::Above above = place.numbered               ? WordCheck::Above::kNumber
                                       : WordCheck::has_check(tag_) ? WordCheck::Above::kCheck
                                                                    : WordCheck::Above::kNeither;
        const bool tagged = get(kTagField, word) == static_cast<std::uint64_t>(tag_);
        const bool holds =
            above != WordCheck::Above::kCheck || get(kCheckField, word) == check_.of(word, above);
        const bool in_order =
            place.follows && (!place.numbered || get(kSequenceField, word) == sequence_);
        cut_ = !(tagged && can_be && holds && in_order);
        if (!(tagged && can_be && holds)) return Entry::kBadWord;
        if (!in_order) return Entry::kBadOrder;
        check_.pass(word, above);
        if (!place.completes) return Entry::kPassed;
        if (last_) check_.begin_program();
        sequence_ = (sequence_ + 1) & mask(kSequenceField);
        return Entry::kCompleted;
    }

    Tag tag_;            // tag that the next word must have
    bool last_ = false;  // the frame under way ends its program

    FrameEntry(Tag first, std::uint16_t digest) : tag_(first), check_(digest) {}

  private:
    std::uint64_t sequence_ = 0;
    WordCheck check_;
    bool cut_ = false;
};

}  // namespace detail

/// The entry of segments for a core with or without splines, with or without a table.
template <class C>
class SegmentEntry : public detail::FrameEntry, private C {
  public:
    SegmentEntry(const C& format, bool splines, std::uint16_t digest = 0, bool table = false)
        : FrameEntry(Tag::kLength, digest), C(format), splines_(splines), table_(table) {}

    Entry take(std::uint64_t word) {
        const bool completes = C::kFurtherWords > 0
                                   ? further_ == C::kFurtherWords
                                   : tag_ == Tag::kAdvance && axis_ == C::kAxes - 1;
        const bool numbered = tag_ == Tag::kTangent && axis_ == 0;
        const Entry entry = verdict(word, can_be(word), {numbered, follows(word), completes});
        if (tag_ == Tag::kNormal && axis_ == 0) other_turn_ = get(kOtherTurnField, word) != 0;
        if (tag_ == Tag::kEnd) ends_[axis_] = get(kPointField, word);
        if (tag_ == Tag::kTheta) {
            spline_ = get(kKindField, word) == 1;
            k_ = get(kStepExponentField, word);
            last_ = get(kLastField, word) != 0;
        }
        if (entry == Entry::kPassed || entry == Entry::kCompleted) advance(completes);
        return entry;
    }

  private:
    bool can_be(std::uint64_t word) const {
        const bool coef = detail::sign_extended(word, C::kCoefBits, kCoefField.bits);
        switch (tag_) {
            case Tag::kTheta:
                return scale_can_be(word);
            case Tag::kStart:
            case Tag::kEnd:
                return detail::sign_extended(word, C::kFineBits, kPointField.bits);
            case Tag::kTangent:
            case Tag::kAdvance:
            case kFurther:
                return coef;
            case Tag::kNormal:
                return coef && (axis_ != 0 || lambda_can_be(word));
            default:
                return true;
        }
    }

    bool scale_can_be(std::uint64_t word) const {
        const std::uint64_t kind = get(kKindField, word);
        const std::uint64_t theta = get(kCoefField, word);
        const std::uint64_t one = std::uint64_t(1) << (C::kCoefBits - 1);
        if (get(kStepExponentField, word) > kMaxStepExponent) return false;
        if (kind == 3) {
            return table_ && detail::sign_extended(word, C::kCoefBits, kCoefField.bits);
        }
        return theta < one && (kind == 0 || (kind == 1 && splines_ && theta >= one / 2));
    }

    bool lambda_can_be(std::uint64_t word) const {
        const std::uint64_t lambda = get(kLambdaField, word);
        return get({43, 1}, word) == 0 &&
               (spline_ ? lambda <= kMaxStepExponent && k_ <= lambda : lambda == 0);
    }

    /// Returns true if it starts where the last segment ended.
    bool follows(std::uint64_t word) const {
        if (tag_ != Tag::kStart || any_start_ || (other_turn_ && axis_ >= 3)) return true;
        return get(kPointField, word) == ends_[axis_];
    }

    void advance(bool completes) {
        if (completes) {
            any_start_ = false;
            tag_ = Tag::kLength;
            axis_ = further_ = 0;
        } else if (tag_ == kFurther || (tag_ == Tag::kAdvance && axis_ == C::kAxes - 1)) {
            tag_ = kFurther;
            ++further_;
        } else if (tag_ == Tag::kAdvance) {
            tag_ = Tag::kStart;
            ++axis_;
        } else if (tag_ == Tag::kEnd && axis_ >= 3) {
            tag_ = Tag::kAdvance;
        } else {
            tag_ = static_cast<Tag>(static_cast<int>(tag_) + 1);
        }
    }

    static constexpr Tag kFurther = static_cast<Tag>(kFurtherTag);

    bool splines_;
    bool table_;
    int axis_ = 0;
    int further_ = 0;  // number of the further word that comes, from 1; 0: none yet
    bool spline_ = false;
    std::uint64_t k_ = 0;
    bool other_turn_ = false;
    bool any_start_ = true;
    std::uint64_t ends_[C::kMostAxes] = {};
};

class PieceEntry : public detail::FrameEntry {
  public:
    explicit PieceEntry(std::uint16_t digest = 0) : FrameEntry(Tag::kPiece, digest) {}

    Entry take(std::uint64_t word) {
        if (tag_ == Tag::kPiece && !stop_ && get(kTagField, word) == kStopTag) tag_ = Tag::kStop;
        const bool completes = tag_ == Tag::kC3;
        const Entry entry = verdict(word, can_be(word), {tag_ == Tag::kPiece, true, completes});
        if (tag_ == Tag::kPiece) last_ = get(kFinalField, word) != 0;
        if (entry == Entry::kPassed || entry == Entry::kCompleted) {
            stop_ = tag_ == Tag::kStop || (stop_ && tag_ != Tag::kPiece);
            known_ = known_ || tag_ == Tag::kStep;
            tag_ = next(word);
        }
        return entry;
    }

  private:
    static constexpr std::uint64_t kStopTag = static_cast<std::uint64_t>(Tag::kStop);

    Tag next(std::uint64_t word) const {
        if (tag_ == Tag::kC3) return Tag::kPiece;
        if (tag_ == Tag::kStop && get(kStopAgainField, word) != 0) return Tag::kPiece;
        if (tag_ == Tag::kStep) return get(kStepLastField, word) != 0 ? Tag::kPiece : Tag::kStep;
        return static_cast<Tag>(static_cast<int>(tag_) + 1);
    }

    bool can_be(std::uint64_t word) const {
        if (tag_ == Tag::kStop) {
            return get({21, 23}, word) == 0 && get(kStopWaitField, word) != 0 &&
                   (known_ || get(kStopAgainField, word) == 0);
        }
        if (tag_ == Tag::kStep) return get(kStepTicksField, word) != 0;
        if (tag_ != Tag::kPiece) return true;
        const std::uint64_t ticks = get(kPieceTicksField, word);
        const std::uint64_t m = get(kTimeExponentField, word);
        return m <= kMaxTimeExponent && get(kExponentField, word) <= kMaxProfileExponent &&
               ticks >= 1 && ticks <= (std::uint64_t(1) << m) && get({32, 4}, word) == 0;
    }

    bool stop_ = false;   // the next piece already has a branch
    bool known_ = false;  // one came whose steps another may have again
};

}  // namespace hls
}  // namespace curvecore
