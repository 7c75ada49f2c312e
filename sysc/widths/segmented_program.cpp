// SPDX-License-Identifier: Apache-2.0
#include "tb/compare/cut.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/program/input_error.hpp"

namespace curvecore::tb {
namespace {

constexpr int kMostDoublings = 24;

ref::PlanOptions plan_options(const ref::Program& program, const ref::WordFormat& format,
                              double unit_mm, double limit) {
    ref::PlanOptions options;
    options.unit_mm = unit_mm;
    options.format = format;
    options.aux_axes = program.aux_axes;
    options.error_limit = limit;
    return options;
}

/// "FILE:LINE: error: reason" as "line LINE: reason".
std::string reason(const std::string& file, const std::string& refusal) {
    const std::string mark = ": error: ";
    const std::size_t at = refusal.find(mark, file.size());
    if (at == std::string::npos) return refusal;
    const std::string words = refusal.substr(at + mark.size());
    return at > file.size()
               ? fmt::format("line {}: {}", refusal.substr(file.size() + 1, at - file.size() - 1),
                             words)
               : words;
}

}  // namespace

Cutter::Cutter(const ref::Program& program, const ref::Machine& machine, double unit_mm,
               double limit, int times_segments)
    : program_(program), machine_(machine), unit_mm_(unit_mm), limit_(limit) {
    ref::WordFormat widest;
    widest.order = 12;
    widest.guard_bits = 12;
    widest.polynomial = true;
    const ref::Geometry geometry =
        ref::make_geometry(program, machine, plan_options(program, widest, unit_mm, limit));
    reference_segments_ = geometry.segments.size();
    if (reference_segments_ == 0) {
        throw ref::InputError(program.file, 0, "the program does not move");
    }
    most_segments_ = reference_segments_ * static_cast<std::size_t>(times_segments);
}

bool Cutter::fits(const ref::WordFormat& format, double limit, Cut& cut) const {
    ref::PlanOptions options = plan_options(program_, format, unit_mm_, limit);
    options.max_pieces = static_cast<int>(std::min<std::size_t>(most_segments_, 1 << 16));
    options.advise = false;
    ref::Geometry geometry;
    try {
        geometry = ref::make_geometry(program_, machine_, options);
    } catch (const ref::InputError& refusal) {
        if (cut.refused.empty()) cut.refused = reason(program_.file, refusal.what());
        return false;
    }
    if (geometry.segments.size() > most_segments_) {
        if (cut.refused.empty()) {
            cut.refused = fmt::format("{} segments, {} are the most", geometry.segments.size(),
                                      most_segments_);
        }
        return false;
    }
    cut.segments = std::move(geometry.segments);
    cut.limit = limit;
    return true;
}

Cut Cutter::cut(const ref::WordFormat& format) const {
    Cut cut;
    if (fits(format, limit_, cut)) return cut;
    int low = 0;  // refused
    int high = kMostDoublings;
    if (!fits(format, std::ldexp(limit_, high), cut)) return cut;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        (fits(format, std::ldexp(limit_, middle), cut) ? high : low) = middle;
    }
    return cut;
}

}  // namespace curvecore::tb
