// SPDX-License-Identifier: Apache-2.0
// Both streams of random programs, for what judges their words: every field has any value that it
// may have. Some are damaged on their way, some were made wrong, with the right checks.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <random>
#include <vector>

#include "hls/word_check.hpp"
#include "sysc/kernel/run_time_format.hpp"

namespace curvecore::tb {

/// Words of a stream, frame by frame.
using WordFrames = std::vector<std::vector<std::uint64_t>>;

struct Streams {
    WordFrames segments;
    WordFrames pieces;

    /// Returns the words of both, one after the other.
    std::array<std::deque<std::uint64_t>, 2> words() const {
        std::array<std::deque<std::uint64_t>, 2> all;
        for (const auto& frame : segments) all[0].insert(all[0].end(), frame.begin(), frame.end());
        for (const auto& frame : pieces) all[1].insert(all[1].end(), frame.begin(), frame.end());
        return all;
    }
};

class RandomStreams {
  public:
    /// Creates a maker for a configuration and its digest; pieces have up to 2^most_time ticks.
    RandomStreams(const sysc::CoreParameters& core, std::uint16_t digest, std::uint64_t seed,
                  int most_time = hls::kMaxTimeExponent)
        : core_(core),
          format_(core, core.axes()),
          digest_(digest),
          random_(seed),
          most_time_(most_time) {}

    /// Adds a program to both streams; apart: they do not end together.
    void program(Streams& to, bool apart = false) {
        const std::uint64_t pieces = 1 + random_() % 6;
        std::uint64_t ticks = 0;
        std::uint64_t path = 0;
        hls::WordCheck check(digest_);
        bool known = false;  // a branch whose steps another may have
        for (std::uint64_t n = 0; n < pieces; ++n) {
            const hls::ProfileWords words = piece(n + 1 == pieces);
            ticks += static_cast<std::uint64_t>(words.ticks);
            path += static_cast<std::uint64_t>(hls::to_int(words.ds));
            std::vector<std::uint64_t> frame = branch(known);
            known = known || frame.size() > 1;
            frame.resize(frame.size() + hls::kProfileBusWords);
            hls::pack(words, piece_number_++, &frame[frame.size() - hls::kProfileBusWords]);
            check.seal(frame.data(), frame.size());
            to.pieces.push_back(frame);
        }
        if (apart) (random_() % 2 == 0 ? ticks : path) ^= std::uint64_t{1} << random_() % 32;
        segments(to.segments, 1 + random_() % 5, path, ticks);
    }

    /// Changes one stream: a word is lost, doubled, swapped, changed, foreign, or a frame is.
    void damage(Streams& streams) {
        WordFrames& frames = random_() % 2 == 0 ? streams.segments : streams.pieces;
        const std::size_t at = random_() % frames.size();
        std::vector<std::uint64_t>& frame = frames[at];
        const std::size_t place = random_() % frame.size();
        const auto there = [](auto& row, std::size_t n) {
            return row.begin() + static_cast<std::ptrdiff_t>(n);
        };
        switch (random_() % 12) {
            case 0:
                frame.erase(there(frame, place));
                return;
            case 1:
                frame.insert(there(frame, place), frame[place]);
                return;
            case 2:
                std::swap(frame[place], frame[(place + 1) % frame.size()]);
                return;
            case 3:
                frame[place] = random_() & hls::mask({0, 48});
                return;
            case 4:
                frame[place] ^= std::uint64_t{1} << (44 + random_() % 4);
                return;
            case 5: {  // of another frame
                const auto& other = frames[random_() % frames.size()];
                frame[place] = other[random_() % other.size()];
                return;
            }
            case 6:
                frames.erase(there(frames, at));
                return;
            case 7: {
                const std::vector<std::uint64_t> twice = frame;
                frames.insert(there(frames, at), twice);
                return;
            }
            case 8: {  // of a program for another configuration
                RandomStreams others(core_, static_cast<std::uint16_t>(random_()), random_());
                Streams theirs;
                others.program(theirs);
                frames.insert(there(frames, at), theirs.segments.front());
                return;
            }
            default:
                frame[place] ^= std::uint64_t{1} << random_() % 44;
                return;
        }
    }

