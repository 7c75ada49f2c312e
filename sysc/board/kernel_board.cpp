// SPDX-License-Identifier: Apache-2.0
#include "sysc/board/kernel_board.hpp"

#include <algorithm>

namespace curvecore::sysc {

KernelBoard::KernelBoard(const CoreParameters& core, const BoardSettings& settings,
                         const QueueDepths& depths)
    : core_(core),
      target_(settings.override_word),
      segment_words_(static_cast<std::size_t>(core.segment_words())),
      segments_{static_cast<std::size_t>(depths.segments), {}},
      profile_{static_cast<std::size_t>(depths.profile), {}},
      scaler_(settings.hold_acceleration, static_cast<std::int64_t>(settings.hold_slope)),
      share_(settings.samples_per_tick_log2),
      format_(core, core.axes()),
      kernel_(format_) {}

std::size_t KernelBoard::write(Stream stream, const std::uint64_t* words, std::size_t count) {
    Queue& queue = this->queue(stream);
    const std::size_t taken = std::min(count, queue.depth - queue.words.size());
    queue.words.insert(queue.words.end(), words, words + taken);
    return taken;
}

bool KernelBoard::full(Stream stream) const {
    return stream == Stream::kSegments ? segments_.full() : profile_.full();
}

void KernelBoard::work(std::vector<Sample>& samples) {
    moving_ = moving_ || move();
    if (!moving_ || !cover()) return;
    draw(samples.emplace_back());
    moving_ = false;
}

bool KernelBoard::move() {
    if (requested_ == 0) return false;
    if (share_.needs_tick()) {
        // A tick may end the present piece and begin the next one.
        if (!final_ && !piece_queued()) return false;
        rate_ = stops_.tick(scaler_, target_, path_.idle());
        const auto next = [this](hls::ProfileWords& words) { return next_piece(words); };
        share_.tick(path_.tick(rate_, next, target_ == 0));
    }
    ds_ = share_.sample();
    --requested_;
    return true;
}

bool KernelBoard::piece_queued() {
    while (!profile_.words.empty()) {
        const std::uint64_t word = profile_.words.front();
        const auto tag = static_cast<hls::Tag>(hls::get(hls::kTagField, word));
        if (tag == hls::Tag::kStop) {
            stops_.load_wait(static_cast<std::int32_t>(hls::get(hls::kStopWaitField, word)),
                             hls::get(hls::kStopAgainField, word) != 0);
        } else if (tag == hls::Tag::kStep) {
            stops_.load_step(hls::unpack_step(word));
        } else {
            break;
        }
        profile_.pop();
    }
    return profile_.words.size() >= hls::kProfileBusWords;
}

bool KernelBoard::next_piece(hls::ProfileWords& words) {
    if (!piece_queued()) return false;
    words = hls::unpack_piece([this] { return profile_.pop(); });
    stops_.begin_piece(!path_.active());
    final_ = words.final;
    return true;
}

bool KernelBoard::cover() {
    const std::uint64_t reach = walked_ + static_cast<std::uint64_t>(ds_);
    while (covered_ == 0 || covered_ < reach) {
        if (segments_.words.size() < segment_words_) return false;
        ahead_.push_back(hls::unpack_segment([this] { return segments_.pop(); }, format_));
        covered_ += static_cast<std::uint64_t>(ahead_.back().length);
        empty_segments_ += ahead_.back().length == 0;
    }
    return true;
}

void KernelBoard::draw(Sample& sample) {
    kernel_.sample(
        ds_,
        [this] {
            const RunSegment segment = ahead_.front();
            ahead_.pop_front();
            return segment;
        },
        sample.fine.data());
    walked_ += static_cast<std::uint64_t>(ds_);
    sample.ds = ds_;
    sample.rate = rate_;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(core_.axes()); ++axis) {
        sample.position[axis] = hls::to_position(sample.fine[axis], format_);
    }
}

BoardStatus KernelBoard::status() const {
    BoardStatus status;
    status.empty_segments = empty_segments_;
    return status;
}

}  // namespace curvecore::sysc
