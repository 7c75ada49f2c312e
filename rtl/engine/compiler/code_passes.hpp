// SPDX-License-Identifier: Apache-2.0
// Steps made fewer, with the same words.
#pragma once

#include <vector>

#include "rtl/engine/compiler/curve_code.hpp"

namespace curvecore::assembler {

/// Leaves out what nothing reads.
void drop_unread(CurveCode& code);

/// Makes one MADR of a product and the sum that alone reads it, where a factor is read no more: the
/// factor then stands in the sum's word.
void fuse_products(CurveCode& code);

/// Makes one of two wide values if no step of one comes between the steps of the other.
void share_wides(CurveCode& code);

/// Makes one constant of those that are others times powers of two, where the other factor of a
/// product can be lifted.
void share_constants(std::vector<CurveCode>& codes, int coef_bits);

}  // namespace curvecore::assembler
