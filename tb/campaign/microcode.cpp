// SPDX-License-Identifier: Apache-2.0
// Samples that microcode of curves draws on the engine's twin against the kernel's, in every
// configuration of tb/configurations.csv: fails where a word differs, an instruction has a hazard,
// or a bound of its clocks is not kept. What a configuration came to is a line of the file; those
// that have their words there are not run again.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tb/support/microcode/follow_comparison.hpp"
#include "tb/support/microcode/microcode_configurations.hpp"

namespace {

using namespace curvecore;
using nlohmann::json;

constexpr std::int64_t kStreamSamples = 20'000;  // of one stream of segments

/// Draws at least so many words of a configuration, each stream of its own seed.
json drawn(const tb::CurveCase& of, std::int64_t words) {
    const assembler::Assembly assembly = tb::follow_microcode(of.core, tb::kLargeStore);
    std::int64_t compared = 0;
    std::int64_t samples = 0;
    std::int64_t differ = 0;
    bool hazard = false;
    for (std::uint32_t seed = 1; compared < words; ++seed) {
        tb::MicrocodeMachine machine(assembly);
        tb::FollowComparison comparison(of.core, assembly, machine, seed);
        for (std::int64_t n = 0; n < kStreamSamples && compared + comparison.words() < words; ++n) {
            differ += comparison.sample();
            ++samples;
        }
        compared += comparison.words();
        hazard = hazard || machine.hazard();
    }
    return {{"configuration", tb::text(of)},
            {"words", compared},
            {"samples", samples},
            {"differ", differ},
            {"hazard", hazard}};
}

/// Lines of a file by configuration; the last one counts.
std::map<std::string, json> lines_of(const std::string& file) {
    std::map<std::string, json> lines;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        const json one = json::parse(line, nullptr, false);
        if (!one.is_discarded()) lines[one.at("configuration")] = one;
    }
    return lines;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("microcode of curves on the twin against the kernels");
    std::int64_t words = 2'000'000;
    std::size_t part = 1;
    std::size_t parts = 1;
    std::string file;
    app.add_option("--words", words, "words of all configurations together");
    app.add_option("--part", part, "every one of --parts configurations, from this one on");
    app.add_option("--parts", parts, "parts that run side by side");
    app.add_option("-o", file, "file of lines")->required();
    CLI11_PARSE(app, argc, argv);

    const std::map<std::string, json> before = lines_of(file);
    std::ofstream lines(file, std::ios::app);
    std::vector<tb::CurveCase> cases = tb::configurations();
    words = (words + static_cast<std::int64_t>(cases.size()) - 1) /
            static_cast<std::int64_t>(cases.size());
    std::int64_t all = 0;
    std::int64_t differ = 0;
    int count = 0;
    for (std::size_t n = part - 1; n < cases.size(); n += parts) {
        tb::CurveCase& of = cases[n];
        of.core.splines = of.spline ? 1 : 0;
        const auto known = before.find(tb::text(of));
        const bool done = known != before.end() && known->second.at("words") >= words;
        const json one = done ? known->second : drawn(of, words);
        if (!done) lines << one.dump() << std::endl;
        all += one.at("words").get<std::int64_t>();
        differ += one.at("differ").get<std::int64_t>() + (one.at("hazard") ? 1 : 0);
        ++count;
    }
    if (!lines) {
        fmt::print(stderr, "cannot write {}\n", file);
        return 1;
    }
    fmt::print("{} words in {} configurations, {} differ\n", all, count, differ);
    return differ == 0 ? 0 : 1;
}
