// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/part/word_files.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "hls/words.hpp"
#include "ref/feed/pieces/profile_words.hpp"
#include "ref/machine/path_quantum.hpp"
#include "sysc/cli/comment_text.hpp"
#include "sysc/job/made_for.hpp"

namespace curvecore::sysc {
namespace {

constexpr int kBusBits = 48;

std::string segments_head(const Job& job) {
    const int fine = job.options.core.position_bits + job.options.core.guard_bits;
    const int coef = job.options.core.coef_bits;
    std::string text = hex_head(job, "segments", kBusBits);
    text += fmt::format(
        "// {} words a segment, each a tag [47:44] and 44 bits:\n"
        "//   1    length [43:0], path quanta (2^-16 unit)\n"
        "//   2    theta [{}:0], {} fraction bits; kind [37:36]; k [42:38]; last segment [43]\n"
        "//   3 4  start, end ({} bits, {} fraction bits, units, sign-extended)\n"
        "//   5..7 tangent, normal, advance [35:0] ({} bits, {} fraction bits, sign-extended)\n"
        "// 3 .. 7 for X, Y and Z, then 3, 4 and 7 for each auxiliary axis; above the "
        "coefficients,\n"
        "// [43:36]: X sequence, lambda and other turn [42]; Y and Z four bytes of ticks, the "
        "lowest\n"
        "// first; of advance the check\n",
        job.options.core.segment_words(), coef - 1, coef - 1, fine, job.options.core.guard_bits,
        coef, coef - 2);
    if (job.options.core.splines != 0) {
        text +=
            "// of a spline, kind 1: 1/|c| for theta; a, b and c for tangent, normal, advance\n";
    }
    if (job.options.core.table) {
        text += fmt::format("// of a {}, kind 3, its rows:", job.options.core.table->name);
        for (const auto& [place, row] : job.options.core.table->bus) {
            text += fmt::format(" {} {};", place, row);
        }
        text += fmt::format("\n//   10   further, {} words, as advance\n",
                            job.options.core.further_words);
    }
    return text;
}

std::string profile_head(const Job& job) {
    return hex_head(job, "feed profile", kBusBits) +
           "// 5 words a piece of constant jerk, each a tag [47:44] and 44 bits:\n"
           "//   8       ticks [19:0], m [24:20], e [30:25], final [31], sequence [43:36]\n"
           "//   9       ds [43:0], path quanta\n"
           "//   10..12  c1 c2 c3 [35:0]: 34 fraction bits, in 2^e quanta; check [43:36]:\n"
           "//           s = 2^e (c1 tau + c2 tau^2 + c3 tau^3), tau = t / 2^m, t in ticks\n"
           "// before some of them a stop branch:\n"
           "//   13      wait [19:0], ticks to the next one; again [20]: the steps of the one "
           "before\n"
           "//   14 ..   ticks [10:0], change of the rate's slope [42:11], last [43]\n" +
           (job.options.outputs == 0
                ? ""
                : "// before those a change of outputs or more, as hls/path_outputs.hpp says:\n"
                  "//   15      way from the last one [25:0], whole units; value [37:26]; 0 bits, "
                  "1 level,\n"
                  "//           2 follow [39:38]; number [43:40]\n");
}

void append(std::string& text, const std::vector<std::uint64_t>& words) {
    for (const std::uint64_t word : words) text += fmt::format("{:012x}\n", word);
}

void keep(FileList<std::uint64_t>& kept, const std::vector<std::uint64_t>& words) {
    for (const std::uint64_t word : words) kept.push_back(word);
}

}  // namespace

std::string hex_head(const Job& job, const std::string& what, int bits) {
    return fmt::format(
        "// curvecore {} of {}: words of {} bits, one a line, for $readmemh; format {}.\n"
        "// core: {}; unit {:g} mm\n",
        what, comment_safe(std::filesystem::path(job.options.file).filename().string()), bits,
        hls::kWordsVersion, ref::parameters_text(job.options.core), job.plan.unit_mm);
}

WordFiles::WordFiles(const OutputFolder& folder, KeptWords* kept)
    : folder_(folder),
      kept_(kept),
      segments_(folder, "segments.hex"),
      profile_(folder, "profile.hex") {}

void WordFiles::add(const Job& job, const ref::Plan& part) {
    if (!writer_) {
        writer_.emplace(job.options.core, job.digest());
        pieces_ = profile_writer(job);
        segments_.write(segments_head(job));
        profile_.write(profile_head(job));
    }
    for (const ref::Segment& segment : part.segments) {
        std::string text = fmt::format("// segment {}, line {}\n", writer_->count(), segment.line);
        const std::vector<std::uint64_t> words = writer_->write(segment);
        append(text, words);
        segments_.write(text);
        if (kept_ != nullptr) keep(kept_->segments, words);
    }
    for (std::size_t i = 0; i < part.pieces.size(); ++i) {
        std::string text;
        const std::vector<std::uint64_t> words = pieces_->write(part, i);
        append(text, words);
        profile_.write(text);
        if (kept_ != nullptr) keep(kept_->profile, words);
        profile_words_ += words.size();
        for (const std::uint64_t word : words) {
            const auto tag = static_cast<hls::Tag>(hls::get(hls::kTagField, word));
            branch_words_ += tag == hls::Tag::kStop || tag == hls::Tag::kStep ? 1 : 0;
            output_words_ += tag == hls::Tag::kOutput ? 1 : 0;
        }
    }
    branches_ += part.branches.size();
    ticks_ += static_cast<std::uint64_t>(ref::ticks_of(part.pieces));
    path_ = part.segments.back().s_start + part.segments.back().length;
}

void WordFiles::close(const Job& job) {
    segments_.close();
    profile_.close();
    folder_.write("words.json", json(job).dump(2) + "\n");
}

std::uint64_t WordFiles::samples(const Job& job) const {
    return ticks_ << job.options.samples_per_tick_log2();
}

std::size_t WordFiles::segment_words(const Job& job) const {
    return writer_->count() * static_cast<std::size_t>(job.options.core.segment_words());
}

double WordFiles::path_mm(const Job& job) const {
    return static_cast<double>(path_) * ref::path_quantum_mm(job.machine, job.plan.unit_mm);
}

double WordFiles::bits_per_mm(const Job& job) const {
    const std::size_t words = segment_words(job) + profile_words_;
    return kBusBits * static_cast<double>(words) / path_mm(job);
}

nlohmann::ordered_json WordFiles::json(const Job& job) const {
    nlohmann::ordered_json json;
    json["words_version"] = hls::kWordsVersion;
    json["input"] = job.options.file;
    json["unit_mm"] = job.plan.unit_mm;
    json["sample_period_s"] = job.options.sample_period_s;
    json["clock_hz"] = job.options.clock_hz;
    json["core"] = job.core_name();
    json["parameters"] = parameters_json(job.options.core);
    json["segments"] = {{"file", "segments.hex"},
                        {"count", writer_->count()},
                        {"words", segment_words(job)},
                        {"words_each", job.options.core.segment_words()}};
    json["profile"] = {
        {"file", "profile.hex"}, {"count", pieces_->count()}, {"words_each", hls::kProfileBusWords},
        {"branches", branches_}, {"outputs", output_words_},  {"words", profile_words_}};
    json["queue_words"] = {{"segments", job.options.segment_queue_words},
                           {"profile", job.options.profile_queue_words}};
    // Ports of motion_interpolator, and the register DIGEST of motion_system
    const MadeFor words = made_for(job.options, job.machine);
    json["digest"] = words.digest();
    json["digest_register"] = words.host;
    json["samples_per_tick_log2"] = job.options.samples_per_tick_log2();
    json["hold_acceleration"] = job.plan.hold_acceleration;
    json["hold_slope"] = std::uint64_t(job.plan.hold_acceleration) * job.plan.hold_slope_steps;
    json["stop_ticks"] = job.plan.stop_ticks;
    json["samples"] = samples(job);
    json["path_quanta"] = path_;
    json["bits_per_mm"] = bits_per_mm(job);
    return json;
}

std::string WordFiles::summary(const Job& job) const {
    const std::size_t segments = segment_words(job);
    const std::size_t plain = pieces_->count() * hls::kProfileBusWords;
    std::string text =
        fmt::format("segments  {} in {} words of {} bits\nprofile   {} pieces in {} words",
                    writer_->count(), segments, kBusBits, pieces_->count(), plain);
    if (branches_ > 0) {
        text += fmt::format(
            ", and {} stop branches in {}: --holds bounds sends none, a hold takes longer then",
            branches_, branch_words_);
    }
    if (output_words_ > 0) {
        text += fmt::format(", and {} words of outputs", output_words_);
    }
    return text + fmt::format(
                      "\ntraffic   {} words, {:.0f} bits/mm of {:.6g} mm\n"
                      "samples   {}\nwords     {}/words.json\n",
                      segments + profile_words_, bits_per_mm(job), path_mm(job), samples(job),
                      job.options.folder);
}

}  // namespace curvecore::sysc
