// SPDX-License-Identifier: Apache-2.0
// Entry of words (hls/word_entry.hpp): no word of two plans enters that was lost, doubled, swapped,
// changed, or belongs to another place or to the other plan, one by one and by whole frames whose
// numbers fit. A campaign of 20,000; CURVECORE_DAMAGES sets the number.
#include "hls/word_entry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <random>

#include "ref/feed/planner.hpp"
#include "sysc/words/bus_words.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb::word_entry_test {

using hls::Entry;
using hls::Tag;
using Frames = std::vector<std::vector<std::uint64_t>>;

Tag tag_of(std::uint64_t word) { return static_cast<Tag>(hls::get(hls::kTagField, word)); }

/// A program in both streams.
struct Program {
    explicit Program(unsigned seed) {
        std::mt19937 random(seed);
        ProgramBuilder builder;
        for (int n = 0; n < 4; ++n) {
            const auto mm = [&] { return 1e-3 * static_cast<double>(random() % 60000); };
            builder.line({mm(), mm(), n % 3 == 0 ? 0 : mm()}, 80);
            builder.tangent_arc({0, 0, 1}, {1, 0, 0}, 1 + mm() / 10, 3, 60);
        }
        const ref::Plan plan = make_plan(builder.program(), ref::Machine(), ref::PlanOptions());
        sysc::SegmentWriter writer{sysc::CoreParameters()};
        for (const ref::Segment& segment : plan.segments) segments.push_back(writer.write(segment));
        sysc::ProfileWriter profile;
        for (std::size_t n = 0; n < plan.pieces.size(); ++n) {
            pieces.push_back(profile.write(plan, n));
        }
        branches = plan.branches.size();
    }

    Frames segments;
    Frames pieces;
    std::size_t branches = 0;
};

/// The words that enter, by whole frames; and whether they are cut.
struct Entered {
    Frames frames;
    bool cut = false;
};

template <class EntryOf>
Entered enter(EntryOf entry, const Frames& frames) {
    Entered entered;
    entered.frames.emplace_back();
    for (const auto& frame : frames) {
        for (const std::uint64_t word : frame) {
            const Entry taken = entry.take(word);
            entered.cut = entered.cut || taken == Entry::kBadWord || taken == Entry::kBadOrder;
            if (entered.cut) break;
            entered.frames.back().push_back(word);
            if (taken == Entry::kCompleted) entered.frames.emplace_back();
        }
    }
    entered.frames.pop_back();
    return entered;
}
const sysc::RunTimeFormat& format() {
    static const sysc::RunTimeFormat format{sysc::CoreParameters(), 3};
    return format;
}
Entered enter_segments(const Frames& frames) {
    return enter(hls::SegmentEntry<sysc::RunTimeFormat>(format(), false), frames);
}
Entered enter_pieces(const Frames& frames) { return enter(hls::PieceEntry(), frames); }

TEST(WordEntry, LetsPlansIn) {
    const Program program(1);
    ASSERT_GT(program.branches, 10U);
    const Entered segments = enter_segments(program.segments);
    EXPECT_FALSE(segments.cut);
    EXPECT_EQ(segments.frames, program.segments);
    const Entered pieces = enter_pieces(program.pieces);
    EXPECT_FALSE(pieces.cut);
    EXPECT_EQ(pieces.frames, program.pieces);
}

/// Frames have their own numbers: their checks are the same.
TEST(WordEntry, ProgramsFollowOnEachOtherNumberedOn) {
    Program program(1);
    Frames both = program.pieces;
    for (auto frame : program.pieces) {
        for (std::uint64_t& word : frame) {
            if (tag_of(word) == Tag::kPiece) {
                const std::uint64_t number = both.size() & 0xff;
                word = (word & ~(std::uint64_t{0xff} << 36)) | number << 36;
            }
        }
        both.push_back(frame);
    }
    EXPECT_FALSE(enter_pieces(both).cut);
    // The second program's segments begin where the first one's ended, or are foreign.
    std::vector<std::uint64_t> again = program.segments.front();
    again[4] = (again[4] & ~(std::uint64_t{0xff} << 36)) |
               std::uint64_t{program.segments.size() & 0xff} << 36;
    for (const bool joins : {true, false}) {
        if (joins) {
            for (int axis = 0; axis < 3; ++axis) {
                again[2 + 5 * axis] = program.segments.back()[3 + 5 * axis] -
                                      (std::uint64_t{1} << hls::kTagField.low);
            }
        } else {
            again[12] ^= 1;  // by 2^-10 nm
        }
        hls::WordCheck().seal(again.data(), again.size());
        Frames row = program.segments;
        row.push_back(again);
        EXPECT_EQ(enter_segments(row).cut, !joins);
    }
}

