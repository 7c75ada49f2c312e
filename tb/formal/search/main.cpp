// SPDX-License-Identifier: Apache-2.0
// The program state_search prove|cover|control CIRCUIT [--forget RULE]...: visits the circuit's
// reachable states, all of them for a proof.
//   prove     no bad literal may be 1 in any state; otherwise prints a path to one
//   cover     every bad literal is reached
//   control   some bad literal is reached: the proof of a defect fails
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "tb/formal/search/search.hpp"

namespace {

using namespace curvecore::formal;

void print_way(const Search& search, const Registers& registers, std::uint32_t state) {
    std::vector<std::uint32_t> way{state};
    while (way.back() != 0) way.push_back(search.states().parent(way.back()));
    const std::uint64_t* before = nullptr;
    for (std::size_t clock = 0; clock < way.size(); ++clock) {
        const std::uint64_t* now = search.states()[way[way.size() - 1 - clock]];
        fmt::print("{:4}:{}\n", clock, registers.changes(before, now));
        before = now;
    }
}

bool answer(const std::string& mode, const std::string& path,
            const std::vector<std::string>& texts) {
    const Circuit circuit = cone_of_influence(read_circuit(path));
    const Registers registers(circuit);
    std::vector<Forget> rules;
    for (const std::string& text : texts) rules.push_back(registers.rule(text));
    const std::size_t all = circuit.bad.size();
    Search search(circuit, rules, mode == "prove" ? Question::kMay : Question::kMust);
    search.run(mode == "cover" ? all : 1);

    fmt::print("{} states of {} bits within {} clocks, {} inputs; {} of {} reached\n",
               search.states().size(), circuit.latches.size(), search.clocks(), circuit.inputs,
               search.reached(), all);
    for (std::size_t n = 0; mode == "prove" && n < all; ++n) {
        if (!search.where()[n]) continue;
        fmt::print("assertion {} fails:\n", n);
        print_way(search, registers, *search.where()[n]);
    }
    if (mode == "prove") return search.reached() == 0;
    return search.reached() >= (mode == "cover" ? all : 1);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Every reachable state of a circuit"};
    std::string mode;
    std::string path;
    std::vector<std::string> rules;
    app.add_option("mode", mode)->required()->check(CLI::IsMember({"prove", "cover", "control"}));
    app.add_option("circuit", path)->required();
    app.add_option("--forget", rules, "REGISTER ... unless GUARD");
    CLI11_PARSE(app, argc, argv);
    try {
        return answer(mode, path, rules) ? 0 : 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "state_search: {}\n", error.what());
        return 2;
    }
}
