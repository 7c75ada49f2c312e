// SPDX-License-Identifier: Apache-2.0
// O-words, M98 and M99: which lines are executed, in which order, and which are refused.
#include "ref/gcode/blocks/program_flow.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "ref/program/gcode_reader.hpp"
#include "ref/program/gcode_stream.hpp"

namespace curvecore::tb::program_flow_test {

namespace fs = std::filesystem;
using ref::InputError;

/// The X of all moves of a program, which begins with G90 G1 F600.
std::string path(const std::string& text, const std::string& file = "part.ngc") {
    std::string xs;
    for (const ref::Move& move : ref::read_gcode_text("G90 G1 F600\n" + text, file).moves) {
        std::ostringstream x;
        x << move.end.x();
        xs += (xs.empty() ? "" : " ") + x.str();
    }
    return xs;
}

std::string refusal(const std::string& text) {
    try {
        return path(text);
    } catch (const InputError& error) {
        return error.what();
    }
}

TEST(ProgramFlow, IfTakesTheFirstBranchThatIsTrue) {
    for (int x = 0; x < 4; ++x) {
        const std::string text = "#1=" + std::to_string(x) +
                                 "\no1 if [#1 eq 0]\nX10\no1 elseif [#1 eq 1]\nX11\n"
                                 "o1 elseif [#1 lt 3]\nX12\no1 else\nX13\no1 endif\nX99\n";
        EXPECT_EQ(path(text), std::to_string(10 + x) + " 99");
    }
}

TEST(ProgramFlow, IfsStandInIfs) {
    EXPECT_EQ(path("o1 if [1]\no2 if [0]\nX1\no2 else\nX2\no2 endif\nX3\no1 else\no3 if [1]\nX4\n"
                   "o3 endif\no1 endif\nX5\n"),
              "2 3 5");
    EXPECT_EQ(path("o1 if [0]\no2 if [1]\nX1\no2 endif\no1 endif\nX5\n"), "5");
    EXPECT_EQ(path("o1 if [0]\no2 while [1]\nX1\no1 endif\nX5\n"), "5");  // skipped text
}

TEST(ProgramFlow, WhileTestsAtItsBegin) {
    EXPECT_EQ(path("#1=1\no1 while [#1 le 3]\nX#1\n#1=[#1+1]\no1 endwhile\nX9\n"), "1 2 3 9");
    EXPECT_EQ(path("o1 while [0]\nX1\no1 endwhile\nX9\n"), "9");
}

TEST(ProgramFlow, DoTestsAtItsEnd) {
    EXPECT_EQ(path("#1=1\no1 do\nX#1\n#1=[#1+1]\no1 while [#1 le 3]\nX9\n"), "1 2 3 9");
    EXPECT_EQ(path("o1 do\nX1\no1 while [0]\nX9\n"), "1 9");
}

TEST(ProgramFlow, RepeatCountsWithTheValueAtItsBegin) {
    EXPECT_EQ(path("#1=3\no1 repeat [#1]\nX#1\n#1=[#1+1]\no1 endrepeat\n"), "3 4 5");
    EXPECT_EQ(path("o1 repeat [0]\nX1\no1 endrepeat\nX9\n"), "9");
    EXPECT_EQ(path("o1 repeat [-2]\nX1\no1 endrepeat\nX9\n"), "9");
}

TEST(ProgramFlow, LoopsStandInLoops) {
    EXPECT_EQ(path("#1=0\no1 repeat [2]\n#2=0\no2 while [#2 lt 2]\n#1=[#1+1]\nX#1\n#2=[#2+1]\n"
                   "o2 endwhile\nX[#1*100]\no1 endrepeat\n"),
              "1 2 200 3 4 400");
}

TEST(ProgramFlow, BreakAndContinueNameTheirLoop) {
    EXPECT_EQ(path("#1=0\no1 while [1]\n#1=[#1+1]\no2 if [#1 eq 2]\no1 continue\no2 endif\n"
                   "o3 if [#1 eq 4]\no1 break\no3 endif\nX#1\no1 endwhile\nX9\n"),
              "1 3 9");
    EXPECT_EQ(path("#1=0\no1 do\n#1=[#1+1]\no2 repeat [5]\nX#1\no1 continue\no2 endrepeat\n"
                   "o1 while [#1 lt 3]\nX9\n"),
              "1 2 3 9");
    EXPECT_EQ(path("o1 repeat [5]\no2 repeat [5]\nX1\no1 break\no2 endrepeat\no1 endrepeat\nX9\n"),
              "1 9");
}

TEST(ProgramFlow, SubsHaveArgumentsAndValues) {
    EXPECT_EQ(path("o100 sub\nX#1\nX#2\nX#3\n#1=50\no100 endsub [#1+1]\n#1=7\n"
                   "o100 call [#1*2] [5]\nX#1\nX#<_value>\nX#<_value_returned>\n"),
              "14 5 0 7 51 1");
    EXPECT_EQ(path("o<double it> sub\no1 if [#1 gt 5]\no<doubleit> return [#1*2]\no1 endif\n"
                   "X1\no<doubleit> endsub\no<DoubleIt> call [6]\nX#<_value>\n"
                   "o<doubleit> call [5]\nX[#<_value>+#<_value_returned>+3]\n"),
              "12 1 3");
}

TEST(ProgramFlow, ReturnHasAnyLabel) {
    EXPECT_EQ(path("o1 sub\no2 if [#1 gt 5]\no2 return [9]\no2 endif\nX1\no1 endsub\n"
                   "o1 call [6]\nX#<_value>\no1 call [5]\n"),
              "9 1");
}

TEST(ProgramFlow, SubsHaveNamesOfTheirOwn) {
    EXPECT_EQ(
        path("o1 sub\n#<a>=5\n#<_all>=6\nX#<a>\no1 endsub\n#<a>=1\no1 call\nX#<a>\nX#<_all>\n"),
        "5 1 6");
    EXPECT_EQ(path("o1 sub\nX[10+exists[#<a>]]\no1 endsub\n#<a>=1\no1 call\n"), "10");
}

TEST(ProgramFlow, SubsCallThemselves) {
    EXPECT_EQ(path("o1 sub\no2 if [#1 gt 1]\no1 call [#1-1]\no1 return [#<_value>*#1]\no2 endif\n"
                   "o1 endsub [1]\no1 call [6]\nX#<_value>\n"),
              "720");
}

TEST(ProgramFlow, SubsMayStandBehindTheirCall) {
    EXPECT_EQ(path("o1 repeat [2]\n#31=[#31+1]\no200 call [#31]\no1 endrepeat\nX9\no200 "
                   "sub\nX#1\no200 endsub\n"
                   "X10\nM2\n"),
              "1 2 9 10");
}

TEST(ProgramFlow, NumbersOfSubsMayBeComputed) {
    EXPECT_EQ(path("o101 sub\nX1\no101 endsub\no102 sub\nX2\no102 endsub\n#1=101\n"
                   "o[#1+1] call\no#1 call\n"),
              "2 1");
}

TEST(ProgramFlow, LabelsThatAreValuesMayGetThemLater) {
    EXPECT_EQ(path("o1 sub\nX1\no1 endsub\no2 sub\n#<sub>=1\no#<sub> call\no2 endsub\n"
                   "o3 if [0]\no#<no> call\no3 endif\no2 call\n"),
              "1");
    EXPECT_EQ(refusal("o#<no> call\n"),
              "part.ngc:2: error: #<no> has no value yet: assign it before");
}

TEST(ProgramFlow, FanucsMacrosLoopAndBranch) {
    EXPECT_EQ(path("#1=1\nWHILE [#1 LE 3] DO1\nX#1\n#1=[#1+1]\nEND1\nX9\n"), "1 2 3 9");
    EXPECT_EQ(path("#1=0\nN5 WHILE[#1LT2]DO1\n#2=0\nWHILE[#2LT2]DO2\n#3=[#3+1]\nX#3\n#2=[#2+1]\n"
                   "END2\n#1=[#1+1]\nEND1\n"),
              "1 2 3 4");
    EXPECT_EQ(path("#1=5\nIF [#1 EQ 5] THEN #1=7\nIF [#1 EQ 5] THEN #1=8\nX#1\n"
                   "IF [#1 EQ 7] THEN X2\n"),
              "7 2");
    EXPECT_EQ(path("DO3\n#1=[#1+1]\nX#1\nIF [#1 EQ 3] GOTO 20\nEND3\nX50\nN20 X60\n"), "1 2 3 60");
}

TEST(ProgramFlow, GotoGoesOnAtALineOfItsProgram) {
    EXPECT_EQ(path("GOTO 20\nX1\nN0020 X2\n"), "2");
    EXPECT_EQ(path("#1=1\nN10 X#1\n#1=[#1+1]\nIF [#1 LE 3] GOTO [5+5]\nX9\n"), "1 2 3 9");
    EXPECT_EQ(path("M98 P7\nX1\nIF [#31 LT 2] GOTO 10\nM30\nN10 X5\nM30\nO7\n#31=[#31+1]\n"
                   "GOTO 10\nX2\nN10 X3\nM99\n"),
              "3 1 5");
    // A sub that a call has found, and that the program passes again.
    EXPECT_EQ(path("N1 o5 call\no5 sub\n#31=[#31+1]\nX#31\no5 endsub\nIF [#31 LT 2] GOTO 1\nX9\n"),
              "1 2 9");
    EXPECT_EQ(refusal("N1 #1=2\nGOTO 1\n"),
              "part.ngc:2: error: 1000000 blocks without a move: does GOTO of line 3 ever end?");
}

/// Text that cannot go back, as standard input.
class OneWay : public std::stringbuf {
  public:
    using std::stringbuf::stringbuf;

