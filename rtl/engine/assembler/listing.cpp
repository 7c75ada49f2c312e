// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/assembler/listing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>

#include "rtl/engine/assembler/worst_case.hpp"

namespace curvecore::assembler {
namespace {

using engine::Instruction;
using engine::Op;

std::string condition(const Instruction& i) {
    const int code = i.f0 & 15;
    const bool is_not = (i.f0 & engine::kNot) != 0;
    if (code == engine::kNever) {
        return is_not ? "" : "never ";
    }
    const std::string name = code == engine::kNegative ? "negative"
                             : code == engine::kIsZero ? "zero"
                                                       : fmt::format("port {}", code);
    return fmt::format("if {}{} ", is_not ? "not " : "", name);
}

std::string branch(const Placed& placed) {
    const Instruction& i = placed.instruction;
    const std::string wait = i.flag ? "wait for the tick, " : "";
    const std::string what = (i.f0 & engine::kReturn) != 0 ? "return"
                             : (i.f0 & engine::kCall) != 0 ? "call " + placed.target
                             : (i.f0 & engine::kEnd) != 0  ? "end, then " + placed.target
                                                           : "go to " + placed.target;
    return wait + condition(i) + what;
}

std::string action(const Placed& placed) {
    const Instruction& i = placed.instruction;
    const std::string product = fmt::format("{} * {} >> 45", placed.f0, placed.f1);
    switch (i.op) {
        case Op::kAdd:
            return fmt::format("{} = {} + {}", placed.f2, placed.f0, placed.f1);
        case Op::kSub:
            return fmt::format("{} = {} - {}", placed.f2, placed.f0, placed.f1);
        case Op::kMull:
            return fmt::format("{} = {} * {}", placed.f2, placed.f0, placed.f1);
        case Op::kShr:
            return fmt::format(i.flag ? "{} = floor(wide {})" : "{} = wide {}", placed.f2, product);
        case Op::kMulr:
            return fmt::format(i.flag ? "{} = floor({})" : "{} = {}", placed.f2, product);
        case Op::kMadr:
            return fmt::format(
                i.flag ? "{0} = {1} + floor({0} * {2} >> 45)" : "{0} = {1} + ({0} * {2} >> 45)",
                placed.f2, placed.f0, placed.f1);
        case Op::kMac:
            return fmt::format("{} {} wide {} * {}", placed.f2, i.flag ? "=" : "+=", placed.f0,
                               placed.f1);
        case Op::kIn:
            return fmt::format("{} = port {}", placed.f2, placed.f0);
        case Op::kOut:
            return fmt::format("port {} = {}", placed.f1, placed.f0);
        default:
            return branch(placed);
    }
}

std::string source(const Source& of) {
    const std::string name = of.file.substr(of.file.find_last_of('/') + 1);
    return of.line > 0 ? fmt::format("{}:{}: {}", name, of.line, of.text) : of.text;
}

/// Lists words, and the values that stand in them.
std::string data(const Assembly& assembly) {
    std::map<int, std::set<std::string>> values;  // by field
    for (const Placed& placed : assembly.placed()) {
        const Instruction& i = placed.instruction;
        if (engine::is_branch(i.op)) {
            continue;
        }
        values[i.f0].insert(placed.f0);
        values[i.f1].insert(placed.f1);
        values[i.f2].insert(placed.f2);
    }
    std::string text = "\nwords of data: place, value at first, name: what stands there\n";
    for (const auto& [place, datum] : assembly.data()) {
        std::set<std::string> others = values[assembly.field(datum.name).code];
        others.erase(datum.name);
        text += fmt::format("{:03x} {:15} {}{}{}\n", place, datum.value, datum.name,
                            others.empty() ? "" : ": ", fmt::join(others, ", "));
    }
    return text;
}

}  // namespace

std::string listing(const Assembly& assembly, const std::vector<Program>& programs) {
    std::string text = fmt::format("{} instructions, {} words of data\n", assembly.placed().size(),
                                   assembly.data_words());
    for (const Program& program : programs) {
        text += fmt::format("{}: at most {} clocks\n", program.label,
                            worst_case(assembly, program.label, {program.end}));
    }
    std::multimap<std::size_t, std::string> labels;
    for (const auto& [label, place] : assembly.labels()) {
        labels.emplace(place, label);
    }
    for (std::size_t n = 0; n < assembly.placed().size(); ++n) {
        const Placed& placed = assembly.placed()[n];
        const auto [first, last] = labels.equal_range(n);
        for (auto label = first; label != last; ++label) {
            text += fmt::format("\n{}:\n", label->second);
        }
        const std::string line =
            fmt::format("{:03x} {:08x} {:3}  {:<44} | {}", n, encode(placed.instruction),
                        engine::clocks(placed.instruction), action(placed), source(placed.source));
        text += line + "\n";
    }
    return text + data(assembly);
}

std::string program_hex(const Assembly& assembly) {
    std::string text;
    for (const std::uint32_t word : assembly.program()) {
        text += fmt::format("{:08x}\n", word);
    }
    return text;
}

std::string data_hex(const Assembly& assembly) {
    std::string text;
    for (const std::int16_t limb : assembly.memory()) {
        text += fmt::format("{:04x}\n", static_cast<std::uint16_t>(limb));
    }
    return text;
}

}  // namespace curvecore::assembler
