// SPDX-License-Identifier: Apache-2.0
#include "sysc/system/system_board.hpp"

#include <cmath>
#include <random>
#include <utility>

#include "sysc/core/core_clocks.hpp"
#include "sysc/report/report.hpp"
#include "sysc/system/host_port.hpp"
#include "sysc/system/timed_board.hpp"

namespace curvecore::sysc {
namespace {

struct Modules {
    Modules(const std::string& trace_file, const std::vector<std::string>& axes) {
        if (!trace_file.empty()) {
            trace = std::make_unique<PinTrace>("trace", trace_file, axes);
        }
        host.bus.bind(bus.host);
        bus.board.bind(board.bus);
        sc_core::sc_start(sc_core::SC_ZERO_TIME);  // lets every thread wait for its event
    }

    HostPort host{"host"};
    Bus bus{"bus"};
    TimedBoard board{"board"};
    std::unique_ptr<PinTrace> trace;
};

/// Modules of the simulation. Once begun it accepts no more, and they last as long as it does.
Modules& modules(const std::string& trace_file, const std::vector<std::string>& axes) {
    static Modules& only = *new Modules(trace_file, axes);
    return only;
}

/// Number of samples requested before they are due: SamplesAhead of rtl/motion_system.sv.
std::size_t requested_ahead(const CoreParameters& core) {
    constexpr std::size_t kSamplesAhead = 4;
    if (core.build != Build::kEngine) return kSamplesAhead;
    return 1 + static_cast<std::size_t>(hls::samples_ahead(timed_core(core)));
}

class SystemBoard : public Board {
  public:
    SystemBoard(const Job& job, std::unique_ptr<Board> core, std::unique_ptr<Machine> machine,
                const std::string& trace)
        : settings_(job.options.system),
          core_(std::move(core)),
          machine_(std::move(machine)),
          guard_(job),
          modules_(modules(trace, axis_names(job))) {
        bus_.set_word_time(settings_.word_s);
        const double period = job.options.sample_period_s;
        BoardParts parts;
        parts.core = core_.get();
        parts.machine = machine_.get();
        parts.guard = &guard_;
        parts.trace = trace.empty() ? nullptr : modules_.trace.get();
        parts.sample_s = period;
        parts.ahead = requested_ahead(job.options.core);
        // A turn is a sample for the kernel, a clock for a Verilated core.
        const double turns = rtl() ? std::floor(period * job.options.clock_hz + 1e-9)
                                   : static_cast<double>(parts.ahead);
        parts.turns_per_sample = static_cast<std::uint64_t>(turns);
        board_.begin(parts);
    }
    ~SystemBoard() override {
        board_.end();
        if (modules_.trace) modules_.trace->close();
    }
    SystemBoard(const SystemBoard&) = delete;
    SystemBoard& operator=(const SystemBoard&) = delete;

    std::size_t write(Stream stream, const std::uint64_t* words, std::size_t count) override {
        return host_.write(stream == Stream::kSegments ? kSegmentWords : kProfileWords, words,
                           count);
    }
    bool arrived(Stream stream) const override { return core_->arrived(stream); }
    bool full(Stream stream) const override { return core_->full(stream); }
    bool paced() const override { return true; }
    void request(std::uint64_t samples) override { host_.write(kRequest, &samples, 1); }

    void work(std::vector<Sample>& samples) override {
        sc_core::sc_start(seconds(settings_.host_s + settings_.jitter_s * draw()));
        while (board_.comes_to_rest()) sc_core::sc_start(seconds(settings_.host_s));
        std::vector<Sample>& came = board_.samples();
        samples.insert(samples.end(), came.begin(), came.end());
        came.clear();
    }

    BoardStatus status() const override {
        BoardStatus status = core_->status();
        status.late_samples = board_.late_samples();
        status.starved = guard_.times();
        if (!rtl()) status.underrun = guard_.times() > 0;
        if (machine_) status.steps = machine_->status();
        return status;
    }

  private:
    bool rtl() const { return settings_.interpolator == BlockKind::kRtl; }
    /// Random number in [0, 1).
    double draw() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

    const SystemSettings settings_;
    std::unique_ptr<Board> core_;
    std::unique_ptr<Machine> machine_;
    QueueGuard guard_;
    std::mt19937_64 random_{1};
    Modules& modules_;
    HostPort& host_ = modules_.host;
    Bus& bus_ = modules_.bus;
    TimedBoard& board_ = modules_.board;
};

}  // namespace

std::unique_ptr<Machine> make_machine(const Job& job) {
    const Options& options = job.options;
    MachineSetup setup;
    setup.axes = 3 + job.plan.aux_axes;  // named in the report
    setup.fine_mm = std::ldexp(options.unit_mm, -options.core.guard_bits);
    setup.sample_s = options.sample_period_s;
    setup.clock_hz = options.clock_hz;
    return std::make_unique<Machine>(setup, options.system);
}

std::unique_ptr<Board> make_system_board(const Job& job, std::unique_ptr<Board> core,
                                         std::unique_ptr<Machine> machine,
                                         const std::string& trace) {
    return std::make_unique<SystemBoard>(job, std::move(core), std::move(machine), trace);
}

}  // namespace curvecore::sysc
