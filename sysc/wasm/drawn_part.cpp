// SPDX-License-Identifier: Apache-2.0
#include "sysc/wasm/drawn_part.hpp"

#include <fmt/format.h>

#include "sysc/board/kernel_drawing.hpp"
#include "sysc/cli/html_page.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/commands/options/part_options.hpp"
#include "sysc/report/report_html.hpp"
#include "sysc/wasm/chords.hpp"
#include "sysc/watch/checker.hpp"

namespace curvecore::sysc {
namespace {

/// Samples of a part at most: of an hour at a sample each millisecond.
constexpr double kMostSamples = 3.6e6;

Options read_options(std::vector<std::string> arguments) {
    Options options =
        read_part_options(std::move(arguments), [](CLI::App& plan, PartOptions& part) {
            add_report(plan, part);
            add_drawing(plan, part);
        });
    options.threads = 1;
    return options;
}

nlohmann::ordered_json point(const ref::Vec3& of) { return {of.x(), of.y(), of.z()}; }

/// Words that the plan sends, and chords for as many bits.
nlohmann::ordered_json traffic_json(const Job& job) {
    const Chords chords = chords_of_equal_traffic(job);
    nlohmann::ordered_json json;
    const std::size_t of_segments =
        job.plan.segments.size() * static_cast<std::size_t>(job.options.core.segment_words());
    json["segments"] = job.plan.segments.size();
    json["segment_words"] = of_segments;
    json["profile_words"] = job.words() - of_segments;
    json["bits"] = chords.bits;
    json["chord_bits"] = kChordBits;
    json["chords"] = chords.count();
    json["chords_off_mm"] = chords.off_mm;
    json["worst_chord"] = chords.worst;
    for (const ref::Vec3& place : chords.beside) json["beside"].push_back(point(place));
    for (const ref::Vec3& corner : chords.corners) json["corners"].push_back(point(corner));
    return json;
}

}  // namespace

DrawnPart draw_part(std::vector<std::string> arguments) {
    const Job job = plan_job(read_options(std::move(arguments)));
    if (job.plan.duration_s / job.options.sample_period_s > kMostSamples) {
        throw UsageError(
            fmt::format("the part lasts {:.0f} s: {:.0f} samples are drawn at most, "
                        "a longer --sample-period may do",
                        job.plan.duration_s, kMostSamples));
    }
    const std::uint64_t samples = count_samples(job);
    Pictures pictures(job, samples / static_cast<std::uint64_t>(job.options.samples_per_tick));
    SamplesWriter writer("samples.csv", job, samples);
    Checker checker(job, writer, pictures);
    const BoardStatus status =
        draw_by_kernel(job, samples, [&](const Sample& sample) { checker.take(sample); });
    writer.close();
    const BoardResult drawn{checker.result(), status, 0, 0, std::nullopt};
    const Report report{job, samples, drawn.check.drawn, &drawn, std::nullopt};
    const std::string data = report_data(report, pictures);
    nlohmann::ordered_json more;
    more["bound"] = job.bound();
    more["worst"] = drawn.check.worst(&KindResult::error);
    more["unit_mm"] = job.plan.unit_mm;
    more["samples"] = samples;
    more["traffic"] = traffic_json(job);
    std::string json = data.substr(0, data.size() - 1) + "," + page_json(more).substr(1);
    return {std::move(json), report_html(report, pictures)};
}

}  // namespace curvecore::sysc