/// Words of a rotary axis leave whole turns out, and say so; a linear one has to join.
TEST(WordEntry, RotaryAxesStartInAnotherTurn) {
    sysc::CoreParameters core;
    core.aux_axes = 2;
    ref::PlanOptions options;
    options.aux_axes = core.aux_axes;
    ref::Machine machine;
    machine.axis[3].rotary = true;
    machine.axis[4].rotary = false;
    ProgramBuilder builder;
    double a = 0;
    double b = 0;
    for (const double turned : {300.0, 500.0, -40.0, 2000.0, -3000.0}) {
        ref::Move& move = builder.line({builder.at().x() + 7, 0, 0}, 20);
        move.aux_start = {a, b};
        move.aux_end = {a += turned, b += 3};
    }
    builder.program().aux_axes = core.aux_axes;
    const ref::Plan plan = make_plan(builder.program(), machine, options);
    sysc::SegmentWriter writer(core);
    Frames frames;
    std::size_t other_turns = 0;
    for (const ref::Segment& segment : plan.segments) {
        frames.push_back(writer.write(segment));
        other_turns += hls::get(hls::kOtherTurnField, frames.back()[5]);
    }
    EXPECT_GE(other_turns, 3U);
    const sysc::RunTimeFormat axes(core, core.axes());
    const hls::SegmentEntry<sysc::RunTimeFormat> entry(axes, false);
    EXPECT_FALSE(enter(entry, frames).cut);
    hls::WordCheck check;
    for (auto& frame : frames) {
        frame[5] &= ~(std::uint64_t{1} << hls::kOtherTurnField.low);
        check.seal(frame.data(), frame.size());
    }
    EXPECT_TRUE(enter(entry, frames).cut);
}

// ---- The campaign

/// A place among the words of some frames.
struct At {
    std::size_t frame;
    std::size_t word;
};

class Damage {
  public:
    Damage(const Frames& ours, const Frames& theirs, std::mt19937& random)
        : ours_(ours), theirs_(theirs), random_(random), frames(ours) {}

  private:
    const Frames& ours_;
    const Frames& theirs_;
    std::mt19937& random_;

  public:
    Frames frames;
    bool near_end = false;  // in or after a word whose frame has one check alone

    static constexpr int kKinds = 12;
    static constexpr std::array<const char*, kKinds> kNames{
        "lost",          "doubled",     "swapped",    "swapped far", "of elsewhere",
        "foreign",       "flipped",     "frame lost", "frame twice", "frame of elsewhere",
        "foreign frame", "branch moved"};

