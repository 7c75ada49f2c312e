// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/assembler/worst_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

namespace curvecore::assembler {
namespace {

using engine::Instruction;

class Ways {
  public:
    Ways(const Assembly& assembly, const std::set<std::string>& ends) : assembly_(assembly) {
        for (const std::string& end : ends) {
            ends_.insert(place(end));
        }
    }

    int longest(const std::string& label) {
        Search search{std::nullopt, {}, {}};
        const std::optional<int> clocks = from(place(label), search);
        if (!clocks) {
            throw AssemblyError(fmt::format("{}: error: no way leads to an end", label));
        }
        return *clocks;
    }

  private:
    /// Ways to an end, or to the end of a loop from its beginning.
    struct Search {
        std::optional<Loop> loop;
        std::map<std::size_t, std::optional<int>> known;
        std::set<std::size_t> open;
    };

    std::size_t place(const std::string& label) const {
        const auto found = assembly_.labels().find(label);
        if (found == assembly_.labels().end()) {
            throw AssemblyError(fmt::format("{}: error: no such label", label));
        }
        return found->second;
    }

    /// Most clocks from an instruction on; none if its ways lead elsewhere.
    std::optional<int> from(std::size_t at, Search& search) {
        if (search.loop ? at < search.loop->first || at > search.loop->back
                        : ends_.count(at) != 0) {
            return search.loop ? std::nullopt : std::optional<int>(0);
        }
        const auto known = search.known.find(at);
        if (known != search.known.end()) {
            return known->second;
        }
        if (at >= assembly_.placed().size()) {
            throw AssemblyError("error: a way leads behind the last instruction");
        }
        const Placed& placed = assembly_.placed()[at];
        if (!search.open.insert(at).second) {
            throw AssemblyError(fmt::format("{}:{}: error: a loop without a bound",
                                            placed.source.file, placed.source.line));
        }
        std::optional<int> most = behind(at, placed.instruction, search);
        if (most) {
            *most += engine::clocks(placed.instruction) + loops(at, search);
        }
        search.open.erase(at);
        return search.known[at] = most;
    }

    std::optional<int> behind(std::size_t at, const Instruction& i, Search& search) {
        const bool last = search.loop && at == search.loop->back;
        if (!engine::is_branch(i.op)) {
            return from(at + 1, search);
        }
        if (last) {
            return 0;
        }
        const int code = i.f0 & 15;
        const bool taken = code != engine::kNever || (i.f0 & engine::kNot) != 0;
        const bool passed = code != engine::kNever || (i.f0 & engine::kNot) == 0;
        std::optional<int> most;
        if (passed) {
            most = from(at + 1, search);
        }
        if (!taken) {
            return most;
        }
        std::optional<int> other;
        const std::size_t target =
            static_cast<std::size_t>(i.f1) << 8 | static_cast<unsigned>(i.f2);
        if ((i.f0 & engine::kCall) != 0 && !search.loop && ends_.count(target) != 0) {
            other = 0;
        } else if ((i.f0 & engine::kCall) != 0) {
            other = from(at + 1, search);
            if (other) {
                *other += subroutine(target);
            }
        } else if ((i.f0 & (engine::kReturn | engine::kEnd)) != 0) {
            other = search.loop ? std::nullopt : std::optional<int>(0);
        } else if (!is_back(at)) {
            other = from(target, search);
        }
        return other && (!most || *other > *most) ? other : most;
    }

    bool is_back(std::size_t at) const {
        return std::any_of(assembly_.loops().begin(), assembly_.loops().end(),
                           [&](const Loop& loop) { return loop.back == at; });
    }

    /// Clocks of all rounds of the loops that begin at an instruction.
    int loops(std::size_t at, const Search& search) {
        int sum = 0;
        for (const Loop& loop : assembly_.loops()) {
            if (loop.first != at || (search.loop && search.loop->back == loop.back)) {
                continue;
            }
            Search round{loop, {}, {}};
            const std::optional<int> clocks = from(at, round);
            sum += clocks ? *clocks * loop.bound : 0;
        }
        return sum;
    }

    int subroutine(std::size_t at) {
        const auto found = subroutines_.find(at);
        if (found != subroutines_.end()) {
            return found->second;
        }
        Search search{std::nullopt, {}, {}};
        return subroutines_[at] = from(at, search).value_or(0);
    }

    const Assembly& assembly_;
    std::set<std::size_t> ends_;
    std::map<std::size_t, int> subroutines_;
};

}  // namespace

int worst_case(const Assembly& assembly, const std::string& label,
               const std::set<std::string>& ends) {
    return Ways(assembly, ends).longest(label);
}

void keep_period(const Assembly& assembly, const std::string& label,
                 const std::set<std::string>& ends, int period) {
    const int clocks = worst_case(assembly, label, ends);
    if (clocks > period) {
        throw AssemblyError(
            fmt::format("{}: error: takes {} clocks, the period has {}", label, clocks, period));
    }
}

}  // namespace curvecore::assembler
