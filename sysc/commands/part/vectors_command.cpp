// SPDX-License-Identifier: Apache-2.0
// `curvecore vectors`: what goes into a core and what has to come out, for a bench of one's own.
#include <fmt/format.h>

#include "sysc/board/kernel_drawing.hpp"
#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/progress_bar.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/commands/options/part_options.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/part/commands.hpp"
#include "sysc/commands/part/word_files.hpp"
#include "sysc/commands/terminal/device_clock.hpp"
#include "sysc/commands/terminal/json_result.hpp"
#include "sysc/commands/terminal/summary.hpp"
#include "sysc/curves/word_check.hpp"
#include "sysc/formats/npz_file.hpp"
#include "sysc/job/job_stream.hpp"
#include "sysc/report/report.hpp"

namespace curvecore::sysc {
namespace {

using Axes = std::array<std::int64_t, kBoardAxes>;

constexpr std::uint64_t kAtOnce = 4096;  // samples without a look at the clock

/// The axes as a word of hexadecimal digits, axis 0 in the low bits.
std::string packed(const Axes& values, int axes, int bits) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string digits(static_cast<std::size_t>((axes * bits + 3) / 4), '0');
    for (std::size_t at = 0; at < digits.size(); ++at) {
        unsigned digit = 0;
        for (int i = 0; i < 4; ++i) {
            const int bit = static_cast<int>(at) * 4 + i;
            if (bit >= axes * bits) break;
            const std::int64_t value = values[static_cast<std::size_t>(bit / bits)];
            digit |= static_cast<unsigned>(value >> bit % bits & 1) << i;
        }
        digits[digits.size() - 1 - at] = kDigits[digit];
    }
    return digits;
}

/// Samples as a core puts them out: in hexadecimal at once, kept for the arrays.
class SampleFiles {
  public:
    SampleFiles(const Job& job, const OutputFolder& folder)
        : axes_(job.options.core.axes()),
          position_bits_(job.options.core.position_bits),
          fine_bits_(position_bits_ + job.options.core.guard_bits),
          start_(start_of(job)),
          position_(folder, "positions.hex"),
          fine_(folder, "fine.hex"),
          path_(folder, "path.hex") {
        position_.write(axes_head(job, "sample_position_o", start_.position, position_bits_, 0));
        fine_.write(
            axes_head(job, "sample_fine_o", start_.fine, fine_bits_, job.options.core.guard_bits));
        path_.write(hex_head(job, "path_ds_o", kPathBits) +
                    "// the way of each sample along the path, 2^-16 units\n");
    }

    void take(const Sample& sample) {
        position_.write(packed(sample.position, axes_, position_bits_) + "\n");
        fine_.write(packed(sample.fine, axes_, fine_bits_) + "\n");
        path_.write(fmt::format("{:012x}\n", sample.ds));
        ds_.push_back(sample.ds);
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes_); ++axis) {
            positions_.push_back(sample.position[axis]);
            fines_.push_back(sample.fine[axis]);
        }
    }

    void close(NpzFile& arrays) {
        for (OutputFile* file : {&position_, &fine_, &path_}) file->close();
        const auto axes = static_cast<std::size_t>(axes_);
        arrays.add("start", {axes}, start_.position);
        arrays.add("position", {ds_.size(), axes}, positions_);
        arrays.add("fine", {ds_.size(), axes}, fines_);
        arrays.add("ds", {ds_.size()}, ds_);
    }

  private:
    static constexpr int kPathBits = 48;

    std::string axes_head(const Job& job, const char* port, const Axes& start, int bits,
                          int fraction) const {
        std::string text = hex_head(job, port, axes_ * bits) + "//";
        int low = 0;
        for (const std::string& name : axis_names(job)) {
            text += fmt::format(" {} [{}:{}]", name, low + bits - 1, low);
            low += bits;
        }
        text += fmt::format(
            ": signed, {} fraction bits, units; a word a sample\n"
            "// before the first sample the axes stand at",
            fraction);
        for (int axis = 0; axis < axes_; ++axis) {
            text += fmt::format(" {}", start[static_cast<std::size_t>(axis)]);
        }
        return text + "\n";
    }

    int axes_;
    int position_bits_;
    int fine_bits_;
    Sample start_;
    OutputFile position_;
    OutputFile fine_;
    OutputFile path_;
    FileList<std::int64_t> positions_;
    FileList<std::int64_t> fines_;
    FileList<std::int64_t> ds_;
};

void check_size(const Job& job, std::uint64_t samples, std::size_t words) {
    const auto axes = static_cast<std::uint64_t>(job.options.core.axes());
    if (8 * (samples * (2 * axes + 1) + words) < NpzFile::kMostBytes) return;
    throw UsageError(
        fmt::format("vectors.npz: {} samples are more than 4 GiB: take a part of the program, or a "
                    "longer --sample-period",
                    samples));
}

int vectors_command(PartOptions& asked) {
    Options options = asked.complete();
    hold_input(options);
    JobStream stream(options);
    take_device(stream.options());
    const InterruptGuard guard;
    OutputFolder folder(options.folder);
    KeptWords words;
    WordFiles files(folder, &words);
    const Job job = stream.all([&files](const Job& of, const ref::Plan& part) {
        check_words(of, part);
        files.add(of, part);
        InterruptGuard::check();
    });
    files.close(job);
    const std::uint64_t count = count_samples(job);
    check_size(job, count, words.segments.size() + words.profile.size());

    SampleFiles samples(job, folder);
    std::uint64_t drawn = 0;
    {
        ProgressBar bar(count, options.quiet);
        draw_by_kernel(job, count, [&](const Sample& sample) {
            samples.take(sample);
            if (++drawn % kAtOnce != 0) return;
            bar.update(drawn);
            InterruptGuard::check();
        });
    }
    NpzFile arrays(folder.path("vectors.npz"));
    arrays.add("segments", {words.segments.size()}, words.segments);
    arrays.add("profile", {words.profile.size()}, words.profile);
    samples.close(arrays);
    arrays.close();
    folder.commit();
    if (options.json) {
        print_json(files.json(job));
    } else if (!options.quiet) {
        fmt::print("{}arrays    {}/vectors.npz\n", files.summary(job), options.folder);
    }
    print_warnings(job);
    return 0;
}

}  // namespace

void add_vectors(CLI::App& app, int& status) {
    auto [command, part] = add_command(
        app, status, "vectors",
        "words, and the positions that the kernel draws of them, for a bench of a core of yours: "
        ".hex for $readmemh, .npz for numpy",
        vectors_command);
    add_common(command, part);
}

}  // namespace curvecore::sysc
