// SPDX-License-Identifier: Apache-2.0
#include "sysc/cores/gtkw_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "sysc/cores/waveform_signals.hpp"

namespace curvecore::sysc {
namespace {

/// Display flags of GTKWave's save files.
enum Show : unsigned {
    kBit = 0x28,
    kHex = 0x22,
    kUnsigned = 0x24,
    kSigned = 0x420,
    kCurve = 0x8420
};

const std::string kCircuits = "g_circuits.u_motion.";  // inside: rtl/path/path_interpolator.sv

struct Signal {
    Show show;
    std::string name;
};
using Signals = std::vector<Signal>;

/// Returns the scope of the module with a core's ports, "dut.motion_interpolator." of ours.
std::string top_of(const WaveformSignals& signals) {
    std::string root = "dut.";
    for (const auto& [name, range] : signals) {
        const std::size_t end = std::min(name.find('.', root.size()), name.size());
        if (name.substr(end) == ".sample_position_o") return name.substr(0, end + 1);
    }
    return root;
}

class Arrangement {
  public:
    Arrangement(std::string head, WaveformSignals signals)
        : signals_(std::move(signals)), top_(top_of(signals_)), text_(std::move(head)) {}

    /// Shows signals of the instance `at`, which is "" or ends with a dot.
    void show(const std::string& at, const Signals& signals) {
        for (const Signal& signal : signals) show(signal.show, at + signal.name);
    }

    /// Shows a group; a group without signals in this core is left out.
    void group(const char* name, const std::string& at, const Signals& signals) {
        const auto there = [&](const Signal& signal) {
            return signals_.count(top_ + at + signal.name) != 0;
        };
        if (std::none_of(signals.begin(), signals.end(), there)) return;
        text_ += fmt::format("@800200\n-{}\n", name);
        show(at, signals);
        text_ += fmt::format("@1000200\n-{}\n", name);
    }

    const std::string& text() const { return text_; }

  private:
    /// Shows a signal; a signal that this core does not have is left out.
    void show(Show how, const std::string& name) {
        const std::string full = top_ + name;
        const auto found = signals_.find(full);
        if (found == signals_.end()) return;
        text_ += fmt::format("@{:x}\n{}{}\n", static_cast<unsigned>(how), full, found->second);
        if (how == kCurve) text_ += "@20000\n-\n-\n";  // room to draw it
    }

