// SPDX-License-Identifier: Apache-2.0
#include "sysc/board/kernel_board.hpp"

#include <algorithm>

namespace curvecore::sysc {
namespace {

using hls::get;

/// The low `bits` of a bus word, as a signed value.
std::int64_t signed_bits(std::uint64_t word, int bits) {
    return wrapped(static_cast<std::int64_t>(word), bits);
}

/// hls::pack of a segment, undone.
template <class Word>
RunSegment unpack_segment(Word&& next, const CoreParameters& format, int axes) {
    const int fine = format.position_bits + format.guard_bits;
    RunSegment segment;
    segment.length = static_cast<std::int64_t>(get(hls::kLengthField, next()));
    const std::uint64_t head = next();
    segment.theta = signed_bits(head, format.coef_bits);
    segment.step_exponent = static_cast<int>(get(hls::kStepExponentField, head));
    segment.spline = get(hls::kKindField, head) != 0;
    for (int axis = 0; axis < axes; ++axis) {
        segment.start[axis] = signed_bits(next(), fine);
        segment.end[axis] = signed_bits(next(), fine);
        if (axis < 3) {
            segment.tangent[axis] = signed_bits(next(), format.coef_bits);
            const std::uint64_t normal = next();
            segment.normal[axis] = signed_bits(normal, format.coef_bits);
            if (axis == 0) segment.lambda = static_cast<int>(get(hls::kLambdaField, normal));
        }
        segment.advance[axis] = signed_bits(next(), format.coef_bits);
    }
    return segment;
}

/// hls::pack of a profile piece, undone.
template <class Word>
hls::ProfileWords unpack_piece(Word&& next) {
    hls::ProfileWords piece;
    const std::uint64_t head = next();
    piece.ticks = static_cast<std::int32_t>(get(hls::kPieceTicksField, head));
    piece.time_exponent = static_cast<int>(get(hls::kTimeExponentField, head));
    piece.exponent = static_cast<int>(get(hls::kExponentField, head));
    piece.final = get(hls::kFinalField, head) != 0;
    piece.ds = static_cast<std::int64_t>(get(hls::kLengthField, next()));
    for (auto& c : piece.c) c = signed_bits(next(), hls::kProfileBits);
    return piece;
}

}  // namespace

KernelBoard::KernelBoard(const CoreParameters& core, const BoardSettings& settings)
    : core_(core),
      target_(settings.override_word),
      segment_words_(static_cast<std::size_t>(ref::segment_bus_words(core.aux_axes))),
      scaler_(settings.hold_acceleration, static_cast<std::int64_t>(settings.hold_slope)),
      share_(settings.samples_per_tick_log2),
      ranges_(core.coef_bits),
      kernel_(core, core.axes(), ranges_) {}

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
        if (!final_ && profile_.words.size() < hls::kProfileBusWords) return false;
        rate_ = scaler_.tick(target_);
        const auto next = [this](hls::ProfileWords& words) { return next_piece(words); };
        share_.tick(path_.tick(rate_, next, target_ == 0));
    }
    ds_ = share_.sample();
    --requested_;
    return true;
}

bool KernelBoard::next_piece(hls::ProfileWords& words) {
    if (profile_.words.size() < hls::kProfileBusWords) return false;
    words = unpack_piece([this] { return profile_.pop(); });
    final_ = words.final;
    return true;
}

bool KernelBoard::cover() {
    const std::uint64_t reach = walked_ + static_cast<std::uint64_t>(ds_);
    while (covered_ == 0 || covered_ < reach) {
        if (segments_.words.size() < segment_words_) return false;
        ahead_.push_back(unpack_segment([this] { return segments_.pop(); }, core_, core_.axes()));
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
    const int guard = core_.guard_bits;
    const std::int64_t half = std::int64_t(1) << (guard - 1);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(core_.axes()); ++axis) {
        sample.position[axis] = wrapped((sample.fine[axis] + half) >> guard, core_.position_bits);
    }
}

BoardStatus KernelBoard::status() const {
    BoardStatus status;
    status.empty_segments = empty_segments_;
    return status;
}

}  // namespace curvecore::sysc