  protected:
    pos_type seekpos(pos_type, std::ios_base::openmode) override { return pos_type(off_type(-1)); }
};

TEST(ProgramFlow, GotoBackWantsAFile) {
    const auto read = [](const std::string& text) {
        OneWay buffer(text);
        std::istream stream(&buffer);
        ref::GcodeStream program(stream, "stdin",
                                 {ref::kFitTolerance, ref::Dialect::kLinuxcnc, {}});
        ref::Move move;
        int moves = 0;
        while (program.next(move)) ++moves;
        return moves;
    };
    EXPECT_EQ(read("G1 F600 X1\nGOTO 5\nX2\nN5 X3\n"), 2);
    try {
        read("N5 G1 F600 X1\nGOTO 5\n");
        ADD_FAILURE() << "nothing is wrong";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "stdin:2: error: GOTO 5: no line N5 in this program further on; "
                     "to go back it must be a file");
    }
}

TEST(ProgramFlow, M99MayNameALineOfItsCaller) {
    EXPECT_EQ(path("M98 P7\nX1\nN30 X2\nM30\nO7\nX5\nM99 P30\n"), "5 2");
    EXPECT_EQ(path("N1 #31=[#31+1]\nX#31\nIF [#31 EQ 3] GOTO 30\nM98 P7\nX7\nN30 X8\nM30\nO7\n"
                   "X5\nM99 P1\n"),
              "1 5 2 5 3 8");
    EXPECT_EQ(path("#1=[#1+1]\nX#1\nIF [#1 EQ 3] THEN M30\nM99 P5\nN5 GOTO 7\nX9\nN7 X8\n"), "1 8");
}