    WaveformSignals signals_;
    std::string top_;
    std::string text_;
};

void parallel_core(Arrangement& view) {
    const std::string core = kCircuits + "u_core.";
    const std::string networks = core + "g_networks.u_steps.";
    view.group("Steps", networks + "u_starter.",
               {{kBit, "there"},
                {kBit, "room_i"},
                {kUnsigned, "start_o"},
                {kBit, "spline_o"},
                {kBit, "done_i"},
                {kBit, "last_o"},
                {kUnsigned, "k_o"}});
    view.group("Lines and arcs", networks + "g_arcs.u_steps.",
               {{kUnsigned, "order"},
                {kBit, "collect"},
                {kSigned, "x"},
                {kSigned, "y"},
                {kSigned, "z"},
                {kSigned, "f"},
                {kSigned, "g"},
                {kSigned, "h"}});
    view.group("Splines", networks + "g_splines.u_steps.",
               {{kSigned, "word"},
                {kBit, "start_network"},
                {kSigned, "phi_end"},
                {kHex, "q"},
                {kHex, "v"},
                {kHex, "w"},
                {kSigned, "moved"}});
    view.group("Sampler", core,
               {{kBit, "u_side.u_tracker.sample_o"},
                {kUnsigned, "u_side.u_tracker.step_o"},
                {kUnsigned, "u_side.u_tracker.left_o"},
                {kBit, "u_side.u_offset.sample_o"},
                {kUnsigned, "u_side.u_offset.tau_o"},
                {kBit, "u_side.u_offset.land_o"}});
}

void engine_core(Arrangement& view) {
    const std::string engine = "g_engine.u_motion.u_engine.";
    view.group("Engine", engine,
               {{kUnsigned, "place"},
                {kHex, "instruction"},
                {kHex, "conditions_i"},
                {kBit, "in_valid_o"},
                {kUnsigned, "in_port_o"},
                {kUnsigned, "in_limb_o"},
                {kHex, "in_data_i"},
                {kBit, "out_valid_o"},
                {kUnsigned, "out_port_o"},
                {kUnsigned, "out_limb_o"},
                {kHex, "out_data_o"}});
}

void path_side(Arrangement& view) {
    view.show("", {{kBit, "clk_i"}, {kBit, "rst_ni"}});
    view.group("Request", "",
               {{kBit, "sample_request_valid_i"},
                {kBit, "sample_request_ready_o"},
                {kUnsigned, "override_i"},
                {kBit, "hold_i"},
                {kBit, "kill_i"}});
    view.group("Queues", "",
               {{kBit, "segment_valid_i"},
                {kBit, "segment_ready_o"},
                {kHex, "segment_data_i"},
                {kBit, "profile_valid_i"},
                {kBit, "profile_ready_o"},
                {kHex, "profile_data_i"},
                {kHex, "fault_o"},
                {kBit, "underrun_o"}});
    view.group("Path generator", "",
               {{kBit, "active_o"},
                {kBit, kCircuits + "rate_valid"},
                {kUnsigned, kCircuits + "u_path.ticks_left_o"},
                {kBit, "path_valid_o"},
                {kUnsigned, "path_rate_o"},
                {kUnsigned, "path_ds_o"},
                {kUnsigned, "path_o"}});
}

void positions(Arrangement& view, const CoreParameters& core) {
    Signals signals{{kBit, "sample_valid_o"}, {kBit, "sample_ready_i"}};
    const char* const engine = "g_engine.g_axes[{}].whole";
    const char* const lander =
        "g_circuits.u_motion.u_core.u_side.u_landing.g_output[{}].position_q";
    const char* const words = core.build == Build::kEngine ? engine : lander;
    for (int axis = 0; axis < core.axes(); ++axis) {
        signals.push_back({kCurve, fmt::format(fmt::runtime(words), axis)});
    }
    signals.push_back({kHex, "sample_position_o"});
    signals.push_back({kHex, "sample_fine_o"});
    view.group("Positions", "", signals);
}

}  // namespace

std::string gtkw_head(const std::string& folder, const std::string& wave, const std::string& save,
                      double start, double span, double marker) {
    // A zoom of z shows 2^-z units of time in 200 of the 1000 pixels that the signals leave.
    constexpr double kFrames = 1000 / 200.0;
    const std::filesystem::path at = std::filesystem::absolute(folder).lexically_normal();
    return fmt::format(
        "[*] curvecore\n"
        "[dumpfile] \"{}\"\n"
        "[savefile] \"{}\"\n"
        "[timestart] {:.0f}\n"
        "[size] 1600 1000\n"
        "*{:.4f} {:.0f} -1 -1 -1 -1\n"
        "[sst_width] 220\n"
        "[signals_width] 330\n",
        (at / wave).string(), (at / save).string(), start, -std::log2(span / kFrames), marker);
}

std::string gtkw(const CoreParameters& core, const std::string& fst_file, const std::string& folder,
                 const FirstSample& first) {
    constexpr double kBefore = 40;  // clocks
    constexpr double kSpan = 200;
    constexpr double kReset = 3;  // clocks before the first that is counted
    const double clock_ps = 1e12 / first.clock_hz;
    const double at = static_cast<double>(first.clock) + kReset;
    const std::string head =
        gtkw_head(folder, "waves.fst", "waves.gtkw", std::max(0.0, at - kBefore) * clock_ps,
                  kSpan * clock_ps, at * clock_ps);
    Arrangement view(head, waveform_signals(fst_file));
    path_side(view);
    if (core.build == Build::kEngine) {
        engine_core(view);
    } else {
        parallel_core(view);
    }
    positions(view, core);
    return view.text();
}

}  // namespace curvecore::sysc
