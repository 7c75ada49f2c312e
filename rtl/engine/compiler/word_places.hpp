// SPDX-License-Identifier: Apache-2.0
// Words for the values of a curve: what other parts read keeps its word, what is read in its part
// alone shares words with others. A sample may come between the steps of a load or a step, so these
// share none.
#pragma once

#include <string>
#include <vector>

#include "rtl/engine/compiler/curve_code.hpp"

namespace curvecore::assembler {

/// Words by value: "theta", "shared 3", "axis 4", ..; wide ones and constants have none.
struct WordPlace {
    std::string word;
    bool of_axis = false;
    bool auxiliary = false;
};
std::vector<WordPlace> place_words(CurveCode& code);

}  // namespace curvecore::assembler
