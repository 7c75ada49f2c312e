// SPDX-License-Identifier: Apache-2.0
// The word of the serial build's program, and the word memory that it works on.
//
// A word is one operation D = C + round(A B / 2^shift) of rtl/serial/folded_datapath.sv, or one
// product of a sum that the last of its words rounds. A result can be read nine clocks later (as C:
// four); frames of at least nine words, or a word that waits for a marked one, keep that distance.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace curvecore::serial {

/// Summands of an address' low nibble; with kContext the high nibble is the context's.
enum Select { kPlain = 0, kOrder = 1, kInner = 2, kRest = 3, kContext = 4 };  // 0, i, j, i - j
struct Address {
    int base;
    Select select = kPlain;
};

/// Returns an index that is `by` higher: an address' low nibble wraps.
constexpr Address above(Address address, int by = 1) {
    return {(address.base & ~15) | ((address.base + by) & 15), address.select};
}
constexpr Address below(Address address) { return above(address, -1); }

/// The word memory: rows of 16 words, 16 for arcs and 16 more for splines.
constexpr Address in_row(int row, Select select = kPlain) { return {row << 4, select}; }
constexpr Address kZero{0xa0};
constexpr Address kOne{0x81};  // CoefBits - 2 fraction bits, as the next three
constexpr Address kMinusOne{0x91};
constexpr Address kMinusTwo{0xad};
constexpr Address kMinusThreeHalves{0xae};
constexpr Address kQuarter{0xaf};
constexpr Address kReciprocal{0xa0, kOrder};
constexpr Address kTheta{0xb7};
constexpr Address advance(int axis) { return {0xc0 + axis}; }
constexpr Address accumulator(int axis) { return {0xd0 + axis, kContext}; }
constexpr Address kTau{0xd3, kContext};

/// Shift of the product, from CoefBits: its code is (shift - CoefBits + 6) modulo 8.
enum Scale {
    kLessSix = 0,
    kMoreFour = 2,
    kLessThree = 3,
    kCoef = 4,  // less two
    kUnit = 5,  // less one
    kSame = 6,
    kMoreOne = 7
};
enum Target { kNowhere = 0, kMemory = 1, kSample = 2, kOrigin = 3 };
enum Control { kGo = 0, kNext, kLoop, kSkip, kHalt, kHaltNoAux, kHaltThreeAux, kLoopHalt };

struct Word {
    Address d{0};
    Address c = kZero;
    Address a = kZero;
    Address b = kZero;
    Scale scale = kUnit;
    Target target = kNowhere;
    Control control = kGo;
    bool first = false;   // a shift less where B is of index 1: there 1/i is no word
    bool more = false;    // a product of a sum that goes on
    bool repeat = false;  // i products, j = 0 .. i-1
    bool mark = false;
    bool wait = false;  // nine clocks or more after the last marked word
};

inline Word make(Address d, Address c, Address a, Address b, Scale scale = kUnit) {
    Word word;
    word.d = d;
    word.c = c;
    word.a = a;
    word.b = b;
    word.scale = scale;
    word.target = kMemory;
    return word;
}
inline Word to(Target target, int axis, Address c, Address a, Address b, Scale scale) {
    Word word = make({axis}, c, a, b, scale);
    word.target = target;
    return word;
}

constexpr int kWordBits = 61;
inline unsigned long long bits(const Address& address) {
    return static_cast<unsigned long long>(address.select << 9 | address.base);
}
inline unsigned long long bits(const Word& word) {
    const auto at = [](int value, int place) {
        return static_cast<unsigned long long>(value) << place;
    };
    return at(word.wait, 60) | at(word.mark, 59) | at(word.repeat, 58) | at(word.more, 57) |
           at(word.control, 54) | at(word.first, 53) | at(word.scale, 50) | at(word.target, 48) |
           bits(word.d) << 36 | bits(word.c) << 24 | bits(word.b) << 12 | bits(word.a);
}

using Words = std::vector<Word>;

class Program {
  public:
    struct Part {
        std::string name;
        std::size_t place;
    };

    void part(const std::string& name) { parts_.push_back({name, words_.size()}); }

    /// Adds a frame. Control stands in its last word but two: the fetch of the last two hides the
    /// branch.
    void frame(Words words, Control control, std::size_t length = 9) {
        if (words.size() < length) words.resize(length);
        words[words.size() - 3].control = control;
        words_.insert(words_.end(), words.begin(), words.end());
    }

    const Words& words() const { return words_; }
    const std::vector<Part>& parts() const { return parts_; }

  private:
    Words words_;
    std::vector<Part> parts_;
};

}  // namespace curvecore::serial
