// SPDX-License-Identifier: Apache-2.0
// Values in a line of RS274/NGC: numbers, parameters, functions and expressions, evaluated as in
// LinuxCNC.
//
//     value       number | #parameter | [expression] | FUNCTION[expression] | ATAN[y]/[x]
//                 | EXISTS[#parameter] | + value | - value
//     parameter   value that is a whole number to 1e-4 | <name>
//     expression  values between operators: ** binds most, then * / MOD, + -, EQ NE GT GE LT LE,
//                 AND OR XOR; equal ones go from left to right; a sign belongs to its value
//
// Angles are in degrees. EQ, NE, GE and LE treat values that differ by less than 1e-6 as equal; a
// truth value is 1 or 0, and any value but 0 is true. FIX and FUP round down and up, ROUND away
// from 0 at a half.
#pragma once

#include <string>

#include "ref/gcode/blocks/program_parameters.hpp"
#include "ref/text/place.hpp"

namespace curvecore::ref {

inline bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }

class ValueReader {
  public:
    /// @param words a line without comments and blanks, in upper case; all outlive this object
    ValueReader(const std::string& words, const ProgramParameters& parameters, const Place& place)
        : words_(words), parameters_(parameters), place_(place) {}

    bool at_end() const { return at_ == words_.size(); }
    /// Returns the next character, 0 at the end.
    char peek() const { return at_end() ? '\0' : words_[at_]; }
    void skip() { ++at_; }
    /// Skips `text` if it comes next; returns true then.
    bool take(std::string_view text);
    std::string rest() const { return words_.substr(at_); }

    /// Reads a value; messages name `what`. @throws InputError
    double value(const std::string& what);
    /// Reads a value that is whole to 1e-4. @throws InputError
    int whole_value(const std::string& what);
    /// Reads the name between '<' and '>', in lower case; '<' comes next. @throws InputError
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
    int depth_ = 0;  // nested brackets and signs
};

/// Returns the whole number within 1e-4 of `value`, if there is one.
std::optional<int> near_whole(double value, double tolerance = 1e-4);

}  // namespace curvecore::ref
