// SPDX-License-Identifier: Apache-2.0
// The lines of a program in the order of execution: O-words, M98 and M99, and Fanuc's GOTO.
//
// Text that runs once is read while it is executed and then forgotten. Text that may run again is
// kept: a loop while it runs, a sub from its definition on, and the rest of the text once a call
// names something further on, or all of it once the program jumps. A sub that the program lacks is
// a file beside it. LinuxCNC's rules hold: conditions are evaluated when they are reached, calls
// nest nine deep, M99 in the program itself ends it, break and continue name their loop; if, loops
// and subs must be nested whole.
#pragma once

#include <functional>
#include <map>

#include "ref/gcode/blocks/kept_text.hpp"

namespace curvecore::ref {

/// Limit of loops and calls that run without a move.
constexpr int kMostBlocksWithoutMove = 1'000'000;
constexpr int kMostBlocksAgain = 10'000'000;

class ProgramFlow {
  public:
    /// @param text, file, parameters outlive this object
    /// @param dialect none: recognised
    /// @param folders of subs' files, behind the program's own
    ProgramFlow(std::istream& text, const std::string& file, ProgramParameters& parameters,
                std::optional<Dialect> dialect, std::vector<std::string> folders = {});
    ProgramFlow(const ProgramFlow&) = delete;
    ProgramFlow& operator=(const ProgramFlow&) = delete;

    /// Returns the next line that is no O-word; none at the end of the program. It stays until the
    /// next call.
    /// @throws InputError
    const ProgramLine* next();
    /// Place of that line.
    Place place() const;
    Dialect dialect() const { return lines_.dialect(); }

    /// Executes M98 of that line: the program of that number, `times` times; or G65, with its #1 ..
    /// #30. @throws InputError
    void call_number(int number, int times,
                     std::optional<std::vector<double>> arguments = std::nullopt);
    /// Executes M99 of that line, which may name a line to go on at; returns false if the program
    /// ends with it. @throws InputError
    bool return_from_number(std::optional<int> line = std::nullopt);
    /// Notes that moves were made: loops may continue.
    void moved() { blocks_without_move_ = 0; }

    /// Called when a sub begins and when it ends.
    std::function<void()> on_call = [] {};
    std::function<void()> on_return = [] {};

  private:
    /// Running lines: the program, a sub, a loop.
    struct Run {
        enum class Kind { kProgram, kSub, kNumber, kLoop };
        Kind kind = Kind::kProgram;
        KeptPart part;                 // no text: lines_
        std::size_t at = 0;            // next line in it
        OWord word;                    // word that begins it
        int called_in = 0;             // line of the program, if this is another file's
        int left = 1;                  // remaining times
        std::vector<std::string> ifs;  // labels of the open ones
        std::optional<std::vector<double>> arguments;  // a call's; none: it shares its caller's

        const std::shared_ptr<const KeptText>& text() const { return part.text; }
    };

    bool fetch();
    std::optional<OWord> word() const;
    std::vector<double> arguments(const OWord& word) const;
    bool is_true(const OWord& word) const { return arguments(word).front() != 0; }

    void obey(const OWord& word);
    void end_branch(const OWord& word);
    void skip_branches(const OWord& begin, bool done);
    bool in_loop(const OWord& word) const;
    void begin_loop(const OWord& word);
    void repeat_loop(const OWord& word);
    void leave_loop(const OWord& word);
    KeptPart keep(const OWord& begin);
    void define(const OWord& word);
    void end_sub(const OWord& word);
    void enter(Run run);
    void leave_sub();
    Run* running_sub();
    Run run_of(const OWord& begin);
    void keep_rest();
    bool obey_macro();
    void go_to(int number);
    bool find_line(int number);
    bool keep_all();
    void count();

    std::istream& stream_;
    const std::string& file_;
    std::vector<std::string> folders_;
    ProgramLines lines_;
    ProgramParameters& parameters_;
    std::vector<Run> runs_;
    std::map<std::string, KeptPart> subs_;
    std::map<std::string, KeptPart> numbers_;
    std::shared_ptr<const KeptText> text_;  // text of the current line; none: the program's
    ProgramLine line_;
    double value_ = 0;  // value of the last sub
    bool value_returned_ = false;
    bool all_kept_ = false;
    int goto_line_ = 0;  // line of the last GOTO; 0: none yet
    int blocks_without_move_ = 0;
    int blocks_again_ = 0;
};

}  // namespace curvecore::ref
