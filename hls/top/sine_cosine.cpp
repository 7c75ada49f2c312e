// SPDX-License-Identifier: Apache-2.0
// Top of the HLS of hls::SineCosineNetwork, as a function without a state: every call is an
// integration step.
//
//     theta, sine, cosine             angle of the step, and the state at its start
//     sine_coef, cosine_coef          orders 1 .. Order
//     next_sine, next_cosine          the state a step farther on
#include "hls/curves/sine_cosine.hpp"

#include "hls/top/top_configuration.hpp"

namespace curvecore {
namespace hls {

using Coef = TopConfiguration::Coef;
using Series = Coef[CFG_Order];

extern "C" void sine_cosine_hls(const Coef& theta, const Coef& sine, const Coef& cosine,
                                Series& sine_coef, Series& cosine_coef, Coef& next_sine,
                                Coef& next_cosine) {
    SineCosineNetwork<TopConfiguration> node;
    node.load(theta, sine, cosine);  // read before the first result is written: one place, perhaps
    for (int i = 1; i <= TopConfiguration::kOrder; ++i) {
        sine_coef[i - 1] = node.y_[i];
        cosine_coef[i - 1] = node.z_[i];
    }
    node.step();
    next_sine = node.y_[0];
    next_cosine = node.z_[0];
}

}  // namespace hls
}  // namespace curvecore
