// SPDX-License-Identifier: Apache-2.0
// A curve that no core draws, drawn by rtl/motion_interpolator.sv as it is: microcode of a table in
// place of arcs', its segments in arcs' words. Every sample is the table's, run in words.
#include <optional>

#include "ref/curves/table_reader.hpp"
#include "rtl/engine/compiler/motion_program.hpp"
#include "sysc/core/table_kernel.hpp"
#include "tb/support/bench/motion_bench.hpp"
#include "tb/support/microcode/engine_memories.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb {
namespace {

const ref::CurveTable& clothoid() {
    static const ref::CurveTable kTable =
        ref::read_curve_table(RTL_DIR "/../ref/curves/clothoid.net");
    return kTable;
}

/// Clothoids and, of a core that has them, splines.
class ClothoidKernel {
  public:
    explicit ClothoidKernel(const RunTimeFormat& format)
        : clothoid_(clothoid(), format), spline_(format) {}

    void load(const RunSegment& words) {
        of_spline_ = words.kind == hls::SegmentKind::kSpline;
        of_spline_ ? spline_.load(words) : clothoid_.load(words);
    }
    void step() { of_spline_ ? spline_.step() : clothoid_.step(); }
    void sample(std::int64_t sigma, std::int64_t* fine) {
        of_spline_ ? spline_.sample(sigma, fine) : clothoid_.sample(sigma, fine);
    }

  private:
    bool of_spline_ = false;
    TableKernel clothoid_;
    hls::SplineKernel<RunTimeFormat> spline_;
};

class TableMicrocode : public MotionInterpolator {
  protected:
    TableMicrocode() {
        dut_.limit_cycles(~std::uint64_t{0});
        const std::string tree = RTL_DIR "/..";
        memories_.load(assembler::motion_program(
                           {clothoid(), ref::read_curve_table(tree + "/ref/curves/spline.net")},
                           core_, {1024, 256}, tree),
                       assembler::motion_store(core_));
        start_afresh();
    }

    void draw(int64_t ds, int64_t (&fine)[kMostAxes]) override {
        drawn_->sample(
            ds, [this] { return next_segment(); }, fine);
    }

    /// Turns the arcs of a program into clothoids: a frame in any plane, curvature and its change;
    /// each axis has a curvature of its own, so that another's would be seen.
    void bend(std::vector<RunSegment>& segments) {
        const auto real = [this](double most) {
            return std::uniform_real_distribution<double>(-most, most)(random_);
        };
        const auto word = [this](double value, int fraction) {
            return static_cast<int64_t>(std::ldexp(value, core_.coef_bits + fraction));
        };
        for (RunSegment& segment : segments) {
            if (segment.kind == hls::SegmentKind::kSpline) continue;
            const ref::Vec3 t = ref::Vec3(real(1), real(1), real(1)).normalized();
            const ref::Vec3 n = t.cross(ref::Vec3(real(1), real(1), real(1))).normalized();
            segment.theta = word(std::abs(real(1.0 / 256)), 1);
            for (int axis = 0; axis < 3; ++axis) {
                segment.tangent[axis] = word(t[axis], -2);
                segment.normal[axis] = word(n[axis], -2);
                segment.advance[axis] = word(real(1.0 / 8), 1);
            }
            ++clothoids_;
        }
    }

    EngineMemories memories_{"motion_interpolator.g_engine.u_motion.u_engine"};
    std::optional<hls::InterpolatorKernel<RunTimeFormat, ClothoidKernel>> drawn_;
    int clothoids_ = 0;
};

TEST_F(TableMicrocode, DrawsTheWordsOfItsTable) {
    const int rounds = cases(4, 50);
    int64_t samples = 0;
    for (int round = 0; round < rounds && !HasFatalFailure(); ++round) {
        start_afresh();
        drawn_.emplace(format_);
        const auto profile = pieces(static_cast<uint32_t>(round), 40, 20, 40, 3 << 16);
        int64_t length = 0;
        for (const hls::ProfileWords& piece : profile) length += piece.ds;
        MixedSegments shapes(core_, random_(), kMaxStepExponent);
        auto segments = chain(shapes, length, int64_t{1} << (kMaxStepExponent + hls::kPathFrac));
        bend(segments);
        program(profile, segments);
        fill();
        run();
        samples += samples_;
    }
    std::cout << samples << " samples, " << clothoids_ << " clothoids\n";
    EXPECT_GT(clothoids_, 2 * rounds);
    EXPECT_GT(samples, 1000 * rounds);
}

}  // namespace
}  // namespace curvecore::tb
