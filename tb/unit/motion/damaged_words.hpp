// SPDX-License-Identifier: Apache-2.0
// Words that are damaged between host and core.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <random>

#include "hls/words.hpp"

namespace curvecore::tb {

/// Words of one stream, as they should be and as they come.
struct Stream {
    std::deque<uint64_t>& words;
    const std::deque<uint64_t>& other;
    std::size_t frame;
    hls::Tag first;  // tag of a frame's first word
};

inline hls::Tag tag(uint64_t word) { return static_cast<hls::Tag>(hls::get(hls::kTagField, word)); }

/// Damages words between host and core.
inline void damage(const Stream& stream, std::mt19937& random) {
    std::deque<uint64_t>& words = stream.words;
    const std::size_t at = random() % words.size();
    const auto begin = words.begin() + static_cast<std::ptrdiff_t>(at);
    const auto like_it = [&] {  // another word with the same tag
        std::size_t other = random() % words.size();
        while (tag(words[other]) != tag(*begin)) other = (other + 1) % words.size();
        return words.begin() + static_cast<std::ptrdiff_t>(other);
    };
    switch (random() % 12) {
        case 0:
            words.erase(begin);
            return;
        case 1:
            words.insert(begin, *begin);
            return;
        case 2:
            *begin = 0;
            return;
        case 3:
            *begin = (uint64_t{1} << 48) - 1;
            return;
        case 4:
            *begin = stream.other[random() % stream.other.size()];
            return;
        case 5:
            *begin ^= uint64_t{1} << (44 + random() % 4);
            return;
        case 6:
            std::swap(*begin, words[at == 0 ? 1 : at - 1]);
            return;
        case 7: {  // a whole frame
            auto first = begin;
            while (first != words.begin() && tag(*first) != stream.first) --first;
            if (tag(*first) != stream.first) return;
            words.erase(first, first + static_cast<std::ptrdiff_t>(stream.frame));
            return;
        }
        case 8:
            *begin = *like_it();
            return;
        case 9:
            std::iter_swap(begin, like_it());
            return;
        case 10:
            *begin ^= uint64_t{1} << random() % 44;
            return;
        default:
            words.resize(at);  // the host stops
            return;
    }
}

/// Returns whether a frame with a word that was changed is drawn: its last check, of 8 bits, fits.
/// Behind it the check of 16 bits does not.
inline bool passes(const Stream& stream, const std::deque<uint64_t>& intended, std::size_t until) {
    if (stream.words.size() != intended.size()) return false;
    const auto [changed, was] =
        std::mismatch(stream.words.begin(), stream.words.end(), intended.begin());
    if (changed == stream.words.end()) return false;
    const auto is = [](hls::Tag one, hls::Tag other) {
        return [=](uint64_t word) { return tag(word) == one || tag(word) == other; };
    };
    // A branch is in the frame of the piece behind it.
    const bool branch = is(hls::Tag::kStop, hls::Tag::kStep)(*was);
    const auto head =
        branch ? std::find_if(changed, stream.words.end(), is(stream.first, stream.first))
               : changed;
    const auto next = std::find_if(head == stream.words.end() ? head : head + 1, stream.words.end(),
                                   is(stream.first, hls::Tag::kStop));
    const auto frame_end = static_cast<std::size_t>(next - stream.words.begin());
    return until > frame_end;
}

}  // namespace curvecore::tb
