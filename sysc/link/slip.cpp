// SPDX-License-Identifier: Apache-2.0
#include "sysc/link/slip.hpp"

#include <boost/crc.hpp>
#include <utility>

namespace curvecore::sysc {
namespace {

constexpr std::uint8_t kEscape = 0xdb;
constexpr std::uint8_t kEscapedEnd = 0xdc;
constexpr std::uint8_t kEscapedEscape = 0xdd;
constexpr std::size_t kCrcBytes = 4;

std::uint32_t crc_of(const Bytes& bytes, std::size_t count) {
    boost::crc_32_type crc;
    crc.process_bytes(bytes.data(), count);
    return crc.checksum();
}

std::uint8_t byte_of(std::uint32_t word, std::size_t n) {
    return static_cast<std::uint8_t>(word >> 8 * n);
}

}  // namespace

Bytes slip_encode(const Bytes& frame) {
    Bytes whole = frame;
    const std::uint32_t crc = crc_of(frame, frame.size());
    for (std::size_t n = 0; n < kCrcBytes; ++n) whole.push_back(byte_of(crc, n));
    Bytes line;
    for (const std::uint8_t byte : whole) {
        if (byte == kSlipEnd) {
            line.insert(line.end(), {kEscape, kEscapedEnd});
        } else if (byte == kEscape) {
            line.insert(line.end(), {kEscape, kEscapedEscape});
        } else {
            line.push_back(byte);
        }
    }
    line.push_back(kSlipEnd);
    return line;
}

std::optional<Bytes> SlipDecoder::take(std::uint8_t byte) {
    if (byte == kSlipEnd) {
        Bytes frame = std::exchange(held_, {});
        const bool broken = std::exchange(broken_, false) || std::exchange(escaped_, false);
        if (broken || frame.size() <= kCrcBytes) return std::nullopt;
        const std::size_t count = frame.size() - kCrcBytes;
        const std::uint32_t crc = crc_of(frame, count);
        for (std::size_t n = 0; n < kCrcBytes; ++n) {
            if (frame[count + n] != byte_of(crc, n)) return std::nullopt;
        }
        frame.resize(count);
        return frame;
    }
    if (byte == kEscape) {
        escaped_ = !escaped_;  // two of them encode no byte
    } else if (std::exchange(escaped_, false)) {
        broken_ = broken_ || (byte != kEscapedEnd && byte != kEscapedEscape);
        held_.push_back(byte == kEscapedEnd ? kSlipEnd : kEscape);
    } else {
        held_.push_back(byte);
    }
    return std::nullopt;
}

}  // namespace curvecore::sysc
