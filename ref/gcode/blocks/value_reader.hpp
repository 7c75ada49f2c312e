// SPDX-License-Identifier: Apache-2.0
// Values in a line of RS274/NGC: numbers, parameters, functions and expressions, as LinuxCNC
// evaluates them.
//
//     value       number | #parameter | [expression] | FUNCTION[expression] | ATAN[y]/[x]
//                 | EXISTS[#parameter] | + value | - value
//     parameter   value that is a whole number to 1e-4 | <name>
//     expression  values between operators: ** binds most, then * / MOD, + -, EQ NE GT GE LT LE,
//                 AND OR XOR; equal ones go from left to right; a sign belongs to its value
//
// Angles are in degrees. EQ, NE, GE and LE take what differs by less than 1e-6 for equal; a truth
// is 1 or 0, and what is not 0 is true. FIX and FUP round down and up, ROUND away from 0 at a half.
#pragma once

#include <string>

#include "ref/gcode/blocks/program_parameters.hpp"
#include "ref/text/place.hpp"

namespace curvecore::ref {

class ValueReader {
  public:
    /// @param words a line without comments and blanks, in upper case; all outlive this object
    ValueReader(const std::string& words, const ProgramParameters& parameters, const Place& place)
        : words_(words), parameters_(parameters), place_(place) {}

    bool at_end() const { return at_ == words_.size(); }
    /// 0 at the end.
    char peek() const { return at_end() ? '\0' : words_[at_]; }
    void skip() { ++at_; }
    /// Passes over `text` if it comes next.
    bool take(std::string_view text);
    std::string rest() const { return words_.substr(at_); }

    /// A value; `what` wants it, for messages. @throws InputError
    double value(const std::string& what);
    /// One that is whole to 1e-4. @throws InputError
    int whole_value(const std::string& what);
    /// What stands between '<' and '>', in lower case; '<' comes next. @throws InputError
    std::string name();

    [[noreturn]] void refuse(const std::string& reason) const { place_.refuse(reason); }

  private:
    double unchecked_value(const std::string& what);
    double plain_number(const std::string& what);
    double parameter();
    double function(const std::string& what);
    double exists();
    double bracketed(const std::string& what);
    double operation(int least_binding);
    double finite(double value) const;

    const std::string& words_;
    const ProgramParameters& parameters_;
    const Place& place_;
    std::size_t at_ = 0;
    int depth_ = 0;  // of brackets and signs
};

/// `value` to 1e-4 of a whole number; nothing: it is none.
std::optional<int> near_whole(double value, double tolerance = 1e-4);

}  // namespace curvecore::ref
