// SPDX-License-Identifier: Apache-2.0
// Random stop branches, and words of branches, of a motion bench.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "hls/words.hpp"

namespace curvecore::tb {

struct Stop {
    std::int32_t wait = 0;  // 0: none
    std::vector<hls::StopStep> steps;
    bool again = false;  // its steps are those of the one before, and are not sent
};

/// The words of a stream's branches.
class BranchWords {
  public:
    /// Words of the next branch; without steps, again, if they are those of the one before.
    std::vector<std::uint64_t> words(Stop& stop) {
        if (stop.wait == 0) return {};
        std::vector<std::uint64_t> steps;
        for (const hls::StopStep& step : stop.steps) steps.push_back(hls::pack(step));
        stop.again = steps == before_;
        std::vector<std::uint64_t> words{hls::pack_stop(stop.wait, stop.again)};
        if (!stop.again) words.insert(words.end(), steps.begin(), steps.end());
        before_ = std::move(steps);
        return words;
    }

  private:
    std::vector<std::uint64_t> before_;
};

class RandomStops {
  public:
    explicit RandomStops(std::mt19937& random) : random_(random) {}

    /// A random stop, usually from the rate 1 to 0, in up to 300 ticks; or the one before again.
    Stop any(int most_wait) {
        Stop stop;
        stop.wait = static_cast<std::int32_t>(1 + random_() % static_cast<unsigned>(most_wait));
        if (last_.empty() || random_() % 3 != 0) last_ = steps();
        stop.steps = last_;
        return stop;
    }

  private:
    std::vector<hls::StopStep> steps() {
        std::vector<hls::StopStep> steps;
        if (random_() % 5 == 0) {
            for (int n = 1 + static_cast<int>(random_() % 40); n > 0; --n) {
                const auto change = static_cast<std::int32_t>(random_() >> (random_() % 30));
                steps.push_back({static_cast<std::int32_t>(1 + random_() % 3),
                                 steps.empty() ? change | INT32_MIN : change, n == 1});
            }
            return steps;
        }
        const int log2 = 3 + static_cast<int>(random_() % 5);
        const auto change = static_cast<std::int32_t>((std::int64_t{1} << 32) >> (2 * log2));
        for (const int sign : {-1, 1}) {
            for (int left = 1 << log2; left > 0;) {
                const int ticks = std::min(left, 1 + static_cast<int>(random_() % 20));
                left -= ticks;
                steps.push_back({ticks, sign * change, sign > 0 && left == 0});
            }
        }
        return steps;
    }

    std::mt19937& random_;
    std::vector<hls::StopStep> last_;
};

}  // namespace curvecore::tb
