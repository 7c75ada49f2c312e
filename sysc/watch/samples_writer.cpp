// SPDX-License-Identifier: Apache-2.0
#include "sysc/watch/samples_writer.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "sysc/cli/comment_text.hpp"

namespace curvecore::sysc {
namespace {

constexpr std::size_t kBuffer = std::size_t(1) << 20;
constexpr std::size_t kLongestRow = 16 * 21;

}  // namespace

SamplesWriter::SamplesWriter(const std::string& file, const Job& job, std::uint64_t samples,
                             TakeSample also)
    : file_(std::fopen(file.c_str(), "wb"), &std::fclose),
      axes_(3 + job.plan.aux_axes),
      samples_(samples),
      stride_(1 + samples / job.options.most_rows),
      also_(std::move(also)) {
    if (!file_) throw std::runtime_error("cannot write " + file);
    buffer_.reserve(kBuffer + kLongestRow);
    buffer_ = fmt::format(
        "# curvecore: samples of {} as the board gave them\n"
        "# core: {}\n"
        "# k, segment: numbers from 0; rows: every {} samples of {:g} s, and the last\n"
        "# s: path length in 2^-16 units; x, y, z and other axes: in units of {:g} mm\n"
        "# numpy.genfromtxt(file, delimiter=',', names=True, skip_header=5)\n"
        "k,segment,s,x,y,z",
        comment_safe(std::filesystem::path(job.options.file).filename().string()),
        ref::parameters_text(job.options.core), stride_, job.options.sample_period_s,
        job.plan.unit_mm);
    for (const char name : ref::kAxisNames.substr(3, std::size_t(job.plan.aux_axes))) {
        buffer_ += ',';
        buffer_ += name;
    }
    buffer_ += '\n';
}

void SamplesWriter::row(std::uint64_t k, std::size_t segment, std::uint64_t s,
                        const std::int64_t* position) {
    if (also_) also_(segment, position);
    if (k % stride_ == 0 || k == samples_) append(k, segment, s, position);
}

void SamplesWriter::append(std::uint64_t k, std::size_t segment, std::uint64_t s,
                           const std::int64_t* position) {
    const auto number = [this](auto value) {
        const fmt::format_int text(value);
        buffer_.append(text.data(), text.size());
    };
    number(k);
    buffer_ += ',';
    number(segment);
    buffer_ += ',';
    number(s);
    for (int axis = 0; axis < axes_; ++axis) {
        buffer_ += ',';
        number(position[axis]);
    }
    buffer_ += '\n';
    if (buffer_.size() >= kBuffer) flush();
}

void SamplesWriter::flush() {
    if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size()) {
        throw std::runtime_error("cannot write samples.csv: is the disk full?");
    }
    buffer_.clear();
}

void SamplesWriter::close() {
    flush();
    if (std::fclose(file_.release()) != 0) {
        throw std::runtime_error("cannot write samples.csv: is the disk full?");
    }
}

}  // namespace curvecore::sysc
