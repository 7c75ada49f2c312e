// SPDX-License-Identifier: Apache-2.0
// Words for the values of a curve: what other parts read keeps its word, what is read in its part
// alone shares words with others, those of other parts, too.
#pragma once

#include <string>
#include <vector>

#include "rtl/engine/compiler/curve_code.hpp"

namespace curvecore::assembler {

/// Place of a value: a word by its name, or a slot, one of each axis or shared by them. Wide values
/// and constants have neither.
struct WordPlace {
    std::string word;
    int slot = -1;
    bool of_axis = false;
    bool auxiliary = false;
};

/// Numbers of slots: those that are kept come first.
struct SlotCount {
    int kept = 0;
    int all = 0;
    int of_sample = 0;  // up to the last that a sample writes
};

struct WordPlaces {
    std::vector<WordPlace> words;  // by value
    SlotCount shared;
    SlotCount of_axis;
};

/// Slots that all axes share are numbered from `first` on.
WordPlaces place_words(CurveCode& code, int first = 0);

}  // namespace curvecore::assembler
