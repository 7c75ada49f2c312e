// SPDX-License-Identifier: Apache-2.0
// Only CoefBits and GuardBits change words: PositionBits limit their range (which the planner has
// kept), and auxiliary axes come last, so that fewer of them are a prefix.
#include "sysc/host/bus_words.hpp"

#include <array>
#include <utility>

#include "hls/quantise.hpp"

namespace curvecore::sysc {
namespace {

constexpr int kLeastCoefBits = 18;
constexpr int kCoefBitsChoices = 19;
constexpr int kLeastGuardBits = 2;
constexpr int kGuardBitsChoices = 11;

template <int CoefBits, int GuardBits>
void pack_as(const ref::Segment& segment, unsigned sequence, std::uint64_t* out) {
    using C =
        hls::Configuration<6, CoefBits, 32, GuardBits, ref::kAuxAxes, hls::SamplerMode::kSeries>;
    hls::pack<C>(hls::to_words<C>(segment), sequence, out);
}

using Pack = void (*)(const ref::Segment&, unsigned, std::uint64_t*);

template <std::size_t... I>
constexpr std::array<Pack, sizeof...(I)> pack_table(std::index_sequence<I...> /*choices*/) {
    return {&pack_as<kLeastCoefBits + static_cast<int>(I) / kGuardBitsChoices,
                     kLeastGuardBits + static_cast<int>(I) % kGuardBitsChoices>...};
}

constexpr auto kPack = pack_table(std::make_index_sequence<kCoefBitsChoices * kGuardBitsChoices>());

}  // namespace

std::vector<std::uint64_t> segment_bus_words(const ref::Segment& segment, std::size_t index,
                                             const CoreParameters& parameters) {
    const int choice = (parameters.coef_bits - kLeastCoefBits) * kGuardBitsChoices +
                       parameters.guard_bits - kLeastGuardBits;
    std::vector<std::uint64_t> words(ref::segment_bus_words(ref::kAuxAxes));
    kPack[static_cast<std::size_t>(choice)](segment, static_cast<unsigned>(index), words.data());
    words.resize(static_cast<std::size_t>(ref::segment_bus_words(parameters.aux_axes)));
    return words;
}

std::vector<std::uint64_t> profile_bus_words(const ref::ProfilePiece& piece, std::size_t index) {
    std::vector<std::uint64_t> words(hls::kProfileBusWords);
    hls::pack(hls::to_words(piece), static_cast<unsigned>(index), words.data());
    return words;
}

}  // namespace curvecore::sysc
