// SPDX-License-Identifier: Apache-2.0
// Top of the HLS of hls/curves/hyperbola.hpp, as a function without a state: every call begins a
// hyperbola and makes CFG_Steps integration steps.
//
//     start       y at the first step's start
//     y_coef      orders 0 .. Order of the last step
//     z_coef      orders of its derivative that are made of it
//     next_y      y a step farther on
#include "hls/curves/hyperbola.hpp"

#include "hls/top/top_configuration.hpp"

namespace curvecore {
namespace hls {

using Coef = TopConfiguration::Coef;
using SeriesOfY = Coef[TopConfiguration::kOrder + 1];
using SeriesOfZ = Coef[TopConfiguration::kTop + 1];

extern "C" void hyperbola_hls(const Coef& start, SeriesOfY& y_coef, SeriesOfZ& z_coef,
                              Coef& next_y) {
    HyperbolaNetwork<TopConfiguration> kernel;
    kernel.load(start);
    for (int step = 0; step < CFG_Steps; ++step) {
        kernel.step();
    }
    for (int i = 0; i <= TopConfiguration::kOrder; ++i) {
        y_coef[i] = kernel.y_[i];
    }
    for (int i = 0; i <= TopConfiguration::kTop; ++i) {
        z_coef[i] = kernel.z_[i];
    }
    kernel.step();
    next_y = kernel.y_[0];
}

}  // namespace hls
}  // namespace curvecore