TEST(ProgramFlow, MacroCallsHaveArguments) {
    EXPECT_EQ(path("#1=50\nG65 P7 A1 B2 I4 M13 X24 Z-26 L2\nX#1\nM30\n"
                   "O7\nX[#1+#2+#4]\nX#13\nX[#24+#26]\n#1=9\nX#3\nM99\n"),
              "7 13 -2 0 7 13 -2 0 50");
}

TEST(ProgramFlow, NumberedProgramsAreCalledAndShareParameters) {
    EXPECT_EQ(path("o1 (main)\n#1=0\nM98 P100 L5\nX#1\nM30\no100\n#1=[#1+1]\nM98 P200 L5\nM99\n"
                   "o200\n#1=[#1+0.01]\nM99\nX1000\n"),
              "5.25");
    EXPECT_EQ(path("O0001 (PART)\nX1 M98 P2\nX3\nM98 P2 L0\nX4\nM30\nO0002\nX2\nM99\n"), "1 2 3 4");
    EXPECT_EQ(path(":7\nX1\nX2\nM99\nX3\n"), "1 2");  // the program's own end
}

TEST(ProgramFlow, MovesNameTheLineThatAskedForThem) {
    const auto moves = ref::read_gcode_text(
                           "G1 F600\no1 sub\nX[#<_line>]\no1 endsub\nX1\n"
                           "o2 repeat [2]\nG91 X1\no2 endrepeat\no1 call\n",
                           "part.ngc")
                           .moves;
    std::vector<int> lines;
    for (const ref::Move& move : moves) lines.push_back(move.line);
    EXPECT_EQ(lines, (std::vector<int>{5, 7, 7, 3}));
    EXPECT_EQ(moves.back().end.x(), 6);
}

