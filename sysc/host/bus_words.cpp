// SPDX-License-Identifier: Apache-2.0
#include "sysc/host/bus_words.hpp"

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

std::vector<std::uint64_t> profile_bus_words(const ref::ProfilePiece& piece, std::size_t index) {
    std::vector<std::uint64_t> words(hls::kProfileBusWords);
    hls::pack(hls::to_words(piece), static_cast<unsigned>(index), words.data());
    return words;
}

}  // namespace curvecore::sysc
