// SPDX-License-Identifier: Apache-2.0
// `curvecore plan`: segments, feed profile, predicted error and time, without a board.
#include "ref/plan/curve_follower.hpp"
#include "sysc/commands/options/part_options.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/part/commands.hpp"
#include "sysc/commands/part/planned_job.hpp"
#include "sysc/commands/part/publish.hpp"
#include "sysc/commands/terminal/output_folder.hpp"
#include "sysc/watch/pictures.hpp"
#include "sysc/watch/predicted_pace.hpp"
#include "sysc/words/path_cursor.hpp"
#include "sysc/words/path_source.hpp"

namespace curvecore::sysc {
namespace {

struct Foreseen {
    double period;  // least sample period, clocks
    LimitLoads limits;
};

/// Predicts the samples from the exact curve.
Foreseen draw(const Job& job, std::uint64_t samples, Pictures& pictures) {
    PredictedPace pace(job.plan, job.options.core, job.options.samples_per_tick);
    PathSource source(job.plan, job.options.samples_per_tick_log2(), job.options.override_word());
    PathCursor cursor(job.plan);
    ref::CurveFollower curve;
    LimitMeter meter(job.machine, job.plan.unit_mm, job.options.sample_period_s,
                     job.options.samples_per_tick, 3 + job.plan.aux_axes);
    pictures.watch(meter);
    meter.take(ref::exact_point(cursor.segment(), cursor.segment().start, 0), 0);
    pictures.sample(0, cursor.index(), cursor.segment().start, true);
    for (std::uint64_t k = 0; k < samples; ++k) {
        const bool tick = source.next();
        cursor.advance(static_cast<std::uint64_t>(source.ds()));
        pace.sample(cursor.s());
        if (tick) pictures.tick(source.tick_ds());
        pictures.error(cursor.s(), 0,
                       job.bounded(cursor.segment().kind()) ? cursor.segment().bound : 0);
        const ref::Vec3 point = curve.on(cursor.segment()).position(cursor.local());
        meter.take(ref::exact_point(cursor.segment(), point, cursor.local()), cursor.index());
        pictures.sample(cursor.s(), cursor.index(), point, cursor.at_end());
    }
    return {pace.period(), meter.finish()};
}

int plan_command(PartOptions& part) {
    Options options = part.complete();
    hold_input(options);
    JobStream stream(options);
    Job job = plan_and_check(stream);
    add_other_forms(job);
    OutputFolder folder(options.folder);
    const std::uint64_t samples =
        count_samples(job.plan, options.samples_per_tick_log2(), options.override_word());
    Pictures pictures(job, samples / static_cast<std::uint64_t>(options.samples_per_tick));
    const Foreseen seen = draw(job, samples, pictures);
    return publish({job, samples, seen.limits, nullptr, seen.period}, pictures, folder);
}

}  // namespace

void add_plan(CLI::App& app, int& status) {
    auto [command, part] = add_command(
        app, status, "plan",
        "the same without a board: segments, feed profile, predicted error and time", plan_command);
    add_common(command, part);
    add_report(command, part);
}

}  // namespace curvecore::sysc
