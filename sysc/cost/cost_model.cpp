// SPDX-License-Identifier: Apache-2.0
#include "sysc/cost/cost_model.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <vector>

#include "sysc/cost/cost_model_data.hpp"
#include "sysc/cost/cost_structure.hpp"

namespace curvecore::sysc {
namespace {

enum Base {
    kOrder,
    kCoefBits,
    kFineBits,
    kAxes,
    kSamples,  // samples a clock
    kArcs,
    kSplines,
    kWide,
    kNarrow,
    kSoft,
    kWideBlock,
    kFamily,
    kBases
};
using Values = std::array<double, kBases>;
constexpr std::array<std::string_view, kFamily> kBaseNames{
    "order",   "coef_bits", "fine_bits", "axes", "samples",   "arcs",
    "splines", "wide",      "narrow",    "soft", "wide_block"};

struct Term {
    std::string family;  // 1 in this family, 0 in others; empty: no factor
    std::vector<Base> factors;
    double coefficient;
};

struct Model {
    std::string build;
    std::string quantity;
    std::vector<Term> terms;
    double error;
    std::map<std::string, double, std::less<>> family_errors;

    double error_in(std::string_view family) const {
        return std::max(error, family_errors.find(family)->second);
    }

    double predict(std::string_view family, const Values& values) const {
        double sum = 0;
        for (const Term& term : terms) {
            if (!term.family.empty() && term.family != family) continue;
            double product = term.coefficient;
            for (const Base factor : term.factors) product *= values[factor];
            sum += product;
        }
        return sum;
    }
};

Term read_term(const std::string& feature, double coefficient) {
    Term term{"", {}, coefficient};
    for (std::size_t at = 0; at <= feature.size();) {
        const std::size_t end = std::min(feature.find('*', at), feature.size());
        const std::string name = feature.substr(at, end - at);
        const auto* const found = std::find(kBaseNames.begin(), kBaseNames.end(), name);
        if (found == kBaseNames.end()) {
            term.family = name;
        } else {
            term.factors.push_back(static_cast<Base>(found - kBaseNames.begin()));
        }
        at = end + 1;
    }
    return term;
}

struct ModelFile {
    std::map<std::string, std::string, std::less<>> sources;  // by family
    std::vector<Model> models;

    ModelFile() {
        const auto json = nlohmann::json::parse(kCostModel);
        json.at("sources").get_to(sources);
        for (const auto& one : json.at("models")) {
            Model model{one.at("build"), one.at("quantity"), {}, one.at("error"), {}};
            one.at("families").get_to(model.family_errors);
            for (const auto& term : one.at("terms")) {
                model.terms.push_back(read_term(term.at(0), term.at(1)));
            }
            models.push_back(std::move(model));
        }
    }

    const Model* find(Build build, std::string_view quantity, std::string_view family) const {
        for (const Model& model : models) {
            if (model.build == build_name(build) && model.quantity == quantity &&
                model.family_errors.count(family) > 0) {
                return &model;
            }
        }
        return nullptr;
    }
};

const ModelFile& model_file() {
    static const ModelFile file;
    return file;
}

}  // namespace

const char* core_name(Core core) {
    switch (core) {
        case Core::kSpherical:
            return "spherical";
        case Core::kSpline:
            return "spline";
        default:
            return "curve";
    }
}

Core core_for(bool arcs, bool splines, Build build) {
    if (!splines) return Core::kSpherical;
    return arcs || build == Build::kSerial ? Core::kCurve : Core::kSpline;
}

std::optional<double> CostEstimate::reached() const {
    if (!mhz) return std::nullopt;
    return *mhz * 1e6 * (1 - mhz_error);
}

bool CostEstimate::fits(const Device& device) const { return fullest(device) <= 1; }

std::array<double, 3> CostEstimate::shares(const Device& device) const {
    return {std::max(lut4 / device.lut4, ff / device.ff),
            device.dsp > 0 ? static_cast<double>(dsp) / device.dsp : 0,
            static_cast<double>(ram) / device.ram};
}

double CostEstimate::size(const Device& device) const {
    const std::array<double, 3> all = shares(device);
    return std::accumulate(all.begin(), all.end(), 0.0);
}

double CostEstimate::fullest(const Device& device) const {
    const std::array<double, 3> all = shares(device);
    return *std::max_element(all.begin(), all.end());
}

bool cost_is_known(Build build, const Device& device) {
    return model_file().find(build, "lut4", device.family) != nullptr;
}

bool clock_is_known(const Device& device) {
    return model_file().find(Build::kSerial, "period_ns", device.family) != nullptr;
}

std::optional<CostEstimate> estimate(Core core, const CoreParameters& parameters,
                                     const Device& device) {
    if (parameters.networks == 0) return std::nullopt;  // no runs of it were measured
    const auto model = [&](std::string_view quantity) {
        return model_file().find(parameters.build, quantity, device.family);
    };
    const Model* const lut4 = model("lut4");
    const Model* const ff = model("ff");
    if (lut4 == nullptr || ff == nullptr) return std::nullopt;
    Values values{};
    values[kOrder] = parameters.order;
    values[kCoefBits] = parameters.coef_bits;
    values[kFineBits] = parameters.position_bits + parameters.guard_bits;
    values[kAxes] = parameters.axes();
    values[kSamples] = 1.0 / parameters.sample_interval;
    values[kArcs] = core == Core::kSpline ? 0 : 1;
    values[kSplines] = core == Core::kSpherical ? 0 : 1;
    const MultiplierCount multipliers = count_multipliers(core, parameters);
    values[kWide] = multipliers.wide;
    values[kNarrow] = multipliers.narrow;
    values[kSoft] = soft_bits(parameters, device);
    values[kWideBlock] = wide_block(parameters, device) ? 1 : 0;
    CostEstimate cost;
    cost.lut4 = lut4->predict(device.family, values);
    cost.ff = ff->predict(device.family, values);
    cost.lut4_error = lut4->error_in(device.family);
    cost.ff_error = ff->error_in(device.family);
    cost.dsp = count_dsp(core, parameters, device);
    cost.ram = count_ram(core, parameters, device);
    if (const Model* const period = model("period_ns")) {
        cost.mhz = 1000 / period->predict(device.family, values);
        if (cost.dsp > 0 && device.dsp_mhz > 0) cost.mhz = std::min(*cost.mhz, device.dsp_mhz);
        cost.mhz_error = period->error_in(device.family);
    }
    return cost;
}

std::string cost_model_source(const Device& device) {
    const auto found = model_file().sources.find(device.family);
    return found == model_file().sources.end() ? "no runs" : found->second;
}

}  // namespace curvecore::sysc