    /// Number of kinds of a word made wrong.
    static constexpr int kChanges = 29;

    /// Changes a field of a word to what is at the edge of the legal, or beyond; checks are right.
    void change(Streams& streams, int kind) {
        WordFrames& frames = kind < kOfBranch ? streams.segments : streams.pieces;
        const std::size_t first = random_() % frames.size();
        for (std::size_t n = 0; n < frames.size(); ++n) {
            if (change(frames[(first + n) % frames.size()], kind)) break;
        }
        hls::WordCheck check(digest_);
        for (auto& each : frames) check.seal(each.data(), each.size());
    }

  private:
    /// Any value of signed words of this many bits, often an extreme one.
    std::int64_t any(int bits) {
        const std::int64_t most = (std::int64_t{1} << (bits - 1)) - 1;
        switch (random_() % 8) {
            case 0:
                return most;
            case 1:
                return -most - 1;
            case 2:
                return 0;
            default:
                return static_cast<std::int64_t>(random_()) >> (64 - bits);
        }
    }
    /// A number from 0 on, below 2^bits, of any size.
    std::uint64_t size(int bits) {
        return (random_() & hls::mask({0, bits})) >> random_() % static_cast<unsigned>(bits);
    }

    static void set(std::uint64_t& word, hls::Field field, std::uint64_t value) {
        word = (word & ~(mask(field) << field.low)) | (value & mask(field)) << field.low;
    }
    /// Changes a signed field to a value near the ends of so many bits, mostly beyond.
    void set_edge(std::uint64_t& word, hls::Field field, int bits) {
        const std::uint64_t edge = std::uint64_t{1} << (bits - 1);
        set(word, field, (random_() % 2 == 0 ? edge : ~edge) - random_() % 2);
    }
    std::uint64_t one_of(std::initializer_list<std::uint64_t> values) {
        return *(values.begin() + static_cast<std::ptrdiff_t>(random_() % values.size()));
    }

    /// First kinds of a branch and of a piece.
    static constexpr int kOfBranch = 14;
    static constexpr int kOfPiece = 18;

