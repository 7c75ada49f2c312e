// SPDX-License-Identifier: Apache-2.0
// The model of rtl/motion_interpolator.sv in one configuration.
#include "tb/support/bench/core_model.hpp"
#include "tb/support/bench/motion_ports.hpp"

namespace curvecore::tb {

static void drive(const MotionPorts& ports, MODEL& model) {
    model.rst_ni = ports.rst_ni;
    model.digest_i = static_cast<SData>(ports.digest_i);
    model.segment_valid_i = ports.segment_valid_i;
    model.segment_data_i = ports.segment_data_i;
    model.profile_valid_i = ports.profile_valid_i;
    model.profile_data_i = ports.profile_data_i;
    model.sample_request_valid_i = ports.sample_request_valid_i;
    model.sample_ready_i = ports.sample_ready_i;
    model.hold_i = ports.hold_i;
    model.override_i = ports.override_i;
    model.kill_i = ports.kill_i;
    model.samples_per_tick_log2_i = static_cast<CData>(ports.samples_per_tick_log2_i);
    model.hold_acceleration_i = ports.hold_acceleration_i;
    model.hold_slope_i = ports.hold_slope_i;
    model.stop_ticks_i = ports.stop_ticks_i;
}

static void observe(const MODEL& model, MotionPorts& ports) {
    ports.segment_ready_o = model.segment_ready_o;
    ports.profile_ready_o = model.profile_ready_o;
    ports.sample_request_ready_o = model.sample_request_ready_o;
    ports.path_valid_o = model.path_valid_o;
    ports.path_ds_o = model.path_ds_o;
    ports.path_rate_o = model.path_rate_o;
    ports.path_active_o = model.path_active_o;
    ports.path_o = model.path_o;
    ports.active_o = model.active_o;
    ports.underrun_o = model.underrun_o;
    ports.killed_o = model.killed_o;
    ports.standing_o = model.standing_o;
    ports.fault_o = model.fault_o;
    ports.empty_segments_o = model.empty_segments_o;
    observe_sample(model, ports);
}

template <>
std::unique_ptr<MotionCore::Model> MotionCore::make_model(int seed) {
    return std::make_unique<CoreModel<MODEL, MotionPorts>>(seed);
}

}  // namespace curvecore::tb
