// SPDX-License-Identifier: Apache-2.0
// Cost of a core in a device, without place and route.
//
// DSP and RAM blocks are counted from the RTL's structure and are exact. LUTs, flip-flops and the
// clock period are linear in a few features of the widths; scripts/fit_cost_model.py fits their
// coefficients to runs of scripts/synth.sh and writes sysc/cost/cost_model.json, which is compiled
// in. They are estimates: `error` is the model's error on runs that it was not fitted to.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "sysc/core/core_parameters.hpp"
#include "sysc/cost/device.hpp"

namespace curvecore::sysc {

enum class Core { kSpherical, kSpline, kCurve };

/// Name of a core as scripts/synth.sh has it: "spherical", "spline" or "curve".
const char* core_name(Core core);

/// Returns the core for these curves; the serial build has none for splines alone.
Core core_for(bool arcs, bool splines, Build build);

/// | field        | meaning                                                                 |
/// |--------------|-------------------------------------------------------------------------|
/// | lut4, ff     | estimates, of the core alone                                            |
/// | mhz          | estimate of what place and route reaches, at most the DSP blocks'       |
/// |              | limit; none where nothing is placed: XC7                                |
/// | dsp, ram     | exact                                                                   |
/// | lut4_error.. | relative error of the estimate: root mean square over runs left out, or |
/// |              | over those of the device's family where that is more                    |
struct CostEstimate {
    double lut4 = 0;
    double ff = 0;
    std::optional<double> mhz;
    int dsp = 0;
    int ram = 0;
    double lut4_error = 0;
    double ff_error = 0;
    double mhz_error = 0;

    /// Clock that is reached by the estimate less its error, Hz.
    std::optional<double> reached() const;
    bool fits(const Device& device) const;
    /// Shares of the device: the larger of LUT4 and flip-flops, DSP blocks, RAM blocks.
    std::array<double, 3> shares(const Device& device) const;
    /// Sum of the shares, by which "smallest" is meant.
    double size(const Device& device) const;
    /// Largest of the shares.
    double fullest(const Device& device) const;
};

/// Returns true if runs of this build were measured in the device's family.
bool cost_is_known(Build build, const Device& device);

/// Returns true if cores were placed in the device's family.
bool clock_is_known(const Device& device);

/// Estimates the cost; none if no runs were measured.
std::optional<CostEstimate> estimate(Core core, const CoreParameters& parameters,
                                     const Device& device);

/// Number of wide multipliers of the sampler, and of 18 x 18 ones of the spline's network in the
/// parallel build.
struct MultiplierCount {
    int wide = 0;
    int narrow = 0;
};
MultiplierCount count_multipliers(Core core, const CoreParameters& parameters);

/// Origin of a device's estimates, for reports: "fitted to 17 runs, ...".
std::string cost_model_source(const Device& device);

}  // namespace curvecore::sysc
