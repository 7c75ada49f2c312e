// SPDX-License-Identifier: Apache-2.0
#include "tb/program/gtkw_writer.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace curvecore::tb {
namespace {

/// Display flags of GTKWave's save files.
enum Show : unsigned { kBit = 0x28, kHex = 0x22, kUnsigned = 0x24, kSigned = 0x420, kCurve = 0x8420 };

class Arrangement {
  public:
    explicit Arrangement(const std::string& folder) {
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

    void signal(Show show, const std::string& name, int bits) {
        const std::string range = bits == 1 ? "" : fmt::format("[{}:0]", bits - 1);
        text_ += fmt::format("@{:x}\ndut.motion_interpolator.{}{}\n", static_cast<unsigned>(show),
                             name, range);
        if (show == kCurve) text_ += "@20000\n-\n-\n";  // room to draw it
    }

    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

void parallel_core(Arrangement& view, const CoreParameters& core) {
    const std::string at = "g_parallel.u_core.";
    const int step_bits = 43;
    view.begin("Network");
    view.signal(kBit, at + "u_steps.segment_there", 1);
    view.signal(kBit, at + "u_steps.room_i", 1);
    view.signal(kUnsigned, at + "u_steps.order_o", 4);
    view.signal(kBit, at + "u_steps.collect_o", 1);
    for (const char* node : {"x_o", "y_o", "z_o", "f_o", "g_o", "h_o"}) {
        view.signal(kSigned, at + "u_steps." + node, core.coef_bits);
    }
    view.signal(kBit, at + "u_steps.done_o", 1);
    view.signal(kBit, at + "u_steps.last_o", 1);
    view.signal(kUnsigned, at + "u_steps.k_o", 5);
    view.end("Network");
    view.begin("Sampler");
    view.signal(kBit, at + "enable", 1);
    view.signal(kBit, at + "u_tracker.sample_o", 1);
    view.signal(kUnsigned, at + "u_tracker.step_o", 3);
    view.signal(kUnsigned, at + "u_tracker.left_o", step_bits);
    view.signal(kBit, at + "u_offset.sample_o", 1);
    view.signal(kUnsigned, at + "u_offset.tau_o", core.coef_bits);
    view.signal(kBit, at + "u_offset.land_o", 1);
    view.end("Sampler");
}

void serial_core(Arrangement& view, const CoreParameters&) {
    const std::string at = "g_serial.u_core.";
    view.begin("Network");
    view.signal(kBit, at + "segment_valid_i", 1);
    view.signal(kBit, at + "segment_ready_o", 1);
    view.signal(kHex, at + "segment_data_i", 48);
    view.end("Network");
    view.begin("Sampler");
    view.signal(kBit, at + "request_valid_i", 1);
    view.signal(kBit, at + "request_ready_o", 1);
    view.signal(kUnsigned, at + "request_ds_i", 48);
    view.end("Sampler");
}

void positions(Arrangement& view, const CoreParameters& core) {
    view.begin("Positions");
    view.signal(kBit, "sample_valid_o", 1);
    view.signal(kBit, "sample_ready_i", 1);
    if (core.build == Build::kParallel) {
        for (int axis = 0; axis < core.axes(); ++axis) {
            view.signal(kCurve,
                        fmt::format("g_parallel.u_core.g_axis[{}].u_lander.position_o", axis),
                        core.position_bits);
        }
    }
    view.signal(kHex, "sample_position_o", core.axes() * core.position_bits);
    view.signal(kHex, "sample_fine_o", core.axes() * (core.position_bits + core.guard_bits));
    view.end("Positions");
}

}  // namespace

std::string gtkw(const CoreParameters& core, const std::string& folder) {
    Arrangement view(folder);
    view.signal(kBit, "clk_i", 1);
    view.signal(kBit, "rst_ni", 1);
    view.begin("Request");
    view.signal(kBit, "sample_request_valid_i", 1);
    view.signal(kBit, "sample_request_ready_o", 1);
    view.signal(kUnsigned, "override_i", 17);
    view.signal(kBit, "hold_i", 1);
    view.signal(kBit, "kill_i", 1);
    view.end("Request");
    view.begin("Queues");
    view.signal(kBit, "segment_valid_i", 1);
    view.signal(kBit, "segment_ready_o", 1);
    view.signal(kHex, "segment_data_i", 48);
    view.signal(kBit, "profile_valid_i", 1);
    view.signal(kBit, "profile_ready_o", 1);
    view.signal(kHex, "profile_data_i", 48);
    view.signal(kUnsigned, "queued_ticks", 32);
    view.signal(kBit, "underrun_o", 1);
    view.end("Queues");
    view.begin("Path generator");
    view.signal(kBit, "active_o", 1);
    view.signal(kBit, "tick", 1);
    view.signal(kUnsigned, "u_path.ticks_left_o", 20);
    view.signal(kBit, "path_valid_o", 1);
    view.signal(kUnsigned, "path_rate_o", 17);
    view.signal(kUnsigned, "path_ds_o", 48);
    view.signal(kUnsigned, "path_o", 64);
    view.end("Path generator");
    if (core.build == Build::kParallel) {
        parallel_core(view, core);
    } else {
        serial_core(view, core);
    }
    positions(view, core);
    return view.text();
}

}  // namespace curvecore::tb
