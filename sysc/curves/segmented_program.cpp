// SPDX-License-Identifier: Apache-2.0
#include "sysc/curves/segmented_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/text/input_error.hpp"

namespace curvecore::sysc {
namespace {

constexpr int kMostDoublings = 24;

ref::PlanOptions plan_options(const ref::Program& program, const CoreParameters& format,
                              double unit_mm, double limit) {
    ref::PlanOptions options;
    options.unit_mm = unit_mm;
    options.format = format;
    options.aux_axes = program.aux_axes;
    options.error_limit = limit;
    return options;
}

/// Rewrites "FILE:LINE: error: reason" as "line LINE: reason".
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

Segmenter::Segmenter(const ref::Program& program, const ref::Machine& machine, double unit_mm,
                     double limit, int times_segments)
    : program_(program), machine_(machine), unit_mm_(unit_mm), limit_(limit) {
    const ref::Geometry geometry =
        ref::make_geometry(program, machine, plan_options(program, widest_words(), unit_mm, limit));
    reference_segments_ = geometry.segments.size();
    if (reference_segments_ == 0) {
        throw ref::InputError(program.file, 0, "the program does not move");
    }
    most_segments_ = reference_segments_ * static_cast<std::size_t>(times_segments);
}

bool Segmenter::fits(const CoreParameters& format, double limit,
                     SegmentedProgram& segmented) const {
    ref::PlanOptions options = plan_options(program_, format, unit_mm_, limit);
    options.max_pieces = static_cast<int>(std::min<std::size_t>(most_segments_, 1 << 16));
    options.advise = false;
    ref::Geometry geometry;
    try {
        geometry = ref::make_geometry(program_, machine_, options);
    } catch (const ref::InputError& refusal) {
        if (segmented.refused.empty()) segmented.refused = reason(program_.file, refusal.what());
        return false;
    }
    if (geometry.segments.size() > most_segments_) {
        if (segmented.refused.empty()) {
            segmented.refused = fmt::format("{} segments, {} are the most",
                                            geometry.segments.size(), most_segments_);
        }
        return false;
    }
    segmented.segments = std::move(geometry.segments);
    segmented.limit = limit;
    return true;
}

SegmentedProgram Segmenter::segment(const CoreParameters& format) const {
    SegmentedProgram segmented;
    if (fits(format, limit_, segmented)) return segmented;
    int low = 0;  // limit that was refused
    int high = kMostDoublings;
    if (!fits(format, std::ldexp(limit_, high), segmented)) return segmented;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        (fits(format, std::ldexp(limit_, middle), segmented) ? high : low) = middle;
    }
    return segmented;
}

}  // namespace curvecore::sysc