TEST(ProgramFlow, ModesAreKeptAndBroughtBack) {
    EXPECT_EQ(path("M70\nG20 G91 X1\nM72\nX1\n"), "25.4 1");
    EXPECT_EQ(path("o1 sub\nM73\nG91 G20 X1\no1 endsub\nX1\no1 call\nX3\no1 call\n"),
              "1 26.4 3 28.4");
    EXPECT_EQ(path("o1 sub\nM70\nG91 X1\no1 endsub\nX1\no1 call\nX3\n"), "1 2 5");
    EXPECT_EQ(path("o1 sub\nM73\nG91 X1\nM71\no1 endsub\nX1\no1 call\nX3\n"), "1 2 5");
    EXPECT_EQ(refusal("M72\n"),
              "part.ngc:2: error: M72 without M70 or M73 in this sub, or in the program");
    EXPECT_EQ(refusal("M70\no1 sub\nM72\no1 endsub\no1 call\n"),
              "part.ngc:4: error: M72 without M70 or M73 in this sub, or in the program");
    EXPECT_EQ(refusal("M70 M71\n"), "part.ngc:2: error: M71: one code of M70 to M73 in a block");
}

/// A program in a folder with these files beside it.
struct Folder {
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name) << text;
    }
    fs::path path = fs::path(testing::TempDir()) / ("program_flow_test" + std::to_string(getpid()));
};

TEST(ProgramFlow, FilesBesideTheProgramAreSubs) {
    const Folder folder;
    folder.write("arc.ngc",
                 "%\n(an arc)\no<arc> sub\no1 if [#1 gt 0]\nX#1\no1 endif\no<arc> endsub\n%\n");
    folder.write("O0300.nc", "O300\n#31=[#31+1]\nX#31\nM99\n");
    const std::string program = folder.path / "part.nc";
    EXPECT_EQ(path("o<arc> call [7]\no<arc> call [0]\nM98 P300 L2\nX9\n", program), "7 1 2 9");
    const auto moves =
        ref::read_gcode_text("G1 F600\n\n\no<arc> call [7]\no<arc> call [8]\n", program).moves;
    EXPECT_EQ(moves[0].line, 4);  // line of the program, not of the file that it calls
    EXPECT_EQ(moves[1].line, 5);
    folder.write("bad.ngc", "o<bad> sub\nX5\nX#<nobody>\no<bad> endsub\n");
    try {
        path("o<bad> call\n", program);
        ADD_FAILURE() << "nothing is wrong";
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), (folder.path / "bad.ngc").string() +
                                    ":3: error: #<nobody> has no value yet: assign it before");
    }
    folder.write("empty.ngc", "X5\n");
    EXPECT_EQ(refusal("o<empty> call\n"),
              "part.ngc:2: error: there is no o<empty> sub: neither in this program nor in a file "
              "beside it; --machine FILE.ini names more folders (SUBROUTINE_PATH)");
    EXPECT_THROW(path("o<empty> call\n", program), InputError);
}

