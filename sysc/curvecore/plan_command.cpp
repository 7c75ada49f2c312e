// SPDX-License-Identifier: Apache-2.0
// `curvecore plan`: segments, feed profile, predicted error and time, without the RTL.
#include "ref/curve/curve_follower.hpp"
#include "tb/program/commands.hpp"
#include "tb/program/output_folder.hpp"
#include "tb/program/path_cursor.hpp"
#include "tb/program/path_source.hpp"
#include "tb/program/pictures.hpp"
#include "tb/program/publish.hpp"

namespace curvecore::tb {
namespace {

/// What the samples will show, from the exact curve.
void draw(const Job& job, std::uint64_t samples, Pictures& pictures) {
    PathSource source(job.plan, job.options.samples_per_tick_log2(), job.options.override_word());
    PathCursor cursor(job.plan);
    ref::CurveFollower curve;
    pictures.sample(0, cursor.index(), cursor.segment().start, true);
    for (std::uint64_t k = 0; k < samples; ++k) {
        const bool tick = source.next();
        cursor.advance(static_cast<std::uint64_t>(source.ds()));
        if (tick) {
            pictures.tick(source.tick_ds(), curve.curvature(cursor.segment(), cursor.local()));
        }
        pictures.error(cursor.s(), 0, cursor.segment().bound);
        if (pictures.wants(cursor.s(), cursor.index(), cursor.at_end())) {
            pictures.sample(cursor.s(), cursor.index(),
                            curve.position(cursor.segment(), cursor.local()), cursor.at_end());
        }
    }
}

}  // namespace

int plan_command(const Options& options) {
    Job job = read_job(options);
    plan_job(job);
    OutputFolder folder(options.folder);
    const std::uint64_t samples =
        count_samples(job.plan, options.samples_per_tick_log2(), options.override_word());
    Pictures pictures(job, samples / static_cast<std::uint64_t>(options.samples_per_tick));
    draw(job, samples, pictures);
    return publish({job, samples, nullptr}, pictures, folder);
}

}  // namespace curvecore::tb
