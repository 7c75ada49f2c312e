// SPDX-License-Identifier: Apache-2.0
// A curve's table as steps of the engine on values, before they have words: what is made of a table
// (table_lowering.hpp), made shorter (code_passes.hpp) and given words (curve_assembler.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::assembler {

/// A word that steps read and write: an order of a row, a copy of one, a constant.
struct Value {
    std::string name;
    bool of_axis = false;
    bool auxiliary = false;  // of an auxiliary axis, in their page
    bool wide = false;
    std::optional<std::int64_t> constant;
    std::string word;  // its word, where others know it by name
};

/// An operand: a value, or as F1 a power of two, positive or -1.
struct Use {
    static constexpr int kMinusOne = -1;

    int value = -1;
    int power = 0;

    bool is_value() const { return value >= 0; }
};

struct Step {
    engine::Op op = engine::Op::kAdd;
    int to = 0;
    Use a;
    Use b;
    bool flag = false;
    Source source;

    /// Returns whether the step reads what it writes.
    bool reads_target() const {
        return op == engine::Op::kMadr || (op == engine::Op::kMac && !flag);
    }
    bool reads(int value) const {
        return a.value == value || b.value == value || (reads_target() && to == value);
    }
};

/// Steps that are executed once, or by each of X Y Z in turn.
struct Block {
    bool of_axes = false;
    std::vector<Step> steps;
};

/// Load, open (anchor and orders, behind load and next), next, sample.
struct Part {
    std::string name;
    std::vector<Block> blocks;
};

struct CurveCode {
    std::string name;
    std::vector<Value> values;
    Part load{"load", {}};
    Part next{"next", {}};
    Part open{"open", {}};
    Part sample{"sample", {}};

    std::vector<Part*> parts() { return {&load, &next, &open, &sample}; }
};

}  // namespace curvecore::assembler
