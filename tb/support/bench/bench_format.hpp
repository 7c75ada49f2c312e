// SPDX-License-Identifier: Apache-2.0
// The format of the core that a bench is linked with, for its kernel and its words.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "sysc/kernel/run_time_format.hpp"
#include "tb/support/bench/core_configuration.hpp"

namespace curvecore::tb {
using namespace sysc;

/// A base of benches.
class BenchFormat {
  protected:
    /// @param table a further curve of the core; none: it has none
    explicit BenchFormat(std::shared_ptr<const ref::CurveTable> table = {})
        : core_(with(std::move(table))) {}

    /// Words of a segment on the bus.
    std::size_t segment_frame() const { return static_cast<std::size_t>(core_.segment_words()); }
    std::vector<uint64_t> bus_words(const RunSegment& segment, unsigned sequence) const {
        std::vector<uint64_t> bus(segment_frame());
        hls::pack(segment, sequence, bus.data(), format_);
        return bus;
    }

    const CoreParameters core_;
    const RunTimeFormat format_{core_, core_.axes()};

  private:
    static CoreParameters with(std::shared_ptr<const ref::CurveTable> table) {
        CoreParameters core = core_configuration().parameters;
        ref::add_table(std::move(table), core);
        return core;
    }
};

}  // namespace curvecore::tb
