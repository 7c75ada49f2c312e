// SPDX-License-Identifier: Apache-2.0
// Words of a job as memory files: segments.hex, profile.hex, and words.json.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "sysc/commands/terminal/output_folder.hpp"
#include "sysc/job/job.hpp"
#include "sysc/words/bus_words.hpp"
#include "sysc/words/file_list.hpp"

namespace curvecore::sysc {

/// Returns the remark at the head of a memory file: what its words are, how wide, of which core.
std::string hex_head(const Job& job, const std::string& what, int bits);

/// The words of both files.
struct KeptWords {
    FileList<std::uint64_t> segments;
    FileList<std::uint64_t> profile;
};

/// The files, part by part.
class WordFiles {
  public:
    /// @param kept gets the words, too; null: nobody wants them
    explicit WordFiles(const OutputFolder& folder, KeptWords* kept = nullptr);

    void add(const Job& job, const ref::Plan& part);
    /// Completes the files, with words.json. @throws std::runtime_error: the disk is full
    void close(const Job& job);

    std::string summary(const Job& job) const;
    /// The content of words.json.
    nlohmann::ordered_json json(const Job& job) const;
    bool empty() const { return !writer_; }

  private:
    std::size_t segment_words(const Job& job) const;
    std::uint64_t samples(const Job& job) const;
    double path_mm(const Job& job) const;
    /// Bits of both streams for each mm of path.
    double bits_per_mm(const Job& job) const;

    const OutputFolder& folder_;
    KeptWords* kept_;
    OutputFile segments_;
    OutputFile profile_;
    std::optional<SegmentWriter> writer_;
    std::optional<ProfileWriter> pieces_;
    std::size_t branches_ = 0;
    std::size_t profile_words_ = 0;
    std::size_t branch_words_ = 0;
    std::size_t output_words_ = 0;
    std::uint64_t ticks_ = 0;
    std::uint64_t path_ = 0;
};

}  // namespace curvecore::sysc
