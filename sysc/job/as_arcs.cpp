// SPDX-License-Identifier: Apache-2.0
#include "sysc/job/as_arcs.hpp"

#include "ref/feed/stops/planned_branches.hpp"
#include "ref/format/path_words.hpp"
#include "ref/text/input_error.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/job/job_stream.hpp"

namespace curvecore::sysc {
namespace {

FormCost cost_of(const char* form, JobStream& stream) {
    FormCost cost;
    cost.form = form;
    while (const ref::Plan* part = stream.next()) {
        cost.segments += part->segments.size();
        cost.words += stream.job().options.core.segment_words() * part->segments.size() +
                      ref::profile_words(*part);
        cost.duration_s += part->duration_s;
    }
    cost.moves = stream.moves();
    return cost;
}

std::optional<FormCost> cost_of(const char* name, const Options& options, ref::SplineForm form) {
    try {
        JobStream stream(options, form);
        return cost_of(name, stream);
    } catch (const ref::InputError&) {
        return std::nullopt;
    } catch (const UsageError&) {
        return std::nullopt;
    }
}

}  // namespace

void add_other_forms(Job& job) {
    if (job.is_smooth() && job.smoothed->moves <= kMostBeside) {
        Options exact = job.options;
        exact.exact_path = true;
        job.exact = cost_of("exact path", exact, ref::SplineForm::kSpline);
    }
    if (!job.as_arcs) return;
    std::vector<FormCost>& costs = job.as_arcs->costs;
    costs.push_back({"arcs", job.plan.moves.size(), job.plan.segments.size(), job.words(),
                     job.plan.duration_s});
    Options with_splines = job.options;
    with_splines.core.splines = 1;
    if (ref::legal(with_splines.core)) {
        const auto splines = cost_of("splines", with_splines, ref::SplineForm::kSpline);
        if (splines) costs.push_back(*splines);
    }
    const auto chords = cost_of("chords", job.options, ref::SplineForm::kChords);
    if (chords) costs.push_back(*chords);
}

}  // namespace curvecore::sysc