    /// Changes a frame; returns whether it has such a word.
    bool change(std::vector<std::uint64_t>& frame, int kind) {
        const std::size_t branch = frame.size() - hls::kProfileBusWords;
        const auto axis = static_cast<std::size_t>(
            kind == 4 ? 1 + random_() % 2 : random_() % static_cast<unsigned>(core_.axes()));
        const std::size_t start = axis < 3 ? 2 + 5 * axis : 17 + 3 * (axis - 3);
        const std::uint64_t bit = std::uint64_t{1} << random_() % 44;
        std::uint64_t& theta = frame[1];
        std::uint64_t& tangent = frame[4];
        std::uint64_t& normal = frame[5];
        std::uint64_t& head = frame[branch];
        const std::uint64_t k = get(hls::kStepExponentField, theta);
        if (kind >= kOfBranch && kind < kOfPiece && branch == 0) return false;
        if ((kind == 16 || kind == 17) && branch == 1) return false;  // no steps
        switch (kind) {
            case 0:
                set(theta, hls::kKindField, random_());
                return true;
            case 1:
                set(theta, hls::kStepExponentField, 26 + random_() % 6);
                return true;
            case 2:
            case 3:
                set_edge(theta, hls::kCoefField, core_.coef_bits - (kind - 2));
                return true;
            case 4:
            case 5:
                set(normal, hls::kOtherTurnField, random_());
                set(frame[start], hls::kPointField, get(hls::kPointField, frame[start]) ^ bit);
                return true;
            case 6:
                set_edge(frame[start], hls::kPointField, fine_bits());
                return true;
            case 7:
                set_edge(frame[start + 1], hls::kPointField, fine_bits());
                return true;
            case 8:
                if (core_.further_words > 0 && random_() % 2 == 0) {
                    const auto last = static_cast<unsigned>(core_.further_words);
                    set_edge(frame[frame.size() - 1 - random_() % last], hls::kCoefField,
                             core_.coef_bits);
                    return true;
                }
                set_edge(frame[start + 2 + random_() % (axis < 3 ? 3 : 1)], hls::kCoefField,
                         core_.coef_bits);
                return true;
            case 9:
                tangent ^= std::uint64_t{1} << (36 + random_() % 8);
                return true;
            case 10:
            case 11:
                set(normal, hls::kLambdaField, one_of({0, 1, 27, 28, 31, k, k - 1, random_()}));
                return true;
            case 12:
                normal ^= std::uint64_t{1} << one_of({36, 41, 42, 43, 43});
                return true;
            case 13:
                frame[random_() % frame.size()] ^= bit;
                return true;
            case 14:
            case 15:
                set(frame.front(), {0, 44}, kind == 14 ? 0 : one_of({bit, 1 << 20, (1 << 20) - 1}));
                return true;
            case 16:
                set(frame[1], hls::kStepTicksField, 0);
                return true;
            case 17:
                set(frame[1], hls::kStepLastField, random_());
                return true;
            case 18:
                set(head, hls::kTimeExponentField, random_());
                return true;
            case 19:
                set(head, hls::kExponentField, one_of({0, 46, 47, 48, 63}));
                return true;
            case 20:
                set(head, {32, 4}, random_());
                return true;
            case 21:
                set(head, hls::kFinalField, random_());
                return true;
            case 22: {
                const std::uint64_t most = std::uint64_t{1} << get(hls::kTimeExponentField, head);
                set(head, hls::kPieceTicksField, one_of({0, most, most + 1, most + 1, 2 * most}));
                return true;
            }
            case 23:
                head ^= std::uint64_t{1} << (36 + random_() % 8);
                return true;
            case 24:
                frame.front() ^= std::uint64_t{1} << (44 + random_() % 4);
                return true;
            case 25: {  // a branch twice
                const std::vector<std::uint64_t> words(
                    frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(branch));
                frame.insert(frame.begin(), words.begin(), words.end());
                return branch > 0;
            }
            case 26:  // a branch within a piece
                frame[branch + 1 + random_() % 4] = hls::pack_stop(1);
                return true;
            case 27:  // a branch without the steps that follow, or without one before it
                if (branch > 0) frame.front() |= hls::put(hls::kStopAgainField, 1);
                if (random_() % 2 == 0) {
                    frame.erase(frame.begin() + (branch > 0 ? 1 : 0),
                                frame.end() - hls::kProfileBusWords);
                }
                return branch > 0;
            default:
                frame[random_() % frame.size()] ^= bit;
                return true;
        }
    }
    int fine_bits() const { return core_.position_bits + core_.guard_bits; }

    hls::ProfileWords piece(bool final) {
        hls::ProfileWords words;
        words.time_exponent = static_cast<int>(random_() % static_cast<unsigned>(most_time_ + 1));
        const std::uint32_t most = std::uint32_t{1} << words.time_exponent;
        words.ticks = static_cast<std::int32_t>(random_() % 4 == 0 ? most : 1 + random_() % most);
        words.exponent = static_cast<int>(random_() % (hls::kMaxProfileExponent + 1));
        words.final = final;
        words.ds = static_cast<std::int64_t>(size(44));
        for (auto& c : words.c) c = any(hls::kProfileBits);
        return words;
    }

