// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/blocks/program_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace curvecore::ref {
namespace {

/// Returns true for the tool in the spindle and its offset: codes set them, a program reads them.
bool of_the_tool(int number) { return number >= 5400 && number <= 5413; }

bool is_global(const std::string& name) { return !name.empty() && name[0] == '_'; }

}  // namespace

ProgramParameters::ProgramParameters() : numbered_(kLast + 1), calls_(1) {}

const ProgramParameters::Names& ProgramParameters::names_of(const std::string& name) const {
    return is_global(name) ? global_ : calls_.back().names;
}

bool ProgramParameters::exists(const std::string& name) const {
    return computed_names_.count(name) > 0 || names_of(name).count(name) > 0;
}

double ProgramParameters::number(int number) const {
    if (!exists(number)) {
        throw ParameterError(
            fmt::format("there is no #{}: parameters are #1 to #{}", number, kLast));
    }
    const auto computed = computed_numbers_.find(number);
    return computed == computed_numbers_.end() ? numbered_[number] : computed->second();
}

double ProgramParameters::named(const std::string& name) const {
    const auto computed = computed_names_.find(name);
    if (computed != computed_names_.end()) return computed->second();
    const Names& names = names_of(name);
    const auto found = names.find(name);
    if (found != names.end()) return found->second;
    if (name.rfind("_ini[", 0) == 0) {
        throw ParameterError(
            fmt::format("#<{}> is no number of the machine's .ini: --machine names it", name));
    }
    if (name.rfind("_hal[", 0) == 0) {
        throw ParameterError(
            fmt::format("#<{0}> is a pin of LinuxCNC's machine while it runs: "
                        "give its value in a line before, as #<{0}>=1",
                        name));
    }
    throw ParameterError(fmt::format("#<{}> has no value yet: assign it before", name));
}

void ProgramParameters::assign(int number, double value) {
    if (!exists(number)) {
        throw ParameterError(
            fmt::format("there is no #{}: parameters are #1 to #{}", number, kLast));
    }
    if (computed_numbers_.count(number) > 0 || of_the_tool(number)) {
        throw ParameterError(fmt::format("#{} can only be read", number));
    }
    numbered_[number] = value;
}

void ProgramParameters::declare(const std::string& name) {
    if (computed_names_.count(name) > 0) {
        throw ParameterError(fmt::format("#<{}> can only be read", name));
    }
    (is_global(name) ? global_ : calls_.back().names).try_emplace(name, 0);
}

void ProgramParameters::assign(const std::string& name, double value) {
    declare(name);
    (is_global(name) ? global_ : calls_.back().names)[name] = value;
}

void ProgramParameters::compute(int number, std::function<double()> value) {
    computed_numbers_[number] = std::move(value);
}

void ProgramParameters::compute(const std::string& name, std::function<double()> value) {
    computed_names_[name] = std::move(value);
}

void ProgramParameters::push(Call call) {
    if (calls() == kDeepestCall) {
        throw ParameterError(fmt::format("more than {} calls in each other", kDeepestCall));
    }
    calls_.push_back(std::move(call));
}

void ProgramParameters::enter(const std::vector<double>& arguments) {
    const auto first = numbered_.begin() + 1;
    push({std::vector<double>(first, first + kArguments), {}});
    std::fill_n(numbered_.begin() + 1, kArguments, 0.0);
    std::copy_n(arguments.begin(), std::min<std::size_t>(arguments.size(), kArguments),
                numbered_.begin() + 1);
    calls_.back().names["n_args"] = static_cast<double>(arguments.size());
}

void ProgramParameters::enter_sharing() { push({}); }

void ProgramParameters::leave() {
    const std::vector<double>& arguments = calls_.back().arguments;
    std::copy(arguments.begin(), arguments.end(), numbered_.begin() + 1);
    calls_.pop_back();
}

}  // namespace curvecore::ref
