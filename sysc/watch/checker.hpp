// SPDX-License-Identifier: Apache-2.0
// Check of every sample of a board against the kernel's prediction, bit for bit, and against the
// exact curve at the same path length.
#pragma once

#include <optional>

#include "ref/plan/curve_follower.hpp"
#include "sysc/board/board.hpp"
#include "sysc/job/job.hpp"
#include "sysc/kernel/run_time_kernel.hpp"
#include "sysc/watch/check_result.hpp"
#include "sysc/watch/limit_meter.hpp"
#include "sysc/watch/pictures.hpp"
#include "sysc/watch/samples_writer.hpp"
#include "sysc/watch/tool_meter.hpp"
#include "sysc/words/bus_words.hpp"
#include "sysc/words/path_cursor.hpp"
#include "sysc/words/path_source.hpp"

namespace curvecore::sysc {

class Checker {
  public:
    Checker(const Job& job, SamplesWriter& samples, Pictures& pictures);

    void take(const Sample& drawn);

    /// Returns the result; to be called after the last sample.
    const CheckResult& result();

  private:
    void start();
    void compare_with_kernel(const Sample& drawn);
    std::string differences(const Sample& drawn, const std::int64_t* fine) const;
    void compare_with_curve(const Sample& drawn);
    void meter(const ref::AxisPoint& exact, const std::int64_t* position);
    KindResult& kind_of(const ref::Segment& segment);
    ref::Vec3 turned(double s) const;
    ref::Vec3 compare_tool(const ref::Vec3& joints, const ref::Vec3& abc, double s);
    void compare_speed(const ref::Vec3& point, const ref::Vec3& curve);
    bool stops(std::size_t segment) const;
    void compare_landing(const Sample& drawn);

    const Job& job_;
    const int core_axes_;
    const int axes_;  // axes in use; the others stand at 0
    const double fine_unit_;
    const double chord_tolerance_;  // both ends off by the bound on every axis
    PathSource source_;
    const RunTimeFormat format_;
    RunTimeKernel kernel_;
    JoinedSegments words_;
    PathCursor cursor_;
    ref::CurveFollower curve_;
    SamplesWriter& samples_;
    Pictures& pictures_;
    LimitMeter drawn_;    // the exact curve at the samples' path lengths
    LimitMeter rounded_;  // the samples
    std::optional<ToolMeter> tool_;
    const ref::Segment* segment_of_kind_ = nullptr;
    KindResult* kind_ = nullptr;  // kind of that segment
    std::size_t next_segment_ = 0;
    std::size_t last_stop_ = static_cast<std::size_t>(-1);
    ref::Vec3 last_point_ = ref::Vec3::Zero();
    ref::Vec3 last_curve_ = ref::Vec3::Zero();
    CheckResult result_;
};

}  // namespace curvecore::sysc
