// SPDX-License-Identifier: Apache-2.0
#include "sysc/host/bus_words.hpp"

#include <algorithm>

#include "hls/quantise.hpp"
#include "sysc/host/run_time_format.hpp"

namespace curvecore::sysc {

std::vector<std::uint64_t> segment_bus_words(const ref::Segment& segment, std::size_t index,
                                             const CoreParameters& parameters) {
    const RunTimeFormat format(parameters, parameters.axes());
    std::vector<std::uint64_t> words(
        static_cast<std::size_t>(ref::segment_bus_words(parameters.aux_axes)));
    hls::pack(hls::to_words(segment, format), static_cast<unsigned>(index), words.data(), format);
    return words;
}

std::vector<std::uint64_t> profile_bus_words(const ref::Plan& plan, std::size_t index,
                                             std::size_t number) {
    std::vector<std::uint64_t> words;
    const auto is_before = [](const ref::PlannedBranch& branch, std::size_t piece) {
        return branch.piece < piece;
    };
    const auto branch =
        std::lower_bound(plan.branches.begin(), plan.branches.end(), index, is_before);
    if (branch != plan.branches.end() && branch->piece == index) {
        words.push_back(hls::pack_stop(static_cast<std::int32_t>(branch->wait)));
        for (const ref::StopStep& step : branch->steps) {
            words.push_back(hls::pack(hls::to_words(step, &step == &branch->steps.back())));
        }
    }
    words.resize(words.size() + hls::kProfileBusWords);
    hls::pack(hls::to_words(plan.pieces[index]), static_cast<unsigned>(number),
              &words[words.size() - hls::kProfileBusWords]);
    return words;
}

}  // namespace curvecore::sysc
