// SPDX-License-Identifier: Apache-2.0
// A remote rtl/motion_board.sv at the other end of a link, as the registers describe it.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <random>
#include <utility>

#include "ref/machine/shaper.hpp"
#include "sysc/board/board.hpp"
#include "sysc/core/core_parameters.hpp"
#include "sysc/link/frame_stream.hpp"

namespace curvecore::sysc {

/// Properties that a board reports.
struct RemoteBuild {
    int axes = 0;
    double clock_hz = 0;
    double sample_period_s = 0;
    int segment_queue_words = 0;
    int profile_queue_words = 0;
    std::uint32_t widths = 0;  // WIDTHS: hls/registers/board_facts.h
    bool encoders = false;     // it has encoder inputs
    int outputs = 0;           // changes of outputs that wait; 0: it has none
    int shaper_places = 0;     // that are kept of an axis; 0: it has no shaper
    std::uint32_t table = 0;   // number of the table that the core draws besides; 0: none
    CoreParameters core;       // without it

    /// Words that ROOM counts the room of: those of a queue, or of the engine's entry to it.
    int counted_words(int queue_words) const {
        constexpr int kEntryWords = 128;  // EntryWords of rtl/engine/engine_pkg.sv
        return core.build == Build::kEngine ? kEntryWords : queue_words;
    }
};

/// The drives at a board's pins.
struct Drives {
    std::vector<double> steps_per_mm;  // scale of each axis
    double steplen_s = 2e-6;
    double stepspace_s = 2e-6;
    double dirsetup_s = 4e-6;
    double dirhold_s = 4e-6;
    std::array<ref::ShaperTaps, ref::kMachineAxes> shaper{};
    int tool_delay = 0;  // samples, of the outputs
};

/// Ratio of an encoder's edges to steps; steps < 0: it counts backwards.
struct EncoderRatio {
    int counts = 0;
    int steps = 0;
};

/// Reads a board's properties; this host does not become its master.
/// @throws BoardLost, UsageError: its registers or words are of another version
RemoteBuild ask_build(Link& link);

class RemoteMachine {
  public:
    /// Connects; `session` is the number of its first frame, random so that no frame of another
    /// host has it.
    /// @throws BoardLost, UsageError: its registers or words are of another version
    explicit RemoteMachine(Link& link, std::uint32_t session = std::random_device()());

    const RemoteBuild& build() const { return build_; }
    /// Number of samples by which the steps are behind the path with the shaper, at most.
    int shaper_samples() const { return shaper_samples_; }

    /// Makes a program that another host left under way stand, and returns how far it is drawn,
    /// quanta. @throws UsageError: none is, or the drives are off
    std::uint64_t stand();
    /// Turns the drives off, and sets their scales and times. Places of axes are forgotten if the
    /// scale changes.
    /// @throws UsageError: drives that the board does not support
    void prepare(const Drives& drives, double unit_mm);
    /// Sets the places of the axes to the start of the next program, and turns the drives on.
    /// @throws UsageError: a machine that cannot be turned on
    void begin(const BoardSettings& settings, int watchdog_samples);
    /// Ends a hold of the machine, whose queues are empty, for a program that begins where the axes
    /// stand, and waits until the board has obeyed.
    void begin_here(const BoardSettings& settings);

    /// Numbers of words of both streams.
    struct WordCounts {
        std::uint64_t segments = 0;
        std::uint64_t pieces = 0;
    };
    /// Takes words from the front of each while the board has room, so many at most. Returns how
    /// many.
    WordCounts push(std::deque<std::uint64_t>& segments, std::deque<std::uint64_t>& pieces,
                    const WordCounts& most);

    void set_override(int word);
    void hold(bool on);
    void estop();
    /// Resumes motion that stopped because the host was silent.
    void clear_watchdog();
    /// Stops on the path and empties the queues. Outputs go off, or stay on for a rest.
    void flush(bool keep_outputs);
    void disable();
    /// Handles answers, repetitions and state, for one wait of the link.
    void work() { frames_.work(); }
    void finish() { frames_.finish(); }
    /// Returns true if the board has taken all that was sent.
    bool all_taken() const { return frames_.all_taken(); }
    WireClock::time_point now() const { return link_.now(); }
    /// Returns the longest silence between two signs of life; 0: none are asked for.
    WireClock::duration live_period() const { return frames_.live_period(); }

    const Telemetry& telemetry() const { return frames_.telemetry(); }
    /// Words a second that the link carries, 0: unknown.
    double words_per_s() const;
    LinkFigures figures() const { return frames_.figures(); }
    bool is(std::uint32_t mask) const { return (telemetry().state & mask) != 0; }
    /// Returns the number of steps made on each axis.
    std::vector<std::int32_t> steps();

    /// Returns OUTPUTS.
    std::uint32_t outputs();

    /// Makes the motion hold when the axis' home switch closes, or opens, until the next begin().
    void wait_for_switch(int axis, bool closed);
    bool switch_closed(int axis);
    /// Returns the steps of the axis when its switch changed.
    std::int32_t caught_steps(int axis);
    /// Sets the limit switches that do not stop the machine.
    void ignore_limits(std::uint32_t axes);
    /// Sets an axis homed: its machine coordinate is 0 where its count of steps is `origin`.
    void set_origin(int axis, std::int32_t origin);
    void forget_place(int axis);
    /// Sets the encoder of an axis, which stops the machine beyond the limit, in 1 / counts of a
    /// step; 0: never.
    void watch(int axis, EncoderRatio encoder, std::uint32_t limit);
    /// Returns the axis' distance from its steps' place, in that unit: the present and the worst.
    std::pair<std::int32_t, std::int32_t> following(int axis);
    /// Returns the machine coordinates of the homed axes, in steps.
    std::vector<std::optional<std::int32_t>> places();
    /// Keeps the coordinates of the axes that are not homed, in steps, as the program counts them.
    void keep_places(const std::vector<std::int32_t>& now);
    /// Returns the coordinates of all axes: of those that are not homed, what was kept.
    std::vector<std::int32_t> kept_places();

  private:
    void write(std::uint32_t address, std::uint32_t word);
    std::uint32_t read(std::uint32_t address);
    void control(std::uint32_t bits);
    void set(const BoardSettings& settings);
    void settle(std::uint32_t mask);
    void shape(const Drives& drives);
    void set_scale(int axis, std::uint64_t scale);
    std::uint32_t homed();
    void keep_origin(int axis, std::int32_t origin);
    std::uint32_t why_off() const;

    Link& link_;
    FrameStream frames_;
    RemoteBuild build_;
    std::uint32_t control_ = 0;
    int shaper_samples_ = 0;
};

/// Names of the faults in a word of STATE.
std::string fault_names(std::uint32_t state);

}  // namespace curvecore::sysc
