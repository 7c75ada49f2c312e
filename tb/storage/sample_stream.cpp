// SPDX-License-Identifier: Apache-2.0
// Prints the kernels' results, word by word, from fixed random input. Compiled once for each
// storage of hls/fixed_word.hpp; the outputs must be equal. C++14, as HLS compilers require.
#include <cmath>
#include <cstdio>

#include "hls/curve_kernel.hpp"
#include "hls/curves/arc.hpp"
#include "hls/curves/archimedean.hpp"
#include "hls/curves/catenary.hpp"
#include "hls/curves/clothoid.hpp"
#include "hls/curves/ellipse.hpp"
#include "hls/curves/hyperbola.hpp"
#include "hls/curves/involute.hpp"
#include "hls/curves/quintic.hpp"
#include "hls/curves/series.hpp"
#include "hls/curves/spiral.hpp"
#include "hls/curves/spline.hpp"
#include "hls/path_kernel.hpp"
#include "tb/support/segments/plain_segments.hpp"

// Every made kernel is a kernel of each storage.
namespace curvecore {
namespace hls {
using Widest = Configuration<6, 36, 32, 10, 1, SamplerMode::kPolynomial>;
template class ArchimedeanCurve<WithFurther<Widest, ArchimedeanCurve<Widest>::kFurther>>;
template class CatenaryCurve<WithFurther<Widest, CatenaryCurve<Widest>::kFurther>>;
template class ClothoidCurve<WithFurther<Widest, ClothoidCurve<Widest>::kFurther>>;
template class EllipseCurve<WithFurther<Widest, EllipseCurve<Widest>::kFurther>>;
template class InvoluteCurve<WithFurther<Widest, InvoluteCurve<Widest>::kFurther>>;
template class QuinticCurve<WithFurther<Widest, QuinticCurve<Widest>::kFurther>>;
template class SeriesCurve<WithFurther<Widest, SeriesCurve<Widest>::kFurther>>;
template class SpiralCurve<WithFurther<Widest, SpiralCurve<Widest>::kFurther>>;
}  // namespace hls
}  // namespace curvecore

namespace {

using namespace curvecore::tb;

template <class C>
void print_samples(bool splines) {
    Random random;
    MotionKernel<C> kernel;
    for (int n = 0; n < 20000; ++n) {
        Word<C::kFineBits> fine[C::kAxes];
        const std::int64_t ds = std::int64_t(std::exp(random.uniform(0, 23)));
        const auto next_segment = [&] {
            return splines && random.uniform(0, 1) < 0.8 ? random_spline<C>(random)
                                                         : random_segment<C>(random);
        };
        kernel.sample(Word<kLengthBits + 1>(ds), next_segment, fine);
        for (const auto& word : fine) {
            std::printf("%lld ", static_cast<long long>(to_int(word)));
        }
        std::printf("\n");
    }
}

/// Samples of the made kernels of arcs and splines.
template <class C, template <class> class Kernel>
void print_made(SegmentWords<C> (*draw)(Random&)) {
    Random random;
    Kernel<C> kernel;
    for (int n = 0; n < 1000; ++n) {
        const SegmentWords<C> segment = draw(random);
        kernel.load(segment);
        for (int step = 0; step < 3; ++step) {
            if (step > 0) kernel.step();
            const auto offset =
                std::int64_t(random.uniform(0, std::ldexp(1.0, segment.step_exponent + kPathFrac)));
            Word<C::kFineBits> fine[C::kAxes];
            kernel.sample(Word<kLengthBits + 1>(offset), fine);
            for (const auto& word : fine) {
                std::printf("%lld ", static_cast<long long>(to_int(word)));
            }
            std::printf("\n");
        }
    }
}
template <class C>
void print_made_kernels() {
    print_made<C, ArcCurve>([](Random& random) { return random_segment<C>(random); });
    print_made<C, SplineCurve>([](Random& random) { return random_spline<C>(random); });
}

template <class C>
void print_hyperbolas() {
    Random random;
    HyperbolaNetwork<C> kernel;
    for (int n = 0; n < 2000; ++n) {
        if (n % 10 == 0) {
            kernel.load(std::int64_t(random.uniform(0, std::ldexp(0.5, C::kCoefBits))));
        } else {
            kernel.step();
        }
        for (const auto& word : kernel.y_) {
            std::printf("%lld ", static_cast<long long>(to_int(word)));
        }
        std::printf("%lld\n", static_cast<long long>(to_int(kernel.z_[C::kOrder - 1])));
    }
}

void print_path() {
    Random random;
    PathKernel path;
    for (int n = 0; n < 20000; ++n) {
        const auto piece = [&](ProfileWords& words) {
            words.ticks = int(random.uniform(1, 500));
            words.time_exponent = 9;
            words.exponent = int(random.uniform(0, 41));
            words.ds = std::int64_t(random.uniform(0, std::ldexp(1.0, words.exponent)));
            for (auto& c : words.c)
                c = std::int64_t(random.uniform(-0.6, 0.6) * std::ldexp(1.0, 34));
            return true;
        };
        const Word<kLengthBits + 1> ds = path.tick(int(random.uniform(0, 65536)), piece);
        std::printf("%lld\n", static_cast<long long>(to_int(ds)));
    }
}

}  // namespace

int main() {
    for (int kind = 0; kind < 2; ++kind) {
        const bool splines = kind == 1;
        print_samples<Configuration<6, 36, 32, 10, 0, SamplerMode::kSeries>>(splines);
        print_samples<Configuration<6, 36, 32, 10, 1, SamplerMode::kPolynomial>>(splines);
        print_samples<Configuration<2, 18, 24, 2, 0, SamplerMode::kSeries>>(splines);
        print_samples<Configuration<11, 29, 32, 12, 6, SamplerMode::kPolynomial>>(splines);
    }
    print_samples<Configuration<6, 36, 32, 10, 0, SamplerMode::kSeries, false>>(true);
    print_samples<Configuration<5, 33, 32, 8, 0, SamplerMode::kPolynomial, false>>(true);
    print_made_kernels<Configuration<6, 36, 32, 10, 1, SamplerMode::kPolynomial>>();
    print_made_kernels<Configuration<6, 32, 32, 10, 0, SamplerMode::kSeries>>();
    print_hyperbolas<Configuration<6, 36, 32, 10, 0, SamplerMode::kSeries>>();
    print_hyperbolas<Configuration<11, 29, 32, 10, 0, SamplerMode::kSeries, false>>();
    print_path();
}
