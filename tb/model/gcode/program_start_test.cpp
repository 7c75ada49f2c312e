// SPDX-License-Identifier: Apache-2.0
// Tools, stored positions and offsets that are set before a program begins.
#include "ref/gcode/state/program_start.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "ref/program/gcode_reader.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::tb::program_start_test {

using ref::ProgramStart;
using ref::Vec3;
namespace fs = std::filesystem;

class Start : public testing::Test {
  protected:
    Start() : folder_(fs::path(testing::TempDir()) / ("program_start" + std::to_string(getpid()))) {
        fs::create_directory(folder_);
    }
    ~Start() override { fs::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& text) const {
        const fs::path file = folder_ / name;
        std::ofstream(file) << text;
        return file;
    }

    /// Ends of a program's moves.
    static std::vector<Vec3> ends(const std::string& text, const ProgramStart& start) {
        const ref::GcodeOptions options{1e-4, ref::Dialect::kLinuxcnc, start};
        std::vector<Vec3> points;
        for (const ref::Move& move :
             ref::read_gcode_text("F600 G1 G90 G21\n" + text, "part.ngc", options).moves) {
            points.push_back(move.end);
        }
        return points;
    }

    static std::string refusal(const std::string& text, const ProgramStart& start) {
        try {
            ends(text, start);
        } catch (const ref::InputError& error) {
            return error.what();
        }
        return "nothing is wrong";
    }

    fs::path folder_;
};

using Points = std::vector<Vec3>;

TEST_F(Start, ToolsHaveTheLengthsOfTheirTable) {
    const std::string table = write("tool.tbl",
                                    "; nothing here\nT1 P1 Z50.5 D6 ;end mill\n\n"
                                    "  t2 p7 x+1 z-3\nT30 Z.5 I-95.000 J155 Q1\n");
    const ProgramStart start = ref::read_program_start("", table);
    EXPECT_EQ(ends("G43 H1 Z1", start), (Points{{0, 0, 51.5}}));
    EXPECT_EQ(ends("T2 M6 G43\nX1 Z1", start), (Points{{2, 0, -2}}));
    EXPECT_EQ(ends("T2 M6 G43 H1\nZ1", start), (Points{{0, 0, 51.5}}));
    EXPECT_EQ(ends("T2 M6\nT1 G43\nX1 Z1", start), (Points{{2, 0, -2}})) << "T alone selects";
    EXPECT_EQ(ends("M61 Q2 G43 H0\nX1 Z1", start), (Points{{2, 0, -2}}));
    EXPECT_EQ(ends("G43 H1\nG43.2 H30\nZ1\nG49 Z0", start), (Points{{0, 0, 52}, {0, 0, 0}}));
    EXPECT_EQ(ends("T2 M6\nT1\nX#5400 Y#<_selected_tool>", start), (Points{{2, 1, 0}}));
    EXPECT_EQ(refusal("G43 H4 Z1", start),
              "part.ngc:2: error: the tool table " + table + " has no T4");
}

TEST_F(Start, CompensationIsOfTheTablesDiameter) {
    const ProgramStart start =
        ref::read_program_start("", write("tool.tbl", "T1 Z10\nT2 D-6\nT3 D0\n"));
    EXPECT_EQ(ends("G41 D1 X1\nG40\nT3 M6 G42 X2", start), (Points{{1, 0, 0}, {2, 0, 0}}));
    const std::string refused = "part.ngc:2: error: G41: cutter compensation of a tool of 6 mm";
    EXPECT_EQ(refusal("G41 D2 X1", start).substr(0, refused.size()), refused);
    EXPECT_EQ(refusal("T2 M6 G41 X1", start).substr(0, refused.size()), refused);
    EXPECT_EQ(refusal("G41 D4 X1", start),
              "part.ngc:2: error: the tool table " + start.tools.file() + " has no T4");
}

TEST_F(Start, ProgramsChangeTheTableForThemselves) {
    const ProgramStart start = ref::read_program_start("", write("tool.tbl", "T1 Z10\n"));
    EXPECT_EQ(ends("G10 L1 P1 Z20\nG43 H1 Z1", start), (Points{{0, 0, 21}}));
    EXPECT_EQ(ends("G10 L1 P5 Z20 R3\nG43 H5 Z1", {}), (Points{{0, 0, 21}}));
    EXPECT_EQ(ends("Z30\nG10 L10 P1 Z5\nG43 H1\nZ6", start), (Points{{0, 0, 30}, {0, 0, 31}}));
    EXPECT_EQ(ends("G10 L2 P1 Z100\nG10 L2 P9 Z7\nZ30\nG10 L11 P1 Z5\nG43 H1 G59.3\nZ6", start),
              (Points{{0, 0, 130}, {0, 0, 131}}));
}

TEST_F(Start, TablesThatAreWrongAreRefused) {
    const auto refused = [this](const std::string& text) {
        const std::string file = write("tool.tbl", text);
        try {
            ref::read_program_start("", file);
        } catch (const ref::InputError& error) {
            return std::string(error.what()).substr(file.size());
        }
        return std::string("nothing is wrong");
    };
    EXPECT_EQ(refused("T1 Zx"), ":1: error: Zx is no word of a tool table");
    EXPECT_EQ(refused("T1\nZ5"), ":2: error: a tool without its number (T)");
    EXPECT_EQ(refused("T1\nT1 Z5"), ":2: error: T1 for the second time");
    EXPECT_EQ(refused("T1.5"), ":1: error: T must be a whole number from 0 to 99999, not 1.5");
    EXPECT_EQ(refused("T1 H5"), ":1: error: 'H' is no word of a tool table (TPXYZABCUVWDIJQ)");
    EXPECT_EQ(refused("T1 Z1e9"), ":1: error: Z is out of range");
    EXPECT_EQ(refused("T1 Znan"), ":1: error: Z is out of range");
}

