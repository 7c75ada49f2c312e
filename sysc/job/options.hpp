// SPDX-License-Identifier: Apache-2.0
// Options of the command line.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ref/outputs/output_course.hpp"
#include "ref/program/program_stream.hpp"
#include "ref/segment/plan_options.hpp"
#include "sysc/core/core_parameters.hpp"
#include "sysc/core/system_settings.hpp"

namespace curvecore::sysc {

/// Greatest override, percent.
constexpr int kMostOverride = 200;

/// Kind of the board: the kernel, the Verilated core, or a system in SystemC around one of them.
enum class BoardKind { kKernel, kRtl, kSystemc, kSystemcRtl };
constexpr std::array<std::string_view, 4> kBoardNames{"kernel", "rtl", "systemc", "systemc-rtl"};

struct Options {
    std::string file;
    std::string folder;
    std::string machine;  // empty: the built-in one
    ref::PointsOptions points;
    ref::GcodeOptions gcode;
    ref::OpenProgram open_program;  // interpreter other than this program's; empty: none
    std::shared_ptr<const ref::HeldProgram> program;  // generated program that replaces the file
    ref::Effort effort = ref::Effort::kOptimum;
    ref::Holds holds = ref::Holds::kBranches;
    bool exact_path = false;              // true: G64's tolerance is not used
    double from_mm = 0;                   // of the drawn path: what is before it is left out
    std::optional<double> arc_tolerance;  // mm, for --fit arcs
    double unit_mm = 1e-6;
    double sample_period_s = 100e-6;
    int samples_per_tick = 1;
    int segment_queue_words = ref::kSegmentQueueWords;  // of the core, not more than boards have
    int profile_queue_words = ref::kProfileQueueWords;
    int outputs = 0;         // changes of outputs that wait at the board; 0: it has none
    ref::OutputRules rules;  // of outputs
    double clock_hz = 100e6;
    bool clock_set = false;    // true: set by --clock or --core; false: the device's
    std::string device;        // empty: any
    double error_limit = 0.1;  // units: limit of every segment's derived bound
    CoreParameters core;
    bool splines_set = false;   // true: by --set or --core; false: as the program has splines
    bool aux_axes_set = false;  // true: by --set or --core; false: as the program needs
    bool quiet = false;
    bool json = false;       // the result on stdout is JSON
    bool for_steps = false;  // for a board that counts steps: words keep every turn of an axis
    bool live = false;       // planned shortly before it is drawn: feeds may be raised
    int threads = 1;         // that plan

    // Options of `run` alone
    BoardKind board = BoardKind::kRtl;
    std::string rtl;               // folder of the core's sources; empty: those of the program
    std::vector<std::string> dut;  // files of a design with a core's ports, in place of the core
    SystemSettings system;
    std::optional<std::uint64_t> stall_seed;
    double override_percent = 100;
    bool trace = false;
    std::uint64_t trace_clocks = 20000;
    std::uint64_t most_rows = 4000000;  // greatest number of rows of samples.csv
    bool segments_file = true;          // `run` and `plan` write segments.json
    bool junit = false;                 // .. and junit.xml

    bool in_system() const {
        return board == BoardKind::kSystemc || board == BoardKind::kSystemcRtl;
    }
    /// Returns true if a Verilated core draws.
    bool needs_rtl() const { return board == BoardKind::kRtl || board == BoardKind::kSystemcRtl; }
    int samples_per_tick_log2() const;
    /// Returns the override as the hardware's word, 2^16 = 100 %; the plan contains the part above
    /// 100 %.
    std::int32_t override_word() const;
    double feed_factor() const;
    ref::PlanOptions plan_options() const;
};

}  // namespace curvecore::sysc