TEST(ProgramFlow, FilesInTheMachinesFoldersAreSubs) {
    const Folder folder;
    fs::create_directories(folder.path / "subs/more");
    folder.write("subs/two.ngc", "o<two> sub\nX2\no<two> endsub\n");
    folder.write("subs/more/three.ngc", "o<three> sub\nX3\no<three> endsub\n");
    folder.write("subs/more/two.ngc", "o<two> sub\nX22\no<two> endsub\n");
    folder.write("mill.ini",
                 "[DISPLAY]\nPROGRAM_PREFIX = subs\n"
                 "[RS274NGC]\nSUBROUTINE_PATH = no:subs/more\n");
    ref::GcodeOptions options;
    options.start = ref::read_program_start(folder.path / "mill.ini", "");
    const auto moves = ref::read_gcode_text("G1 F600\no<two> call\no<three> call\n",
                                            folder.path / "part.ngc", options)
                           .moves;
    ASSERT_EQ(moves.size(), 2U);
    EXPECT_EQ(moves[0].end.x(), 2);
    EXPECT_EQ(moves[1].end.x(), 3);
}

/// Number of lines that were read when the first move came.
int lines_read(const std::string& begin, std::optional<ref::Dialect> dialect) {
    std::string all = begin;
    for (int i = 0; i < 5000; ++i) all += "X" + std::to_string(i + 10) + "\n";
    std::istringstream text(all);
    ref::GcodeStream stream(text, "part.ngc", {ref::kFitTolerance, dialect, {}});
    ref::Move move;
    EXPECT_TRUE(stream.next(move));
    const auto read = all.begin() + text.tellg();
    return static_cast<int>(std::count(all.begin(), read, '\n'));
}

TEST(ProgramFlow, TextIsReadWhileItIsCarriedOut) {
    const ref::Dialect ngc = ref::Dialect::kLinuxcnc;
    EXPECT_EQ(lines_read("G1 F600\n", ngc), 3);
    EXPECT_EQ(lines_read("G1 F600\n", {}), 200);  // to recognise the dialect
    EXPECT_EQ(lines_read("G1 F600\no1 repeat [9]\nX1\nX2\no1 endrepeat\n", ngc), 5);
    EXPECT_EQ(lines_read("G1 F600\no1 sub\nX1\no1 endsub\nX5\no1 call\n", ngc), 6);
    EXPECT_EQ(lines_read("G1 F600\nM98 P5\nM30\nO5\nX1\nX2\nM99\n", ngc), 5007);
}