TEST_F(Start, AnIniNamesToolsAndParametersInItsUnit) {
    write("tool.tbl", "T1 Z2\n");
    write("mill.var", "5161\t1.5\n5183 2\n5220 2\n5241 3\n5242 -1\n5250 90\n\n");
    const std::string ini = write("mill.ini",
                                  "[TRAJ]\nLINEAR_UNITS = inch\n[EMCIO]\nTOOL_TABLE = tool.tbl\n"
                                  "[RS274NGC]\nPARAMETER_FILE = mill.var\n");
    const ProgramStart start = ref::read_program_start(ini, "");
    const auto near = [](const Points& found, const Points& expected) {
        if (found.size() != expected.size()) return false;
        for (std::size_t i = 0; i < found.size(); ++i) {
            if ((found[i] - expected[i]).norm() > 1e-9) return false;
        }
        return true;
    };
    EXPECT_TRUE(near(ends("G43 H1 G54 Z1", start), {{0, 0, 51.8}}));
    EXPECT_TRUE(near(ends("G54 X5 Z1\nG28 X5\nG30 Z1", start),
                     {{5, 0, 1}, {1.5 * 25.4, 0, 1}, {1.5 * 25.4, 0, 50.8}}));
    EXPECT_TRUE(near(ends("X0 Y0\nX1", start), {{76.2, -25.4, 0}, {76.2, -24.4, 0}}))
        << "G55, turned, is in force";
    EXPECT_TRUE(
        near(ends("G54 G20\nX[#5161] Y[#5241] Z[#5183 * 2]", start), {{38.1, 76.2, 101.6}}));
    EXPECT_TRUE(near(ends("G54\n#5161 = 4\nG28 X0", start), {{4 * 25.4, 0, 0}}));
    EXPECT_TRUE(near(ends("#5221 = 1\nG54 X0", start), {{25.4, 0, 0}}));
    EXPECT_TRUE(near(ends("G54 X50.8\nG28.1 X[#5161] Y0\nX#5161", start),
                     {{50.8, 0, 0}, {1.5, 0, 0}, {2, 0, 0}}));
}

TEST_F(Start, AnIniHasUnitsABlockAndNumbersForTheProgram) {
    const auto start_of = [this](const std::string& text) {
        return ref::read_program_start(write("mill.ini", text), "");
    };
    const auto last_x = [](const std::string& text, const ProgramStart& start) {
        const ref::GcodeOptions options{1e-4, ref::Dialect::kLinuxcnc, start};
        return ref::read_gcode_text(text, "part.ngc", options).moves.back().end.x();
    };
    const ProgramStart inch = start_of("[TRAJ]\nLINEAR_UNITS = inch\n");
    EXPECT_EQ(last_x("G0 X1", inch), 25.4);
    EXPECT_EQ(last_x("G21 G0 X1 Y1\nX[#<_metric_machine>+2]", inch), 2);
    EXPECT_EQ(last_x("G0 X1", start_of("[TRAJ]\nLINEAR_UNITS = mm\n")), 1);
    EXPECT_EQ(last_x("X1", start_of("[RS274NGC]\nRS274NGC_STARTUP_CODE = G20 G1 F60\n")), 25.4);
    const ProgramStart numbers = start_of("[Setup]\nxPos = +7.25 # mm\nNAME = 5x\n");
    EXPECT_EQ(last_x("G0 X#<_ini[setup]xpos>", numbers), 7.25);
    EXPECT_EQ(last_x("G0 X[1+EXISTS[#<_ini[setup]xpos>]+EXISTS[#<_ini[setup]ypos>]]", numbers), 2);
    EXPECT_EQ(refusal("X#<_ini[setup]name>", numbers),
              "part.ngc:2: error: #<_ini[setup]name> is no number of the machine's .ini: "
              "--machine names it");
    const ProgramStart wrong = start_of("[RS274NGC]\nRS274NGC_STARTUP_CODE = G20 G21\n");
    EXPECT_EQ(refusal("X1", wrong), (folder_ / "mill.ini").string() +
                                        ":2: error: G20 and G21 exclude each other in one block");
}

TEST_F(Start, FilesOfAnIniNeedNotBeThereButMustBeRight) {
    const std::string ini =
        write("mill.ini", "[EMCIO]\nTOOL_TABLE = no.tbl\n[RS274NGC]\nPARAMETER_FILE = a.var\n");
    EXPECT_EQ(ref::read_program_start(ini, "").tools.file(), "");
    const std::string file = write("a.var", "5161 1\nx\n");
    try {
        ref::read_program_start(ini, "");
        FAIL();
    } catch (const ref::InputError& error) {
        EXPECT_EQ(error.what(), file + ":2: error: a parameter is its number and its value");
    }
    EXPECT_THROW(ref::read_program_start("", (folder_ / "no.tbl").string()), ref::InputError);
}

TEST_F(Start, ArcsMayBeAsFarOffAsAsked) {
    ProgramStart start;
    EXPECT_NE(refusal("G3 X1.2 Y1 J1", start), "nothing is wrong");
    start.arc_tolerance = 0.25;
    EXPECT_EQ(refusal("G3 X1.2 Y1 J1", start), "nothing is wrong");
    EXPECT_NE(refusal("G3 X1.3 Y1 J1", start), "nothing is wrong");
    start.arc_tolerance = 0.001;
    EXPECT_NE(refusal("G3 X1.002 Y1 J1", start), "nothing is wrong");
}

}  // namespace curvecore::tb::program_start_test
