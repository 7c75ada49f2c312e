// SPDX-License-Identifier: Apache-2.0
// A kernel of C++ makes each row up to some order: Order less a number, by the sampler's mode.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "ref/curves/order_demand.hpp"
#include "ref/format/parameters.hpp"
#include "ref/text/place.hpp"

namespace curvecore {
namespace hls {

class OrderLimits {
  public:
    explicit OrderLimits(const ref::CurveTable& table) {
        const ref::Parameter& orders = ref::parameter_of(&ref::CoreParameters::order);
        for (const bool polynomial : {false, true}) {
            for (const auto& [row, needed] : ref::order_demand(table, orders.high, polynomial)) {
                if (needed > 0) below_[polynomial][row] = orders.high - needed;
            }
            for (int order = orders.low; order <= orders.high; ++order) {
                const auto needed = ref::order_demand(table, order, polynomial);
                for (const auto& [row, below] : below_[polynomial]) {
                    const auto found = needed.find(row);
                    const int has = found == needed.end() ? 0 : found->second;
                    if (has != std::max(0, order - below)) {
                        ref::Place{table.file, table.rows.at(row).line}.refuse(
                            row +
                            " is needed to orders that are no number below Order: a kernel "
                            "of C++ needs that");
                    }
                }
            }
        }
    }

    bool needed(const std::string& row) const {
        return below_[0].count(row) + below_[1].count(row) > 0;
    }
    /// The condition for order i, empty for every one.
    std::string condition(const std::string& row) const {
        std::string modes[2];
        for (const int mode : {0, 1}) {
            const auto found = below_[mode].find(row);
            if (found == below_[mode].end()) {
                modes[mode] = "false";
            } else if (found->second > 0) {
                modes[mode] = fmt::format("i <= C::kOrder - {}", found->second);
            }
        }
        if (modes[0] == modes[1]) return modes[0];
        if (modes[1] == "false") return "C::kSeries" + (modes[0].empty() ? "" : " && " + modes[0]);
        if (modes[0] == "false") {
            return "!C::kSeries" + (modes[1].empty() ? "" : " && " + modes[1]);
        }
        return fmt::format("i <= C::kOrder - (C::kSeries ? {} : {})", below_[0].at(row),
                           below_[1].at(row));
    }
    /// The highest order that is made.
    std::string last(const std::string& row) const {
        const auto of = [&](int mode) {
            const auto found = below_[mode].find(row);
            return found == below_[mode].end() ? 0 : found->second;
        };
        if (of(0) != of(1)) return fmt::format("C::kOrder - (C::kSeries ? {} : {})", of(0), of(1));
        return of(0) == 0 ? "C::kOrder" : fmt::format("C::kOrder - {}", of(0));
    }

  private:
    std::map<std::string, int> below_[2];
};

}  // namespace hls
}  // namespace curvecore
