// SPDX-License-Identifier: Apache-2.0
// `curvecore words`: memory files that $readmemh reads, and what a test bench needs besides.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tb/program/bus_words.hpp"
#include "tb/program/commands.hpp"
#include "tb/program/job.hpp"
#include "tb/program/output_folder.hpp"
#include "tb/program/path_source.hpp"
#include "tb/program/report.hpp"

namespace curvecore::tb {
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
        "// curvecore {} of {}: {} words of 48 bits, one a line, for $readmemh.\n"
        "// core: {}; unit {:g} mm\n",
        what, comment_safe(std::filesystem::path(job.options.file).filename().string()), words,
        job.options.core.text(), job.plan.unit_mm);
}

std::string segments_hex(const Job& job) {
    const ref::Plan& plan = job.plan;
    const int each = 17 + 3 * job.options.core.aux_axes;
    const int fine = job.options.core.position_bits + job.options.core.guard_bits;
    const int coef = job.options.core.coef_bits;
    std::string text = head(job, "segments", plan.segments.size() * static_cast<std::size_t>(each));
    text += fmt::format(
        "// {} words a segment, sign-extended to 48 bits:\n"
        "//   0       length, path quanta (2^-16 unit)\n"
        "//   1       theta [{}:0], {} fraction bits; step exponent k [40:36]\n"
        "//   2..16   X, Y, Z: start, end ({} bits, {} fraction bits, units), then tangent,\n"
        "//           normal, advance ({} bits, {} fraction bits)\n",
        each, coef - 1, coef - 1, fine, job.options.core.guard_bits, coef, coef - 2);
    if (job.options.core.splines != 0) {
        text +=
            "// of a spline, bit 47 of word 1: 1/|c| for theta, lambda in [46:41], a, b and c for\n"
            "// tangent, normal and advance\n";
    }
    if (each > 17) text += "//   17..    each auxiliary axis: start, end, advance\n";
    for (std::size_t i = 0; i < plan.segments.size(); ++i) {
        const ref::Segment& segment = plan.segments[i];
        text += fmt::format("// segment {}, line {}\n", i, job.program.moves[segment.move].line);
        for (const std::uint64_t word : segment_bus_words(segment, job.options.core)) {
            text += fmt::format("{:012x}\n", word);
        }
    }
    return text;
}

std::string profile_hex(const Job& job) {
    std::string text = head(job, "feed profile", job.plan.pieces.size() * hls::kProfileBusWords);
    text +=
        "// 5 words a piece of constant jerk:\n"
        "//   0       ticks [19:0], m [24:20], e [30:25], final [31]\n"
        "//   1       ds, path quanta\n"
        "//   2..4    c1 c2 c3: 36 bits, 34 fraction bits, sign-extended, in 2^e quanta:\n"
        "//           s = 2^e (c1 tau + c2 tau^2 + c3 tau^3), tau = t / 2^m, t in ticks\n";
    for (const ref::ProfilePiece& piece : job.plan.pieces) {
        for (const std::uint64_t word : profile_bus_words(piece)) {
            text += fmt::format("{:012x}\n", word);
        }
    }
    return text;
}

std::string words_json(const Job& job, std::uint64_t samples) {
    nlohmann::ordered_json json;
    json["input"] = job.options.file;
    json["unit_mm"] = job.plan.unit_mm;
    json["sample_period_s"] = job.options.sample_period_s;
    json["core"] = job.core_name();
    json["parameters"] = job.options.core.json();
    json["segments"] = {{"file", "segments.hex"},
                        {"count", job.plan.segments.size()},
                        {"words_each", 17 + 3 * job.options.core.aux_axes}};
    json["profile"] = {{"file", "profile.hex"},
                       {"count", job.plan.pieces.size()},
                       {"words_each", hls::kProfileBusWords}};
    // Ports of motion_interpolator
    json["samples_per_tick_log2"] = job.options.samples_per_tick_log2();
    json["hold_acceleration"] = job.plan.hold_acceleration;
    json["hold_slope"] = std::uint64_t(job.plan.hold_acceleration) * job.plan.hold_slope_steps;
    json["stop_ticks"] = stop_ticks(job.plan);
    json["samples"] = samples;
    json["path_quanta"] = job.path_length();
    return json.dump(2) + "\n";
}

}  // namespace

int words_command(const Options& options) {
    Job job = read_job(options);
    plan_job(job);
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

}  // namespace curvecore::tb
