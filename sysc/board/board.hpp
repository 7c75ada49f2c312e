// SPDX-License-Identifier: Apache-2.0
// The board as a host sees it, whatever draws behind it: words of both streams in, samples out.
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
#include <stdexcept>
#include <vector>

namespace curvecore::sysc {

constexpr std::size_t kBoardAxes = 9;

/// A board that does not what boards do.
class BoardError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

enum class Stream { kSegments, kProfile };

/// A request as the core received it, and the sample that the core returned.
struct Sample {
    std::int64_t ds = 0;                              // path increment, quanta
    std::int32_t rate = 0;                            // rate of time in its tick, 2^16 = 1
    std::uint64_t clock = 0;                          // clock of the core when the sample left it
    std::array<std::int64_t, kBoardAxes> position{};  // length units
    std::array<std::int64_t, kBoardAxes> fine{};      // before rounding: GuardBits more
};

/// Settings of rtl/motion_interpolator.sv that stay constant while a program is drawn.
struct BoardSettings {
    int samples_per_tick_log2 = 0;
    std::int32_t override_word = 0;       // 2^16 = 100 %
    std::uint32_t hold_acceleration = 0;  // second difference of time, 2^-32 per tick^2
    std::uint64_t hold_slope = 0;         // first difference of time; at least as much
    std::uint32_t stop_ticks = 0;         // profile ticks that a stop needs
    std::uint16_t digest = 0;             // digest of the settings that the words must be made for
    std::uint16_t host_digest = 0;        // part of `digest` that is in the register DIGEST
};

/// An axis behind the board's step pins.
struct AxisStatus {
    std::uint64_t steps = 0;
    std::uint64_t turns = 0;
    std::int64_t count = 0;  // steps up less down
    std::int64_t due = 0;    // steps from the first sample to the last
    bool overrun = false;    // a step was dropped
    bool refused = false;    // a step was faster than the pins allow
    double following_error_mm = 0;
};

/// Movement of a board with step pins.
struct StepStatus {
    double clock_hz = 0;
    std::uint64_t pins = 0;  // digest of all pin changes and their times
    std::vector<AxisStatus> axes;
};

struct BoardStatus {
    std::uint64_t clocks = 0;  // clocks of the core; 0: it has none
    bool underrun = false;
    unsigned fault = 0;  // fault_o of rtl/motion_interpolator.sv
    std::uint64_t empty_segments = 0;
    std::uint64_t late_samples = 0;  // sample periods that ended without their sample
    std::uint64_t starved = 0;       // number of times that the queues held less than a stop takes
    std::optional<StepStatus> steps{};
};

class Board {
  public:
    virtual ~Board() = default;

    /// Takes as many of the `count` words as there is room for, and returns their number.
    virtual std::size_t write(Stream stream, const std::uint64_t* words, std::size_t count) = 0;
    /// Returns true once every word that was taken is in its queue.
    virtual bool arrived(Stream /*stream*/) const { return true; }
    /// Returns true if the queue has refused a word: none fits until samples are drawn.
    virtual bool full(Stream stream) const = 0;
    /// Returns true if a timer of the board draws the requested samples, one a period; otherwise
    /// samples come as fast as the board can draw them.
    virtual bool paced() const { return false; }
    /// Requests `samples` more samples.
    virtual void request(std::uint64_t samples) = 0;
    /// Works until the host looks again: for a clock, a sample or a period of the host. Appends the
    /// samples that came.
    virtual void work(std::vector<Sample>& samples) = 0;
    virtual BoardStatus status() const = 0;
};

}  // namespace curvecore::sysc
