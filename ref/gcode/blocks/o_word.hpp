// SPDX-License-Identifier: Apache-2.0
// A line that begins with an O-word: its label and its keyword.
//
//     O100 SUB | ENDSUB [value] | RETURN [value] | CALL [value] ..
//     O100 IF [value] | ELSEIF [value] | ELSE | ENDIF
//     O100 WHILE [value] | ENDWHILE | DO | REPEAT [value] | ENDREPEAT | BREAK | CONTINUE
//     O100                                      the number of a program; labels may be <name> too
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ref/gcode/blocks/program_parameters.hpp"
#include "ref/gcode/lines/program_lines.hpp"

namespace curvecore::ref {

struct OWord {
    enum class Kind {
        kNumber,
        kSub,
        kEndsub,
        kReturn,
        kCall,
        kIf,
        kElseif,
        kElse,
        kEndif,
        kWhile,
        kEndwhile,
        kDo,
        kRepeat,
        kEndrepeat,
        kBreak,
        kContinue
    };

    Kind kind = Kind::kNumber;
    std::string label;          // as in "100" and "<name>"
    std::size_t arguments = 0;  // where they begin in the line

    std::string name() const;  // "o100 while"
};

/// Reads the O-word of a line; none if it has no O-word. @throws InputError
std::optional<OWord> read_o_word(const std::string& words, const ProgramParameters& parameters,
                                 const Place& place);

/// Reads the O-word of a line that is looked at, but not executed: a label that is a value (o#1,
/// o[#2+1]) may have none yet, and then names nothing.
std::optional<OWord> read_o_word_ahead(const std::string& words,
                                       const ProgramParameters& parameters, const Place& place);

/// Evaluates the brackets behind it. @throws InputError
std::vector<double> o_word_arguments(const OWord& word, const std::string& words,
                                     const ProgramParameters& parameters, const Place& place);

}  // namespace curvecore::ref
