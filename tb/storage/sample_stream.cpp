// SPDX-License-Identifier: Apache-2.0
// Prints what the kernels compute, word by word, from fixed random input. Compiled once for each
// storage of hls/fixed_word.hpp; the outputs must be equal. C++14, as HLS compilers want it.
#include <cmath>
#include <cstdio>

#include "hls/curve_kernel.hpp"
#include "hls/path_kernel.hpp"

namespace {

using namespace curvecore::hls;

/// A plain generator: the same numbers everywhere.
class Random {
  public:
    double uniform(double low, double high) {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return low + (high - low) * std::ldexp(static_cast<double>(state_ >> 11), -53);
    }

  private:
    std::uint64_t state_ = 1;
};

template <class C>
SegmentWords<C> random_segment(Random& random) {
    SegmentWords<C> segment;
    const double radius = std::exp(random.uniform(std::log(1e3), std::log(1e6)));
    int k = 0;
    while (std::ldexp(1.0, k + 1) < 0.3 * radius) ++k;
    const double pitch = random.uniform(0, 1);
    const double angle = random.uniform(0, 6.28);
    const double one = std::ldexp(1.0, C::kCoefFrac);
    const double wave[3] = {std::cos(angle) * std::cos(pitch), std::sin(angle) * std::cos(pitch),
                            0};
    segment.length = std::int64_t(random.uniform(1, 1.5 * radius * 65536));
    segment.step_exponent = k;
    segment.theta =
        std::int64_t(std::ldexp(std::cos(pitch) / radius, k) * std::ldexp(1.0, C::kUnitFrac));
    for (int axis = 0; axis < C::kAxes; ++axis) {
        segment.start[axis] = std::int64_t(random.uniform(-1e6, 1e6));
        segment.end[axis] = std::int64_t(random.uniform(-1e6, 1e6));
        segment.advance[axis] = std::int64_t(random.uniform(-0.9, 0.9) * one);
    }
    for (int axis = 0; axis < 3; ++axis) {
        segment.normal[axis] = std::int64_t(wave[axis] * one);
        segment.tangent[axis] = std::int64_t((axis == 0 ? -wave[1] : wave[(axis + 2) % 3]) * one);
    }
    return segment;
}

/// V runs over a parabola through three points of a circle, at 0.6 .. 0.9 of 2^lambda: it turns by
/// up to 1.2 rad, out of the plane too. Steps are short enough for every word's range.
template <class C>
SegmentWords<C> random_spline(Random& random) {
    SegmentWords<C> segment = random_segment<C>(random);
    segment.kind = SegmentKind::kSpline;
    segment.lambda = int(random.uniform(4, 24));
    segment.step_exponent = segment.lambda - 4 + int(random.uniform(0, 3.99)) % 3;
    if (segment.step_exponent > segment.lambda - 3) segment.step_exponent = segment.lambda - 3;
    const double part = random.uniform(0.01, 0.9);
    segment.length = std::int64_t(std::ldexp(0.6 * part, segment.lambda + kPathFrac)) + 1;
    const double turn = random.uniform(-1.2, 1.2);
    const double from = random.uniform(0, 6.28);
    const double speed = random.uniform(0.65, 0.85);
    const double lift = random.uniform(-0.05, 0.05);
    double norm = 0;
    const double one = std::ldexp(1.0, C::kCoefFrac);
    for (int axis = 0; axis < 3; ++axis) {
        double point[3];
        for (int i = 0; i < 3; ++i) {
            const double angle = from + turn * i / 2;
            point[i] = axis == 0 ? std::cos(angle) : axis == 1 ? std::sin(angle) : lift * i;
        }
        const double c = speed * point[0];
        const double b = speed * (4 * point[1] - 3 * point[0] - point[2]) / 2;
        const double a = speed * (2 * point[0] - 4 * point[1] + 2 * point[2]) / 3;
        norm += c * c;
        segment.tangent[axis] = std::int64_t(a * one);
        segment.normal[axis] = std::int64_t(b * one);
        segment.advance[axis] = std::int64_t(c * one);
    }
    segment.theta = std::int64_t(one / std::sqrt(norm));
    return segment;
}

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
    print_samples<Configuration<3, 30, 32, 8, 1, SamplerMode::kSeries, true, 6>>(false);
    print_path();
}
