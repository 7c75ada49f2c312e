// SPDX-License-Identifier: Apache-2.0
// The programs of Build 2 for a module's parameters, as files in a folder: program.hex and data.hex
// for $readmemh, motion.lst to read.
//
//   microcode_generator TREE FOLDER TOP [Name=Value ...]
//
// TOP is rtl/motion_interpolator.sv or a module around it. A parameter that is not given has the
// default of that module. The table of Table is the one of ref/curves that has its number.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <regex>
#include <stdexcept>
#include <string>

#include "hls/clocks.hpp"
#include "hls/place_scaler.hpp"
#include "hls/registers/board_facts.h"
#include "ref/curves/table_reader.hpp"
#include "ref/format/parameter_text.hpp"
#include "ref/text/text_file.hpp"
#include "rtl/engine/assembler/listing.hpp"
#include "rtl/engine/compiler/microcode_files.hpp"
#include "rtl/engine/compiler/motion_program.hpp"

namespace {

using namespace curvecore;
namespace fs = std::filesystem;
using Values = std::map<std::string, int>;

int number_of(const std::string& text, const std::string& option) {
    if (text.empty() || text.size() > 9 ||
        text.find_first_not_of("0123456789") != std::string::npos) {
        throw std::invalid_argument(option + " is no Name=Value with a whole number");
    }
    return std::stoi(text);
}

/// Parameters of a module with their defaults.
Values defaults_of(const fs::path& tree, const std::string& top) {
    static const std::regex kParameter(R"(parameter int (\w+)\s*=\s*(\d+))");
    Values values;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tree / "rtl")) {
        if (entry.path().filename() != top + ".sv") continue;
        const std::string text = ref::read_text_file(entry.path().string());
        for (std::sregex_iterator at(text.begin(), text.end(), kParameter), end; at != end; ++at) {
            values[(*at)[1]] = std::stoi((*at)[2]);
        }
    }
    if (values.count("Build") == 0) throw std::invalid_argument(top + " has no parameter Build");
    return values;
}

void set(const std::string& option, const std::string& top, Values& values) {
    const std::size_t at = option.find('=');
    const std::string name = option.substr(0, at);
    if (values.count(name) == 0) throw std::invalid_argument(top + " has no parameter " + name);
    values[name] = number_of(at == std::string::npos ? "" : option.substr(at + 1), option);
}

/// The table of that number; null for 0.
std::shared_ptr<const ref::CurveTable> table_of(const fs::path& tree, std::uint32_t number) {
    if (number == 0) return nullptr;
    for (const fs::directory_entry& entry : fs::directory_iterator(tree / "ref/curves")) {
        if (entry.path().extension() != ".net") continue;
        auto table = std::make_shared<ref::CurveTable>(ref::read_curve_table(entry.path()));
        if (curvecore_table_number(table->text.c_str()) == number) return table;
    }
    throw std::invalid_argument(fmt::format(
        "Table={}: no table of ref/curves has that number; `curvecore curve check` says "
        "those that they have",
        number));
}

ref::CoreParameters core_of(const Values& values, const fs::path& tree) {
    ref::CoreParameters core;
    const auto table = values.find("Table");
    if (table != values.end()) {
        ref::add_table(table_of(tree, static_cast<std::uint32_t>(table->second)), core);
    }
    core.build = ref::Build::kEngine;
    for (const auto& [name, value] : values) {
        const ref::Parameter* const row = ref::find_parameter(name);
        if (row != nullptr) core.*row->value = value;
    }
    const std::string reason = ref::why_not_built(core);
    if (!reason.empty()) throw std::invalid_argument(reason);
    return core;
}

/// Least clocks of a period in which a sample with a tick is made, and in a window of those made
/// ahead a segment: least_period_clocks() of sysc/core.
int least_period(const hls::TimedCore& core, bool spline) {
    const hls::Clocks clocks = hls::engine_clocks(core, spline);
    const int change = std::max(clocks.step, clocks.segment) - clocks.sample;
    const int window = 1 + hls::samples_ahead(core);
    return clocks.sample + hls::tick_clocks(core) + (change + window - 1) / window;
}

/// Checks that a board's samples can be made in its period.
void check_period(const ref::CoreParameters& core, const Values& values) {
    if (values.count("PeriodLog2") == 0) return;
    hls::TimedCore timed;
    timed.build = core.build;
    timed.order = core.order;
    timed.aux_axes = core.aux_axes;
    timed.series = core.mode == 0;
    int least = least_period(timed, false);
    if (core.splines != 0) least = std::max(least, least_period(timed, true));
    const int period = 1 << values.at("PeriodLog2");
    if (period >= least) return;
    throw std::invalid_argument(
        fmt::format("a sample period has {} clocks, and the engine needs {}: PeriodLog2 must be {}",
                    period, least, static_cast<int>(std::ceil(std::log2(least)))));
}

/// Bits of the rates that a module's samples are, or 0: they are positions.
int rate_bits(const Values& values) {
    const auto period = values.find("PeriodLog2");
    return period == values.end() ? 0 : hls::kStepFraction + period->second;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fprintf(stderr, "usage: microcode_generator TREE FOLDER TOP [Name=Value ...]\n");
        return 2;
    }
    try {
        Values values = defaults_of(argv[1], argv[3]);
        for (int n = 4; n < argc; ++n) set(argv[n], argv[3], values);
        const ref::CoreParameters core = core_of(values, argv[1]);
        check_period(core, values);
        const assembler::Assembly made = assembler::motion_program(
            core, {values.at("SegmentQueueWords"), values.at("ProfileQueueWords")}, argv[1],
            rate_bits(values));
        assembler::MicrocodeFiles files = assembler::microcode_files(made);
        files["motion.lst"] = listing(made, {});
        assembler::write_files(files, argv[2]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "microcode_generator: %s\n", error.what());
        return 1;
    }
    return 0;
}
