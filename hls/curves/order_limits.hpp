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
    explicit OrderLimits(const ref::CurveTable& table) : carries_(table.carries(false)) {
        const ref::Parameter& orders = ref::parameter_of(&ref::CoreParameters::order);
        for (const bool anchored : {false, true}) {
            for (const bool polynomial : {false, true}) {
                Below& below = below_[anchored][polynomial];
                for (const auto& [row, needed] :
                     ref::order_demand(table, orders.high, polynomial, anchored)) {
                    if (needed > 0) below[row] = orders.high - needed;
                }
                for (int order = orders.low; order <= orders.high; ++order) {
                    check(table, below, order,
                          ref::order_demand(table, order, polynomial, anchored));
                }
            }
        }
    }

    bool needed(const std::string& row) const {
        return below_[1][0].count(row) + below_[1][1].count(row) > 0;
    }
    /// The condition for order i, empty for every one.
    std::string condition(const std::string& row) const {
        std::string anchored = condition(below_[1], row);
        const std::string carried = carries_ ? condition(below_[0], row) : anchored;
        if (anchored == carried) return anchored;
        if (carried.empty()) return "!C::kAnchor || " + anchored;
        return fmt::format("C::kAnchor ? {} : {}", anchored, carried);
    }
    /// The highest order that is made, in a section.
    std::string last(const std::string& row, const std::string& section) const {
        const std::string carried = less(below_[carries_ ? 0 : 1], row);
        const std::string anchored = section == "carry" ? carried : less(below_[1], row);
        if (anchored == carried) return anchored == "0" ? "C::kOrder" : "C::kOrder - " + anchored;
        return fmt::format("C::kOrder - (C::kAnchor ? {} : {})", anchored, carried);
    }

  private:
    using Below = std::map<std::string, int>;  // Order less the highest that is needed

    static void check(const ref::CurveTable& table, const Below& below, int order,
                      const std::map<std::string, int>& needed) {
        for (const auto& [row, less] : below) {
            const auto found = needed.find(row);
            const int has = found == needed.end() ? 0 : found->second;
            if (has == std::max(0, order - less)) continue;
            ref::Place{table.file, table.rows.at(row).line}.refuse(
                row +
                " is needed to orders that are no number below Order: a kernel of C++ needs that");
        }
    }
    /// The condition by the mode of the sampler.
    static std::string condition(const Below (&below)[2], const std::string& row) {
        std::string modes[2];
        for (const int mode : {0, 1}) {
            const auto found = below[mode].find(row);
            if (found == below[mode].end()) {
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
        return fmt::format("i <= C::kOrder - (C::kSeries ? {} : {})", below[0].at(row),
                           below[1].at(row));
    }
    /// Order less the highest that is made.
    static std::string less(const Below (&below)[2], const std::string& row) {
        const auto of = [&](int mode) {
            const auto found = below[mode].find(row);
            return found == below[mode].end() ? 0 : found->second;
        };
        if (of(0) == of(1)) return std::to_string(of(0));
        return fmt::format("(C::kSeries ? {} : {})", of(0), of(1));
    }

    bool carries_;
    Below below_[2][2];  // by Anchor, by the mode of the sampler
};

}  // namespace hls
}  // namespace curvecore