    void make(int kind) {
        const At at = any(frames);
        auto& frame = frames[at.frame];
        std::uint64_t& word = frame[at.word];
        const auto place = frame.begin() + static_cast<std::ptrdiff_t>(at.word);
        near_end = kind >= 2 && kind <= 6 && one_check(frame, at.word);
        switch (kind) {
            case 0:
                frame.erase(place);
                return;
            case 1:
                frame.insert(place, *place);
                return;
            case 2: {
                std::uint64_t& next = at.word + 1 < frame.size()
                                          ? frame[at.word + 1]
                                          : frames[(at.frame + 1) % frames.size()].front();
                std::swap(word, next);
                return;
            }
            case 3: {
                const At other = like(frames, tag_of(word));
                std::swap(word, frames[other.frame][other.word]);
                near_end = near_end || one_check(frames[other.frame], other.word);
                return;
            }
            case 4:
                word = at_of(ours_, like(ours_, tag_of(word)));
                return;
            case 5:
                word = at_of(theirs_, like(theirs_, tag_of(word)));
                return;
            case 6:
                word ^= std::uint64_t{1} << random_() % 48;
                return;
            case 7:
                frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(at.frame));
                return;
            case 8:
                frames.insert(frames.begin() + static_cast<std::ptrdiff_t>(at.frame), frame);
                return;
            case 9:
            case 10: {
                if (at.frame == 0) return;  // the first frame of another program is as good
                const Frames& from = kind == 9 ? ours_ : theirs_;
                const std::uint64_t number = frame[numbered(frame)] >> 36 & 0xff;
                frame = from[random_() % from.size()];
                std::uint64_t& head = frame[numbered(frame)];
                head = (head & ~(std::uint64_t{0xff} << 36)) | number << 36;
                return;
            }
            default: {
                // The words before the piece, or the segment's length and angle
                const auto& other = ours_[any(ours_).frame];
                const auto head = [](const std::vector<std::uint64_t>& words) {
                    return static_cast<std::ptrdiff_t>(
                        tag_of(words.front()) == Tag::kLength ? 2 : words.size() - 5);
                };
                frame.erase(frame.begin(), frame.begin() + head(frame));
                frame.insert(frame.begin(), other.begin(), other.begin() + head(other));
                return;
            }
        }
    }

  private:
    At any(const Frames& all) {
        const std::size_t frame = random_() % all.size();
        return {frame, random_() % all[frame].size()};
    }
    At like(const Frames& all, Tag tag) {
        for (;;) {
            const At at = any(all);
            if (tag_of(at_of(all, at)) == tag) return at;
        }
    }
    static bool one_check(const std::vector<std::uint64_t>& frame, std::size_t word) {
        const auto from = frame.begin() + static_cast<std::ptrdiff_t>(word);
        return std::count_if(from, frame.end(), [](std::uint64_t each) {
                   return hls::WordCheck::has_check(tag_of(each));
               }) == 1;
    }
    static std::uint64_t at_of(const Frames& all, const At& at) { return all[at.frame][at.word]; }
    static std::size_t numbered(const std::vector<std::uint64_t>& frame) {
        return tag_of(frame.front()) == Tag::kLength ? 4 : frame.size() - 5;
    }
};

std::vector<std::uint64_t> joined(const Frames& frames) {
    std::vector<std::uint64_t> words;
    for (const auto& frame : frames) words.insert(words.end(), frame.begin(), frame.end());
    return words;
}

struct Tally {
    int damages = 0;
    int near_end = 0;  // guarded by one byte, others by two or more
    int entered = 0;   // let in although a frame was changed
    int past_two = 0;  // of these, not near the end
};

using EnterAll = std::function<Entered(const Frames&)>;

void campaign(const Frames& ours, const Frames& theirs, const EnterAll& enter_all, int damages) {
    std::mt19937 random(7);
    const std::vector<std::uint64_t> intended = joined(ours);
    Tally all;
    for (int n = 0; n < damages; ++n) {
        const int kind = n % Damage::kKinds;
        Damage damage(ours, theirs, random);
        damage.make(kind);
        if (joined(damage.frames) == intended) continue;
        const Entered entered = enter_all(damage.frames);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < entered.frames.size(); ++i) {
            wrong += entered.frames[i] != ours[i] ? 1 : 0;
        }
        ++all.damages;
        all.near_end += damage.near_end ? 1 : 0;
        all.entered += wrong > 0 ? 1 : 0;
        if (wrong > 0) {
            all.past_two += damage.near_end ? 0 : 1;
            // Two swapped words may be in two frames, and then change both checks alike.
            ASSERT_LE(wrong, kind == 2 || kind == 3 ? 2U : 1U)
                << "it is not found in the next frame: "
                << Damage::kNames[static_cast<std::size_t>(kind)];
        }
        const bool ends = entered.frames.size() + 1 >= ours.size();
        ASSERT_TRUE(entered.cut || ends) << Damage::kNames[static_cast<std::size_t>(kind)];
    }
    printf("%d damages; %d behind a frame's last check but one; %d entered, %d of others\n",
           all.damages, all.near_end, all.entered, all.past_two);
    EXPECT_GT(all.damages, damages / 2);
    EXPECT_LE(all.past_two, 2 + all.damages / 16384) << "two bytes let one in 65,536 pass";
    EXPECT_LE(all.entered, 3 + all.near_end / 128) << "a byte lets one in 256 pass";
}

int damages() {
    const char* count = std::getenv("CURVECORE_DAMAGES");
    return count == nullptr ? 10'000 : std::atoi(count);
}

TEST(WordEntry, KeepsOutSegmentsThatAreNotAsTheyWere) {
    campaign(Program(1).segments, Program(2).segments, enter_segments, damages());
}

TEST(WordEntry, KeepsOutPiecesAndBranchesThatAreNotAsTheyWere) {
    campaign(Program(1).pieces, Program(2).pieces, enter_pieces, damages());
}

}  // namespace curvecore::tb::word_entry_test
