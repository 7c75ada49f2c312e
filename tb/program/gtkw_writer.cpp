// SPDX-License-Identifier: Apache-2.0
#include "tb/program/gtkw_writer.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "tb/program/waveform_signals.hpp"

namespace curvecore::tb {
namespace {

/// Display flags of GTKWave's save files.
enum Show : unsigned {
    kBit = 0x28,
    kHex = 0x22,
    kUnsigned = 0x24,
    kSigned = 0x420,
    kCurve = 0x8420
};

class Arrangement {
  public:
    Arrangement(const std::string& folder, WaveformSignals signals) : signals_(std::move(signals)) {
        const std::filesystem::path at = std::filesystem::absolute(folder).lexically_normal();
        text_ = fmt::format(
            "[*] curvecore\n"
            "[dumpfile] \"{}\"\n"
            "[savefile] \"{}\"\n"
            "[timestart] 0\n"
            "[size] 1600 1000\n"
            "*-8.0 0 -1 -1 -1 -1\n"
            "[sst_width] 220\n"
            "[signals_width] 330\n",
            (at / "waves.fst").string(), (at / "waves.gtkw").string());
    }

    void begin(const char* name) { text_ += fmt::format("@800200\n-{}\n", name); }
    void end(const char* name) { text_ += fmt::format("@1000200\n-{}\n", name); }

    /// A signal that this core does not have is left out.
    void signal(Show show, const std::string& name) {
        const std::string full = "dut.motion_interpolator." + name;
        const auto found = signals_.find(full);
        if (found == signals_.end()) return;
        text_ += fmt::format("@{:x}\n{}{}\n", static_cast<unsigned>(show), full, found->second);
        if (show == kCurve) text_ += "@20000\n-\n-\n";  // room to draw it
    }

    const std::string& text() const { return text_; }

  private:
    WaveformSignals signals_;
    std::string text_;
};

void parallel_core(Arrangement& view) {
    const std::string at = "g_parallel.u_core.";
    view.begin("Network");
    view.signal(kBit, at + "u_steps.segment_there");
    view.signal(kBit, at + "u_steps.room_i");
    view.signal(kUnsigned, at + "u_steps.order_o");
    view.signal(kBit, at + "u_steps.collect_o");
    for (const char* node : {"x_o", "y_o", "z_o", "f_o", "g_o", "h_o"}) {
        view.signal(kSigned, at + "u_steps." + node);
    }
    view.signal(kBit, at + "u_steps.done_o");
    view.signal(kBit, at + "u_steps.last_o");
    view.signal(kUnsigned, at + "u_steps.k_o");
    view.end("Network");
    view.begin("Sampler");
    view.signal(kBit, at + "u_tracker.sample_o");
    view.signal(kUnsigned, at + "u_tracker.step_o");
    view.signal(kUnsigned, at + "u_tracker.left_o");
    view.signal(kBit, at + "u_offset.sample_o");
    view.signal(kUnsigned, at + "u_offset.tau_o");
    view.signal(kBit, at + "u_offset.land_o");
    view.end("Sampler");
}

void serial_core(Arrangement& view) {
    const std::string at = "g_serial.u_core.";
    view.begin("Network");
    view.signal(kBit, at + "net_start");
    view.signal(kBit, at + "net_busy");
    view.signal(kUnsigned, at + "u_sequencer.place");
    for (const char* port : {"a_address", "b_address", "c_address"}) view.signal(kHex, at + port);
    view.signal(kSigned, at + "u_datapath.a_q");
    view.signal(kSigned, at + "u_datapath.b_q");
    view.signal(kSigned, at + "u_datapath.c_q");
    view.signal(kHex, at + "d_place");
    view.signal(kSigned, at + "d");
    view.end("Network");
    view.begin("Sampler");
    view.signal(kBit, at + "request_valid_i");
    view.signal(kBit, at + "request_ready_o");
    view.signal(kUnsigned, at + "request_ds_i");
    view.signal(kBit, at + "sample");
    view.signal(kBit, at + "sample_take");
    view.signal(kBit, at + "land");
    view.signal(kUnsigned, at + "u_sequencer.context_q");
    view.end("Sampler");
}

void positions(Arrangement& view, const CoreParameters& core) {
    view.begin("Positions");
    view.signal(kBit, "sample_valid_o");
    view.signal(kBit, "sample_ready_i");
    const char* words = core.build == Build::kParallel
                            ? "g_parallel.u_core.g_axis[{}].u_lander.position_o"
                            : "g_serial.u_core.u_lander.g_axis[{}].axis_position_q";
    for (int axis = 0; axis < core.axes(); ++axis) {
        view.signal(kCurve, fmt::format(fmt::runtime(words), axis));
    }
    view.signal(kHex, "sample_position_o");
    view.signal(kHex, "sample_fine_o");
    view.end("Positions");
}

}  // namespace

std::string gtkw(const CoreParameters& core, const std::string& fst_file,
                 const std::string& folder) {
    Arrangement view(folder, waveform_signals(fst_file));
    view.signal(kBit, "clk_i");
    view.signal(kBit, "rst_ni");
    view.begin("Request");
    view.signal(kBit, "sample_request_valid_i");
    view.signal(kBit, "sample_request_ready_o");
    view.signal(kUnsigned, "override_i");
    view.signal(kBit, "hold_i");
    view.signal(kBit, "kill_i");
    view.end("Request");
    view.begin("Queues");
    view.signal(kBit, "segment_valid_i");
    view.signal(kBit, "segment_ready_o");
    view.signal(kHex, "segment_data_i");
    view.signal(kBit, "profile_valid_i");
    view.signal(kBit, "profile_ready_o");
    view.signal(kHex, "profile_data_i");
    view.signal(kUnsigned, "queued_ticks");
    view.signal(kBit, "underrun_o");
    view.end("Queues");
    view.begin("Path generator");
    view.signal(kBit, "active_o");
    view.signal(kBit, "tick");
    view.signal(kUnsigned, "u_path.ticks_left_o");
    view.signal(kBit, "path_valid_o");
    view.signal(kUnsigned, "path_rate_o");
    view.signal(kUnsigned, "path_ds_o");
    view.signal(kUnsigned, "path_o");
    view.end("Path generator");
    if (core.build == Build::kParallel) {
        parallel_core(view);
    } else {
        serial_core(view);
    }
    positions(view, core);
    return view.text();
}

}  // namespace curvecore::tb
