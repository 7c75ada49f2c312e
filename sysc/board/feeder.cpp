// SPDX-License-Identifier: Apache-2.0
#include "sysc/board/feeder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "hls/words.hpp"
#include "sysc/board/faults.hpp"
#include "sysc/job/made_for.hpp"
#include "sysc/words/path_source.hpp"

namespace curvecore::sysc {

BoardSettings board_settings(const Job& job) {
    const ref::PlanFrame& plan = job.plan;
    const MadeFor words = made_for(job.options, job.machine);
    BoardSettings settings;
    settings.samples_per_tick_log2 = job.options.samples_per_tick_log2();
    settings.override_word = job.options.override_word();
    settings.hold_acceleration = plan.hold_acceleration;
    settings.hold_slope = std::uint64_t(plan.hold_acceleration) * plan.hold_slope_steps;
    settings.stop_ticks = plan.stop_ticks;
    settings.digest = words.digest();
    settings.host_digest = words.host;
    return settings;
}

Feeder::Feeder(const Job& job, std::uint64_t samples, Board& board)
    : job_(job), board_(board), samples_(samples), segment_words_(job.options.core, job.digest()) {}

void Feeder::turn(std::vector<Sample>& samples) {
    write_segments();
    write_profile();
    std::uint64_t covered = std::min(this->covered(), samples_);
    // A timer does not stop once it has begun: the host must keep up with it.
    if (board_.paced() && covered > 0) covered = samples_;
    if (covered > requested_) {
        board_.request(covered - requested_);
        requested_ = covered;
    }
    const std::size_t before = samples.size();
    board_.work(samples);
    const std::size_t came = samples.size() - before;
    received_ += came;
    for (std::size_t k = before; k < samples.size(); ++k) {
        walked_ += static_cast<std::uint64_t>(samples[k].rate);
    }
    waited_ = came > 0 ? 0 : waited_ + 1;
    const std::uint64_t patience = board_.paced() ? kPatience : kPatienceOfACore;
    if (waited_ > patience) {
        throw BoardError(fmt::format("the board gave no sample for {} million turns; faults: {}",
                                     patience / 1'000'000, fault_text(board_.status().fault)));
    }
}

void Feeder::write_segments() {
    const FileList<ref::Segment>& segments = job_.plan.segments;
    while (segments_.send(board_, segment_words_.count() == segments.size()) &&
           segment_words_.count() < segments.size()) {
        const ref::Segment& segment = segments[segment_words_.count()];
        segments_.load(segment_words_.write(segment), segment.ticks);
    }
}

void Feeder::write_profile() {
    const FileList<ref::ProfilePiece>& pieces = job_.plan.pieces;
    while (profile_.send(board_, next_piece_ == pieces.size()) && next_piece_ < pieces.size()) {
        const auto [words, count] = job_.plan.words_of(next_piece_);
        profile_.load({words, words + count}, pieces[next_piece_].ticks);
        ++next_piece_;
    }
}

bool Feeder::Outbox::send(Board& board, bool last) {
    if (sent_ < words_.size()) {
        sent_ += board.write(stream_, &words_[sent_], words_.size() - sent_);
    }
    if (sent_ < words_.size() || !board.arrived(stream_)) return false;
    ticks_ += loaded_ticks_;
    loaded_ticks_ = 0;
    complete_ = last;
    return true;
}

void Feeder::Outbox::load(std::vector<std::uint64_t> words, std::uint32_t ticks) {
    words_ = std::move(words);
    loaded_ticks_ = ticks;
    sent_ = 0;
}

std::uint64_t Feeder::covered(const Outbox& outbox, Stream stream) const {
    if (outbox.complete()) return samples_;
    const std::int64_t stops = board_.full(stream) ? 1 : 2;
    const std::int64_t reserve = stops * job_.plan.stop_ticks + kOnTheWay;
    const std::int64_t ticks = std::max<std::int64_t>(outbox.ticks() - reserve, 0);
    const std::uint64_t samples = static_cast<std::uint64_t>(ticks)
                                  << job_.options.samples_per_tick_log2();
    const std::uint64_t walked = walked_ >> hls::kRateFrac;
    return received_ + (samples > walked ? samples - walked : 0);
}

std::uint64_t Feeder::covered() const {
    return std::min(covered(segments_, Stream::kSegments), covered(profile_, Stream::kProfile));
}

}  // namespace curvecore::sysc