    /// A branch, or none; one that is the one before again is valid behind a `known` one alone.
    std::vector<std::uint64_t> branch(bool known) {
        std::vector<std::uint64_t> words;
        if (random_() % 3 != 0) return words;
        const bool again = known && random_() % 2 == 0;
        words.push_back(hls::pack_stop(static_cast<std::int32_t>(1 + size(19)), again));
        if (again) return words;
        const std::uint64_t steps = 1 + random_() % 5;
        for (std::uint64_t n = 0; n < steps; ++n) {
            hls::StopStep step;
            step.ticks = static_cast<std::int32_t>(1 + random_() % 2047);
            step.change = static_cast<std::int32_t>(random_());
            step.last = n + 1 == steps;
            words.push_back(hls::pack(step));
        }
        return words;
    }

    void segments(WordFrames& to, std::uint64_t count, std::uint64_t path, std::uint64_t ticks) {
        hls::WordCheck check(digest_);
        for (std::uint64_t n = 0; n < count; ++n) {
            sysc::RunSegment words;
            const std::uint64_t rest = count - n;
            words.last = rest == 1;
            // Lengths have 44 bits, and the path is one of up to 6 pieces
            const std::uint64_t least =
                path > (rest - 1) * hls::mask({0, 44}) ? path - (rest - 1) * hls::mask({0, 44}) : 0;
            std::uint64_t length = words.last ? path : least + random_() % (path - least + 1);
            length = std::min(length, hls::mask({0, 44}));
            words.length = static_cast<std::int64_t>(length);
            path -= length;
            words.ticks = static_cast<std::uint32_t>(words.last ? ticks : random_() % (ticks + 1));
            ticks -= words.ticks;
            fill(words);
            std::vector<std::uint64_t> frame(static_cast<std::size_t>(core_.segment_words()));
            hls::pack(words, segment_number_++, frame.data(), format_);
            check.seal(frame.data(), frame.size());
            to.push_back(frame);
        }
    }

    void fill(sysc::RunSegment& words) {
        const bool spline = core_.splines != 0 && random_() % 2 == 0;
        words.kind = spline ? hls::SegmentKind::kSpline : hls::SegmentKind::kArc;
        words.step_exponent = static_cast<int>(random_() % (hls::kMaxStepExponent + 1));
        const std::int64_t half = std::int64_t{1} << (core_.coef_bits - 2);
        const auto below = static_cast<std::int64_t>(random_() & (2 * std::uint64_t(half) - 1));
        words.theta = spline ? half | below : below;
        if (random_() % 4 == 0) words.theta = spline ? half : random_() % 2 == 0 ? 0 : 2 * half - 1;
        if (spline) {
            const auto free = static_cast<unsigned>(hls::kMaxStepExponent - words.step_exponent);
            words.lambda = words.step_exponent + static_cast<int>(random_() % (free + 1));
        }
        if (core_.table && random_() % 3 == 0) {
            words.kind = hls::SegmentKind::kTable;
            words.theta = any(core_.coef_bits);
            words.lambda = 0;
        }
        words.other_turn = random_() % 3 == 0;
        for (int axis = 0; axis < core_.axes(); ++axis) {
            const bool elsewhere = axis >= 3 && words.other_turn;
            words.start[axis] = elsewhere || !joined_ ? any(fine_bits()) : ends_[axis];
            words.end[axis] = ends_[axis] = any(fine_bits());
            words.advance[axis] = any(core_.coef_bits);
            if (axis < 3) {
                words.tangent[axis] = any(core_.coef_bits);
                words.normal[axis] = any(core_.coef_bits);
            }
        }
        for (int n = 0; n < core_.further_words; ++n) words.further[n] = any(core_.coef_bits);
        joined_ = true;
    }

    sysc::CoreParameters core_;
    sysc::RunTimeFormat format_;
    std::uint16_t digest_;
    std::mt19937_64 random_;
    int most_time_;
    unsigned segment_number_ = 0;
    unsigned piece_number_ = 0;
    bool joined_ = false;
    std::int64_t ends_[sysc::kMostAxes] = {};
};

}  // namespace curvecore::tb
