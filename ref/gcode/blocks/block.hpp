// SPDX-License-Identifier: Apache-2.0
// One line of a program, split into words; knows letters and numbers, not their meaning.
//
// RS274/NGC: upper and lower case are the same, blanks may stand anywhere (also inside a number),
// comments are (...) and ;..., numbers have no exponent and may be parameters, functions and
// expressions. Parameters are assigned after all other words of their line. A '/' at the start of a
// line (block delete) is ignored: the switch is off.
#pragma once

#include <array>
#include <bitset>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ref/gcode/blocks/program_parameters.hpp"
#include "ref/text/place.hpp"

namespace curvecore::ref {

class ValueReader;

/// The words of a line. G codes are held in tenths (G59.1 is 591); G and M words may repeat.
class Block {
  public:
    /// @param words of words_of()
    /// @throws InputError for anything that is not a word, and for a repeated word
    Block(const std::string& words, const Place& place, ProgramParameters& parameters);

    bool empty() const {
        return given_.none() && g.empty() && m.empty() && !polar_radius && !polar_angle;
    }
    bool has(char letter) const { return given_[letter - 'A']; }
    bool has_any(std::string_view letters) const;
    /// Returns the number behind `letter`, which counts as used from now on.
    double use(char letter);
    /// Adds a word as if the line had it.
    void give(char letter, double number);
    /// Returns the number behind `letter` and removes it.
    double take(char letter);
    /// Returns one of these M codes and removes it.
    std::optional<int> take_m(std::initializer_list<int> codes);
    /// Takes this G code, in tenths, out of the block; returns false if it is not there.
    bool take_g(int code);
    bool used(char letter) const { return used_[letter - 'A']; }
    /// @throws InputError if a letter was given and not used
    void check_all_used(const Place& place) const;

    std::optional<double> polar_radius;  // @
    std::optional<double> polar_angle;   // ^, degrees
    std::vector<int> g;
    std::vector<int> m;

  private:
    void add_word(char letter, double number, const Place& place);
    void read_assignment(ValueReader& reader, ProgramParameters& parameters);
    void assign(ProgramParameters& parameters, const Place& place) const;

    /// Assignment of a parameter, by its number or by its name.
    struct Assignment {
        int number;
        std::string name;  // empty: by the number
        double value;
    };

    std::bitset<26> given_;
    std::bitset<26> used_;
    std::array<double, 26> value_{};
    std::vector<Assignment> assignments_;
};

/// Returns `value` of a word that must be a whole number in a range. @throws InputError
int whole_number(char letter, double value, int least, int most, const Place& place);

/// Returns "G59.1" for 591.
std::string g_name(int tenths);

}  // namespace curvecore::ref
