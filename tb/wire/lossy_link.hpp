// SPDX-License-Identifier: Apache-2.0
// A network in time of the board's clocks, which loses, doubles and delays. The fate of a frame or
// an answer follows from the seed and its number alone, so that a run is reproducible.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <random>

#include "sysc/link/frame.hpp"
#include "sysc/link/link.hpp"
#include "sysc/virtual/virtual_board.hpp"

namespace curvecore::sysc {

struct Network {
    unsigned seed = 0;
    double lost = 0;           // share of frames, and of answers
    double doubled = 0;        // share of those that are not lost
    double late = 0;           // share of all that arrive, by up to late_s, so that others overtake
    double late_s = 0.05;      // s
    double latency_s = 0.001;  // s, each way
    double frame_s = 0;        // s from one frame that the board takes to the next, at least
};

/// Link to a virtual board, which runs for the time that its host waits.
class LossyLink : public Link {
  public:
    LossyLink(const Network& network, std::function<void(const VirtualStep&)> step)
        : network_(network), board_(std::move(step), {}) {}

    void send(const Bytes& frame) override { pass(frame, kToBoard); }

    std::optional<Bytes> receive(WireClock::duration wait) override {
        const std::uint64_t end = board_.clocks() + clocks_of(std::chrono::duration<double>(wait));
        for (;; clock()) {
            if (std::optional<Bytes> answer = arrived(kToHost)) return answer;
            if (board_.clocks() >= end) return std::nullopt;
        }
    }

    WireClock::duration poll_period() const override { return std::chrono::milliseconds(1); }

    WireClock::time_point now() const override {
        const std::chrono::duration<double> passed(static_cast<double>(board_.clocks()) /
                                                   board_.times().clock_hz);
        return WireClock::time_point(std::chrono::duration_cast<WireClock::duration>(passed));
    }

    /// Lets the board take no frame for so long.
    void sleep(double time_s) {
        takes_ = board_.clocks() + clocks_of(std::chrono::duration<double>(time_s));
    }

    std::uint64_t lost() const { return lost_; }
    std::uint64_t doubled() const { return doubled_; }
    std::uint64_t late() const { return late_; }

  private:
    enum Way { kToBoard, kToHost };
    static constexpr std::size_t kMostUnderWay = 256;  // more are lost

    std::uint64_t clocks_of(std::chrono::duration<double> time) const {
        const double clocks = std::ceil(time.count() * board_.times().clock_hz);
        return static_cast<std::uint64_t>(std::max(clocks, 0.0));
    }

    void pass(const Bytes& data, Way way) {
        std::seed_seq seeds{network_.seed, static_cast<unsigned>(way), number_[way]++};
        std::mt19937 random(seeds);
        const auto happens = [&](double chance) { return random() < chance * 0x1p32; };
        if (happens(network_.lost)) {
            ++lost_;
            return;
        }
        const bool twice = happens(network_.doubled);
        if (twice) ++doubled_;
        for (int copy = 0; copy <= (twice ? 1 : 0); ++copy) {
            double time = network_.latency_s;
            if (happens(network_.late)) {
                ++late_;
                time += network_.late_s * random() * 0x1p-32;
            }
            if (way_[way].size() == kMostUnderWay) continue;
            const std::uint64_t due =
                board_.clocks() + clocks_of(std::chrono::duration<double>(time));
            way_[way].emplace(due, data);
        }
    }

    std::optional<Bytes> arrived(Way way) {
        const auto first = way_[way].begin();
        if (first == way_[way].end() || first->first > board_.clocks()) return std::nullopt;
        std::optional<Bytes> data = first->second;
        way_[way].erase(first);
        return data;
    }

    /// Advances the clock as a board behind UDP: the next frame goes in when the last is answered.
    void clock() {
        if (board_.taken() && !asked_ && board_.clocks() >= takes_) {
            if (const std::optional<Bytes> frame = arrived(kToBoard)) {
                board_.offer(*frame);
                sleep(network_.frame_s);
                asked_ = contents_of(*frame).words_read > 0;
            }
        }
        if (const std::optional<Bytes> answer = board_.clock()) {
            asked_ = false;
            pass(*answer, kToHost);
        }
    }

    Network network_;
    VirtualBoard board_;
    std::multimap<std::uint64_t, Bytes> way_[2];  // by clock of arrival
    unsigned number_[2] = {0, 0};
    bool asked_ = false;
    std::uint64_t takes_ = 0;  // clock from which on the board takes a frame
    std::uint64_t lost_ = 0;
    std::uint64_t doubled_ = 0;
    std::uint64_t late_ = 0;
};

}  // namespace curvecore::sysc
