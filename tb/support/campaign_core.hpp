// SPDX-License-Identifier: Apache-2.0
// The core that a campaign runs, told by the one Verilated header in reach: its model, the kernel
// that is its twin, the segments that it draws.
//
//     kSamples    without CURVECORE_SAMPLES: a few seconds' worth
//     kDensity    2^n samples at least in a step, but for requests that are held
#pragma once

#include <type_traits>

#include "sysc/board/core_configuration.hpp"

namespace curvecore::tb {
using namespace sysc;
}

#if __has_include("Vcurve_interpolator.h")

#include "Vcurve_interpolator.h"
#include "hls/curve_kernel.hpp"
#include "tb/support/mixed_segments.hpp"

namespace curvecore::tb {
struct CampaignCore {
    using Model = Vcurve_interpolator;
    using Kernel = hls::CurveKernel<Config>;
    using Shapes = MixedSegments<Config>;
    static constexpr int kSamples = 450'000;
    static constexpr int kDensity = 7;
};
}  // namespace curvecore::tb

#elif __has_include("Vspline_interpolator.h")

#include "Vspline_interpolator.h"
#include "hls/spline_kernel.hpp"
#include "tb/support/spline_segments.hpp"

namespace curvecore::tb {
struct CampaignCore {
    using Model = Vspline_interpolator;
    using Kernel = hls::SplineKernel<Config>;
    using Shapes = SplineSegments<Config>;
    static constexpr int kSamples = 450'000;
    static constexpr int kDensity = 7;
};
}  // namespace curvecore::tb

#elif __has_include("Vcurve_interpolator_serial.h")

#include "Vcurve_interpolator_serial.h"
#include "hls/curve_kernel.hpp"
#include "tb/support/mixed_segments.hpp"

#ifndef CFG_Splines
#define CFG_Splines 0
#endif

namespace curvecore::tb {
struct CampaignCore {
    using Model = Vcurve_interpolator_serial;
    using Kernel = hls::CurveKernel<Config>;
    using Shapes =
        std::conditional_t<CFG_Splines != 0, MixedSegments<Config>, LegalSegments<Config> >;
    static constexpr int kSamples = CFG_Splines != 0 ? 100'000 : 200'000;
    static constexpr int kDensity = 6;
};
}  // namespace curvecore::tb

#else

#include "Vspherical_interpolator.h"
#include "hls/spherical_kernel.hpp"
#include "tb/support/legal_segments.hpp"

namespace curvecore::tb {
struct CampaignCore {
    using Model = Vspherical_interpolator;
    using Kernel = hls::SphericalKernel<Config>;
    using Shapes = LegalSegments<Config>;
    static constexpr int kSamples = 500'000;
    static constexpr int kDensity = 6;
};
}  // namespace curvecore::tb

#endif