TEST(ProgramFlow, WhatCannotRunIsRefused) {
    const std::pair<const char*, const char*> cases[] = {
        {"o1 if [1]\nX1\n", "3: error: the program ends within o1 if: o1 endif is missing"},
        {"o1 if [0]\nX1\n", "2: error: o1 if lacks its o1 endif"},
        {"o1 if\n", "2: error: o1 if lacks its value, as in o1 if [#1 lt 5]"},
        {"o1 if [1] X1\n", "2: error: 'X' behind o1 if, where only values in brackets may stand"},
        {"o1 if [1] [2]\n", "2: error: o1 if takes 1 value at most"},
        {"o1 endif\n", "2: error: o1 endif without o1 if"},
        {"o1 if [1]\no2 endif\n", "3: error: o2 endif without o2 if"},
        {"o1 else\n", "2: error: o1 else without o1 if"},
        {"o1 if [0]\no1 while [1]\n", "3: error: o1 while inside of o1 if: give it another number"},
        {"o1 while [1]\nX1\n", "2: error: o1 while lacks its o1 endwhile"},
        {"o1 do\nX1\n", "2: error: o1 do lacks its o1 while"},
        {"o1 repeat [2]\no1 if [1]\n",
         "3: error: o1 if inside of o1 repeat: give it another number"},
        {"o1 endwhile\n", "2: error: o1 endwhile without its loop"},
        {"o1 repeat [2]\no2 if [1]\no1 endrepeat\n",
         "4: error: o1 endrepeat within o2 if, which began in the loop"},
        {"o1 break\n", "2: error: o1 break outside of a loop o1"},
        {"o1 while [1]\no2 continue\no1 endwhile\n", "3: error: o2 continue outside of a loop o2"},
        {"o1 sub\nX1\n", "2: error: o1 sub lacks its o1 endsub"},
        {"o1 sub\no2 sub\no2 endsub\no1 endsub\n",
         "3: error: o2 sub inside of o1 sub: a sub is defined on its own"},
        {"o1 sub\no1 endsub\no1 sub\no1 endsub\n", "4: error: o1 sub is there already, in line 2"},
        {"o1 repeat [1]\no2 sub\no2 endsub\no1 endrepeat\n",
         "3: error: o2 sub inside of o1 repeat: a sub is defined on its own"},
        {"o1 endsub\n", "2: error: o1 endsub outside of o1 sub"},
        {"o1 return\n", "2: error: o1 return outside of a sub"},
        {"o1 sub\no2 if [1]\no1 endsub\no1 call\n",
         "4: error: o1 endsub within o2 if, which began in the sub"},
        {"o1 call\n",
         "2: error: there is no o1 sub: neither in this program nor in a file beside it; "
         "--machine FILE.ini names more folders (SUBROUTINE_PATH)"},
        {"M98 P5\n",
         "2: error: there is no o5: neither in this program nor in a file beside it; "
         "--machine FILE.ini names more folders (SUBROUTINE_PATH)"},
        {"M98\n", "2: error: M98 without P, the number of a program"},
        {"M98 P1.5\n", "2: error: P must be a whole number from 0 to 1000000000, not 1.5"},
        {"M98 P5\nM30\nO5\nX1\n", "4: error: o5 lacks its M99"},
        {"M98 P5\nM30\nO5\nX1\nO6\nM99\n",
         "6: error: o6 begins before the M99 of o5, which was called"},
        {"o1 sub\nM99\no1 endsub\no1 call\n", "3: error: M99 in o1 sub: o1 endsub ends it"},
        {"M98 P5\nM30\nO5\no5 endsub\nM99\n",
         "5: error: o5 endsub where M98 has called o5: M99 ends it"},
        {"o1 sub\no1 call\no1 endsub\no1 call\n",
         "3: error: more than 9 calls in each other: o1 sub is called by itself?"},
        {"M99 P30\n", "2: error: GOTO 30: no line N30 in this program"},
        {"N7 IF [1] GOTO 10\n", "2: error: GOTO 10: no line N10 in this program"},
        {"M98 P5\nM30\nO5\nGOTO 10\nM99\nO6\nN10 X1\n",
         "5: error: GOTO 10: no line N10 in this program"},
        {"N10 GOTO 10 X1\n", "2: error: 'X' behind GOTO's number"},
        {"GOTO\n", "2: error: GOTO without a number"},
        {"IF [1] X1\n",
         "2: error: IF [..] wants GOTO or THEN; o100 if [..] begins lines of its own"},
        {"IF [1] THEN\nX\n", "3: error: X without a number"},
        {"WHILE [1] DO1\nX1\n", "2: error: o<do1> while lacks its o<do1> endwhile"},
        {"END1\n", "2: error: o<do1> endwhile without its loop"},
        {"G65 A1\n", "2: error: G65 without P, the number of a program"},
        {"G66 P1 A1\n", "2: error: unknown code G66"},
        {"o1 jump\n",
         "2: error: JUMP is no O-word: nothing, sub, call, if, while, do or repeat "
         "stand behind o1"},
        {"o[1.5] call\n", "2: error: O wants a whole number, not 1.5"},
        {"X1 o1 call\n", "2: error: an O-word begins its line"},
    };
    for (const auto& [text, reason] : cases) {
        EXPECT_EQ(refusal(text), std::string("part.ngc:") + reason) << text;
    }
}

TEST(ProgramFlow, LoopsWithoutEndAreRefused) {
    EXPECT_EQ(
        refusal("X1\no1 while [1]\n#1=[#1+1]\no1 endwhile\n"),
        "part.ngc:4: error: 1000000 blocks without a move: does o1 while of line 3 ever end?");
    EXPECT_EQ(refusal("X1\no1 while [1]\no1 continue\no1 endwhile\n").substr(0, 18),
              "part.ngc:4: error:");
}

}  // namespace curvecore::tb::program_flow_test
