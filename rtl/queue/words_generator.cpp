// SPDX-License-Identifier: Apache-2.0
// Writes words_pkg.sv, the fields of hls/words.hpp as the RTL reads them, into the folder given.
#include <fmt/os.h>

#include <string>
#include <tuple>

#include "hls/path_kernel.hpp"
#include "hls/path_outputs.hpp"
#include "hls/stop_schedule.hpp"
#include "hls/words.hpp"

using namespace curvecore;
using namespace curvecore::hls;

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: words_generator FOLDER\n");
        return 2;
    }
    auto file = fmt::output_file(std::string(argv[1]) + "/words_pkg.sv");
    file.print(
        "// SPDX-License-Identifier: Apache-2.0\n"
        "// Made by rtl/queue/words_generator.cpp from hls/words.hpp, which explains the fields.\n"
        "`default_nettype none\n"
        "package words_pkg;\n\n");
    file.print("  localparam int Version = {};\n\n", kWordsVersion);
    const std::pair<const char*, Tag> tags[] = {
        {"Length", Tag::kLength},   {"Theta", Tag::kTheta},     {"Start", Tag::kStart},
        {"End", Tag::kEnd},         {"Tangent", Tag::kTangent}, {"Normal", Tag::kNormal},
        {"Advance", Tag::kAdvance}, {"Piece", Tag::kPiece},     {"Ds", Tag::kDs},
        {"C1", Tag::kC1},           {"C2", Tag::kC2},           {"C3", Tag::kC3},
        {"Stop", Tag::kStop},       {"Step", Tag::kStep},       {"Output", Tag::kOutput}};
    for (const auto& [name, tag] : tags) {
        file.print("  localparam logic [3:0] Tag{} = 4'd{};\n", name, static_cast<int>(tag));
    }
    const std::pair<const char*, Field> fields[] = {{"Tag", kTagField},
                                                    {"PathLength", kLengthField},
                                                    {"Point", kPointField},
                                                    {"Coef", kCoefField},
                                                    {"Kind", kKindField},
                                                    {"StepExponent", kStepExponentField},
                                                    {"Last", kLastField},
                                                    {"Sequence", kSequenceField},
                                                    {"Check", kCheckField},
                                                    {"Lambda", kLambdaField},
                                                    {"OtherTurn", kOtherTurnField},
                                                    {"TicksByte", kTicksByteField},
                                                    {"PieceTicks", kPieceTicksField},
                                                    {"TimeExponent", kTimeExponentField},
                                                    {"Exponent", kExponentField},
                                                    {"Final", kFinalField},
                                                    {"StopWait", kStopWaitField},
                                                    {"StopAgain", kStopAgainField},
                                                    {"StepTicks", kStepTicksField},
                                                    {"StepChange", kStepChangeField},
                                                    {"StepLast", kStepLastField},
                                                    {"OutputDistance", kOutputDistanceField},
                                                    {"OutputValue", kOutputValueField},
                                                    {"OutputKind", kOutputKindField},
                                                    {"OutputNumber", kOutputNumberField}};
    file.print("\n  // Lowest bits, and how many\n");
    for (const auto& [name, field] : fields) {
        file.print("  localparam int {}Low = {};\n", name, field.low);
        file.print("  localparam int {}Bits = {};\n", name, field.bits);
    }
    file.print("\n  // Largest values\n");
    const std::tuple<const char*, Field, int> largest[] = {
        {"StepExponent", kStepExponentField, kMaxStepExponent},
        {"Lambda", kLambdaField, kMaxStepExponent},
        {"TimeExponent", kTimeExponentField, kMaxTimeExponent},
        {"Exponent", kExponentField, kMaxProfileExponent}};
    for (const auto& [name, field, value] : largest) {
        file.print("  localparam logic [{}:0] Most{} = {}'d{};\n", field.bits - 1, name, field.bits,
                   value);
    }
    file.print(
        "\n  // Words of a frame; of a segment without auxiliary axes, and what each adds\n");
    file.print("  localparam int SegmentWords = {};\n", ref::segment_bus_words(0));
    file.print("  localparam int AxisWords = {};\n", ref::kAxisBusWords);
    file.print("  localparam int PieceWords = {};\n", kProfileBusWords);
    file.print("\n  // Sizes of stop branches: hls/stop_schedule.hpp\n");
    file.print("  localparam int StopLead = {};\n", kStopLead);
    file.print("  localparam int StopSteps = {};\n", kStopSteps);
    file.print("  localparam int BranchRate = {};  // 16 fraction bits\n", ref::kBranchRate);
    file.print("\n  // Kinds of changes of outputs: hls/path_outputs.hpp\n");
    const std::pair<const char*, OutputKind> kinds[] = {{"Bits", OutputKind::kBits},
                                                        {"Level", OutputKind::kLevel},
                                                        {"Follow", OutputKind::kFollow}};
    for (const auto& [name, kind] : kinds) {
        file.print("  localparam logic [1:0] Output{} = 2'd{};\n", name, static_cast<int>(kind));
    }
    file.print(
        "\n  // Ticks without a program behind which nothing is under way: "
        "rtl/time/idle_gate.sv\n");
    file.print("  localparam int IdleTicks = {};\n", kIdleTicks);
    file.print("\nendpackage\n`default_nettype wire\n");
}
