// SPDX-License-Identifier: Apache-2.0
// Lines of a program that may run again, with the ends of their loops and subs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ref/gcode/blocks/o_word.hpp"

namespace curvecore::ref {

struct KeptText {
    std::string file;
    std::vector<ProgramLine> lines;

    Place place(std::size_t at) const { return {file, lines[at].number}; }
    /// @throws InputError
    std::optional<OWord> word(std::size_t at, const ProgramParameters& parameters) const {
        return read_o_word_ahead(lines[at].words, parameters, place(at));
    }
};

/// The lines `begin` to `end`, from the O-word on.
struct KeptPart {
    std::shared_ptr<const KeptText> text;
    std::size_t begin = 0;
    std::size_t end = 0;

    int line() const { return text->lines[begin].number; }
};

/// Returns true for subs; their labels are separate from those of loops and ifs.
bool of_subs(OWord::Kind kind);
/// Returns the O-word that ends a loop or a sub.
OWord last_of(const OWord& begin);
/// Returns true if a later line ends it. @throws InputError if that line is invalid there
bool ends(const OWord& begin, const OWord& word, const Place& place);
[[noreturn]] void refuse_unended(const OWord& begin, const Place& place);

/// Returns the sub, or the program of that number, if there is one. @throws InputError
std::optional<KeptPart> find_sub(const std::shared_ptr<const KeptText>& text, const OWord& begin,
                                 const ProgramParameters& parameters);

/// Returns the file that a call names: NAME.ngc, or NAME with the program's own extension, in the
/// program's folder, else in one of `folders`; a number may also be written as O100 and O0100.
/// None: there is no such file. @throws InputError
std::shared_ptr<const KeptText> file_of_sub(const std::string& program,
                                            const std::vector<std::string>& folders,
                                            const std::string& label, Dialect dialect);

}  // namespace curvecore::ref
