// SPDX-License-Identifier: Apache-2.0
// Steps of a part being written: values by name, and copies of them that are lifted.
#pragma once

#include <map>
#include <set>
#include <string>
#include <tuple>

#include "rtl/engine/compiler/curve_code.hpp"

namespace curvecore::assembler {

class StepWriter {
  public:
    StepWriter(CurveCode& code, int coef_bits) : code_(code), bits_(coef_bits) {}

    void begin(Part& part);
    void from(const Source& source) { source_ = source; }

    /// Returns the value of a name; a new one is as said.
    int value(const std::string& name, bool of_axis, const std::string& word = "");
    int auxiliary(const std::string& name);
    /// Puts a prefix in front of a value's name, which is free then.
    void rename(int value, const std::string& prefix);
    /// Returns a constant, which the listing shows by a name.
    int constant(std::int64_t number, const std::string& shown = "");
    int temporary(bool of_axis);
    int wide(const std::string& name);
    /// Values that no step but those of load change: their copies are made at load.
    void fix(int value) { fixed_.insert(value); }
    bool fixed(int value) const { return fixed_.count(value) != 0 || constant_of(value); }
    const Value& at(int value) const { return code_.values[static_cast<std::size_t>(value)]; }

    /// Adds a step that all axes share, behind all others.
    void share(engine::Op op, int to, Use a, Use b, bool flag = false);
    /// The same in front of the steps of axes that are being written.
    void share_before(engine::Op op, int to, Use a, Use b, bool flag = false);
    /// Adds a step of each axis.
    void each(engine::Op op, int to, Use a, Use b, bool flag = false);
    void put(bool of_axis, engine::Op op, int to, Use a, Use b, bool flag = false) {
        of_axis ? each(op, to, a, b, flag) : share(op, to, a, b, flag);
    }

    /// number 2^lift as F1. @throws AssemblyError if it is no word
    Use multiplier(std::int64_t number, int lift, const std::string& shown = "");
    /// Returns number * value * 2^lift, from an own step unless it is there.
    int lifted(int value, int number, int lift);
    /// Steps that lifted() would cost; those of load cost a word only.
    int lift_cost(int value, int lift) const;

    [[noreturn]] void refuse(const std::string& reason) const;

  private:
    bool constant_of(int value) const { return at(value).constant.has_value(); }
    void changed(int value);
    Block& open(bool of_axes);

    CurveCode& code_;
    int bits_;
    Part* part_ = nullptr;
    Source source_;
    std::map<std::string, int> names_;
    std::set<int> fixed_;
    std::map<std::tuple<int, int, int>, int> copies_;
    std::map<int, int> negatives_;  // values by their negative copies
    std::set<int> of_group_;        // shared values that the open steps of axes change
    int temporaries_ = 0;
};

}  // namespace curvecore::assembler
