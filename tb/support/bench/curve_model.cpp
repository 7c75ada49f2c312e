// SPDX-License-Identifier: Apache-2.0
// The model of a core that draws curves, in one configuration.
#include "tb/support/bench/core_model.hpp"
#include "tb/support/bench/curve_ports.hpp"

namespace curvecore::tb {

static void drive(const CurvePorts& ports, MODEL& model) {
    model.rst_ni = ports.rst_ni;
    model.segment_valid_i = ports.segment_valid_i;
    model.segment_data_i = ports.segment_data_i;
    model.request_valid_i = ports.request_valid_i;
    model.request_ds_i = ports.request_ds_i;
    model.sample_ready_i = ports.sample_ready_i;
}

static void observe(const MODEL& model, CurvePorts& ports) {
    ports.segment_ready_o = model.segment_ready_o;
    ports.request_ready_o = model.request_ready_o;
    ports.empty_segments_o = model.empty_segments_o;
    observe_sample(model, ports);
}

template <>
std::unique_ptr<CurveCore::Model> CurveCore::make_model(int seed) {
    return std::make_unique<CoreModel<MODEL, CurvePorts>>(seed);
}

}  // namespace curvecore::tb
