// SPDX-License-Identifier: Apache-2.0
// `curvecore words`: memory files that $readmemh reads, and what a test bench needs besides.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "sysc/curvecore/commands.hpp"
#include "sysc/curvecore/output_folder.hpp"
#include "sysc/curvecore/planned_job.hpp"
#include "sysc/host/bus_words.hpp"
#include "sysc/host/job.hpp"
#include "sysc/host/path_source.hpp"
#include "sysc/watch/report.hpp"

namespace curvecore::sysc {
namespace {

/// "a.ngc" may hold a line break that would end a comment.
std::string comment_safe(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < ' ') c = '?';
    }
    return text;
}

std::string head(const Job& job, const char* what, std::size_t words) {
    return fmt::format(
        "// curvecore {} of {}: {} words of 48 bits, one a line, for $readmemh; format {}.\n"
        "// core: {}; unit {:g} mm\n",
        what, comment_safe(std::filesystem::path(job.options.file).filename().string()), words,
        hls::kWordsVersion, ref::parameters_text(job.options.core), job.plan.unit_mm);
}

std::string segments_hex(const Job& job) {
    const ref::Plan& plan = job.plan;
    const int each = ref::segment_bus_words(job.options.core.aux_axes);
    const int fine = job.options.core.position_bits + job.options.core.guard_bits;
    const int coef = job.options.core.coef_bits;
    std::string text = head(job, "segments", plan.segments.size() * static_cast<std::size_t>(each));
    text += fmt::format(
        "// {} words a segment, each a tag [47:44] and 44 bits:\n"
        "//   1    length [43:0], path quanta (2^-16 unit)\n"
        "//   2    theta [{}:0], {} fraction bits; kind [37:36]; k [42:38]; last segment [43]\n"
        "//   3 4  start, end ({} bits, {} fraction bits, units, sign-extended)\n"
        "//   5..7 tangent, normal, advance [35:0] ({} bits, {} fraction bits, sign-extended)\n"
        "// 3 .. 7 for X, Y and Z, then 3, 4 and 7 for each auxiliary axis; above the "
        "coefficients,\n"
        "// [43:36]: X sequence, lambda; Y and Z four bytes of ticks, the lowest first\n",
        each, coef - 1, coef - 1, fine, job.options.core.guard_bits, coef, coef - 2);
    if (job.options.core.splines != 0) {
        text +=
            "// of a spline, kind 1: 1/|c| for theta; a, b and c for tangent, normal, advance\n";
    }
    for (std::size_t i = 0; i < plan.segments.size(); ++i) {
        const ref::Segment& segment = plan.segments[i];
        text += fmt::format("// segment {}, line {}\n", i, segment.line);
        for (const std::uint64_t word : segment_bus_words(segment, i, job.options.core)) {
            text += fmt::format("{:012x}\n", word);
        }
    }
    return text;
}

std::string profile_hex(const Job& job) {
    std::string text = head(job, "feed profile", job.plan.pieces.size() * hls::kProfileBusWords);
    text +=
        "// 5 words a piece of constant jerk, each a tag [47:44] and 44 bits:\n"
        "//   8       ticks [19:0], m [24:20], e [30:25], final [31], sequence [39:32]\n"
        "//   9       ds [43:0], path quanta\n"
        "//   10..12  c1 c2 c3 [35:0]: 34 fraction bits, in 2^e quanta:\n"
        "//           s = 2^e (c1 tau + c2 tau^2 + c3 tau^3), tau = t / 2^m, t in ticks\n";
    for (std::size_t i = 0; i < job.plan.pieces.size(); ++i) {
        for (const std::uint64_t word : profile_bus_words(job.plan.pieces[i], i)) {
            text += fmt::format("{:012x}\n", word);
        }
    }
    return text;
}

std::string words_json(const Job& job, std::uint64_t samples) {
    nlohmann::ordered_json json;
    json["words_version"] = hls::kWordsVersion;
    json["input"] = job.options.file;
    json["unit_mm"] = job.plan.unit_mm;
    json["sample_period_s"] = job.options.sample_period_s;
    json["core"] = job.core_name();
    json["parameters"] = parameters_json(job.options.core);
    json["segments"] = {{"file", "segments.hex"},
                        {"count", job.plan.segments.size()},
                        {"words_each", ref::segment_bus_words(job.options.core.aux_axes)}};
    json["profile"] = {{"file", "profile.hex"},
                       {"count", job.plan.pieces.size()},
                       {"words_each", hls::kProfileBusWords}};
    // Ports of motion_interpolator
    json["samples_per_tick_log2"] = job.options.samples_per_tick_log2();
    json["hold_acceleration"] = job.plan.hold_acceleration;
    json["hold_slope"] = std::uint64_t(job.plan.hold_acceleration) * job.plan.hold_slope_steps;
    json["stop_ticks"] = job.plan.stop_ticks;
    json["samples"] = samples;
    json["path_quanta"] = job.path_length();
    return json.dump(2) + "\n";
}

}  // namespace

int words_command(const Options& options) {
    Job job = read_job(options);
    plan_and_check(job);
    OutputFolder folder(options.folder);
    const std::uint64_t samples =
        count_samples(job.plan, options.samples_per_tick_log2(), options.override_word());
    folder.write("segments.hex", segments_hex(job));
    folder.write("profile.hex", profile_hex(job));
    folder.write("words.json", words_json(job, samples));
    folder.commit();
    if (!options.quiet) {
        print_warnings(job);
        fmt::print("{} segments, {} profile pieces, {} samples -> {}\n", job.plan.segments.size(),
                   job.plan.pieces.size(), samples, options.folder);
    }
    return 0;
}

}  // namespace curvecore::sysc
