// SPDX-License-Identifier: Apache-2.0
// What a host meets, whatever draws behind it: words of both streams in, samples out.
//
//     host:  write() what fits, request() what the words cover, work(), and again
//     board: queues -> path generator -> curve core -> samples
//
// Kernel, Verilated core and SystemC system are boards; the same words give the same samples.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace curvecore::sysc {

constexpr std::size_t kBoardAxes = 9;

enum class Stream { kSegments, kProfile };

/// A request as the core got it, and the sample that it gave.
struct Sample {
    std::int64_t ds = 0;                              // path increment, quanta
    std::int32_t rate = 0;                            // of time in its tick, 2^16 = 1
    std::uint64_t clock = 0;                          // of the core when the sample left it
    std::array<std::int64_t, kBoardAxes> position{};  // length units
    std::array<std::int64_t, kBoardAxes> fine{};      // before rounding: GuardBits more
};

/// What stands still while a program is drawn: settings of rtl/motion_interpolator.sv.
struct BoardSettings {
    int samples_per_tick_log2 = 0;
    std::int32_t override_word = 0;       // 2^16 = 100 %
    std::uint32_t hold_acceleration = 0;  // second difference of time, 2^-32 per tick^2
    std::uint64_t hold_slope = 0;         // first difference, at least as much
    std::uint32_t stop_ticks = 0;         // of the profile, that a stop needs
    std::uint16_t digest = 0;             // of what its words have to be made for
    std::uint16_t host_digest = 0;        // of that what the register DIGEST has
};

/// An axis behind the board's step pins.
struct AxisStatus {
    std::uint64_t steps = 0;
    std::uint64_t turns = 0;
    std::int64_t count = 0;  // steps up less down
    std::int64_t due = 0;    // that its first and last sample are apart
    bool overrun = false;    // a step was dropped
    bool refused = false;    // it was too fast
    double following_error_mm = 0;
};

/// What a board with step pins moved.
struct StepStatus {
    double clock_hz = 0;
    std::uint64_t pins = 0;  // digest of all their changes and times
    std::vector<AxisStatus> axes;
};

struct BoardStatus {
    std::uint64_t clocks = 0;  // of the core; 0: it has none
    bool underrun = false;
    unsigned fault = 0;  // fault_o of rtl/motion_interpolator.sv
    std::uint64_t empty_segments = 0;
    std::uint64_t late_samples = 0;  // sample periods that ended without their sample
    std::uint64_t starved = 0;       // how often the queues held less than a stop takes
    std::optional<StepStatus> steps{};
};

class Board {
  public:
    virtual ~Board() = default;

    /// Takes the first of `count` words that there is room for, and returns how many.
    virtual std::size_t write(Stream stream, const std::uint64_t* words, std::size_t count) = 0;
    /// Every word that was taken is in its queue.
    virtual bool arrived(Stream /*stream*/) const { return true; }
    /// The queue has refused a word: none fits until samples are drawn.
    virtual bool full(Stream stream) const = 0;
    /// A timer of its own takes the samples that were asked for, one a period; else they come as
    /// fast as they can.
    virtual bool paced() const { return false; }
    /// Asks for so many samples more.
    virtual void request(std::uint64_t samples) = 0;
    /// Works until the host looks again: a clock, a sample or a period of the host. Appends the
    /// samples that came.
    virtual void work(std::vector<Sample>& samples) = 0;
    virtual BoardStatus status() const = 0;
};

}  // namespace curvecore::sysc
