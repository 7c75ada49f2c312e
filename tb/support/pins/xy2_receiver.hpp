// SPDX-License-Identifier: Apache-2.0
// A scan head with XY2-100: three positions a frame, read from the pins alone.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace curvecore::tb {

/// The receiver samples data and sync whenever the clock falls; a frame ends with the bit whose
/// sync is low.
class Xy2Receiver {
  public:
    struct Frame {
        std::array<uint32_t, 3> words{};  // 20 bits
        std::vector<int64_t> falls;       // falling edges of the clock
    };

    /// Takes the pins on every clock of the system. Returns the frame that ends with it.
    std::optional<Frame> look(bool clock, bool sync, unsigned data, int64_t now) {
        const bool falls = clock_ && !clock;
        const bool rises = !clock_ && clock;
        EXPECT_TRUE(rises || data == data_) << "data changes while a receiver may look";
        clock_ = clock;
        data_ = data;
        if (!falls) return std::nullopt;
        for (unsigned a = 0; a < 3; ++a) frame_.words[a] = frame_.words[a] << 1 | (data >> a & 1);
        frame_.falls.push_back(now);
        if (sync) return std::nullopt;
        return std::exchange(frame_, {});
    }

  private:
    bool clock_ = false;
    unsigned data_ = 0;
    Frame frame_;
};

}  // namespace curvecore::tb
