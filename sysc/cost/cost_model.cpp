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

    bool knows(std::string_view family) const {
        return std::any_of(terms.begin(), terms.end(), [&](const Term& term) {
            return term.family == family && term.factors.empty();
        });
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
    std::string source;
    std::vector<Model> models;

    ModelFile() {
        const auto json = nlohmann::json::parse(kCostModel);
        source = json.at("source");
        for (const auto& one : json.at("models")) {
            Model model{one.at("build"), one.at("quantity"), {}, one.at("error"), {}};
            one.at("families").get_to(model.family_errors);
            for (const auto& term : one.at("terms")) {
                model.terms.push_back(read_term(term.at(0), term.at(1)));
            }
            models.push_back(std::move(model));
        }
    }

    const Model* find(std::string_view build, std::string_view quantity) const {
        for (const Model& model : models) {
            if (model.build == build && model.quantity == quantity) return &model;
        }
        return nullptr;
    }
};

const ModelFile& model_file() {
    static const ModelFile file;
    return file;
}

/// Models of one build: LUT4, flip-flops and period.
struct BuildModels {
    const Model* lut4;
    const Model* ff;
    const Model* period;

    explicit BuildModels(Build build)
        : lut4(model_file().find(build_name(build), "lut4")),
          ff(model_file().find(build_name(build), "ff")),
          period(model_file().find(build_name(build), "period_ns")) {}

    bool know(std::string_view family) const {
        return lut4 != nullptr && ff != nullptr && period != nullptr && lut4->knows(family) &&
               ff->knows(family) && period->knows(family);
    }
};

const BuildModels& models_of(Build build) {
    static const BuildModels serial(Build::kSerial);
    static const BuildModels parallel(Build::kParallel);
    return build == Build::kSerial ? serial : parallel;
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
    return models_of(build).know(device.family);
}

std::optional<CostEstimate> estimate(Core core, const CoreParameters& parameters,
                                     const Device& device) {
    if (!cost_is_known(parameters.build, device)) return std::nullopt;
    const BuildModels& models = models_of(parameters.build);
    Values values{};
    values[kOrder] = parameters.order;
    values[kCoefBits] = parameters.coef_bits;
    values[kFineBits] = parameters.position_bits + parameters.guard_bits;
    values[kAxes] = parameters.axes();
    values[kSamples] = 1.0 / parameters.sample_interval;
    values[kArcs] = core == Core::kSpline ? 0 : 1;
    values[kSplines] = core == Core::kSpherical ? 0 : 1;
    values[kWide] = mean_wide(core, parameters);
    values[kNarrow] = count_multipliers(core, parameters).narrow;
    values[kSoft] = soft_bits(parameters, device);
    values[kWideBlock] = wide_block(parameters, device) ? 1 : 0;
    CostEstimate cost;
    cost.lut4 = models.lut4->predict(device.family, values);
    cost.ff = models.ff->predict(device.family, values);
    cost.mhz = 1000 / models.period->predict(device.family, values);
    cost.dsp = count_dsp(core, parameters, device);
    cost.ram = count_ram(core, parameters, device);
    if (cost.dsp > 0 && device.dsp_mhz > 0) cost.mhz = std::min(cost.mhz, device.dsp_mhz);
    cost.lut4_error = models.lut4->error_in(device.family);
    cost.ff_error = models.ff->error_in(device.family);
    cost.mhz_error = models.period->error_in(device.family);
    return cost;
}

std::string cost_model_source() { return model_file().source; }

}  // namespace curvecore::sysc
