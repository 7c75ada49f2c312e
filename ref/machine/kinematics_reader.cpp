// SPDX-License-Identifier: Apache-2.0
#include "ref/machine/kinematics_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr double kLargestJointRatio = 1000;

/// Modules of LinuxCNC that do no more than name the axes.
constexpr std::array<std::string_view, 2> kAlsoTrivial{"gentrivkins", "gantrykins"};

std::string first_word(const std::string& text) {
    return text.substr(0, text.find_first_of(" \t"));
}

class KinematicsReader {
  public:
    KinematicsReader(const IniFile& ini, double unit) : ini_(ini), unit_(unit) {}

    Kinematics read() const {
        const std::optional<IniEntry> entry = ini_.find("KINS", "KINEMATICS");
        if (!entry) return {};
        const std::string name = first_word(entry->value);
        if (std::find(kAlsoTrivial.begin(), kAlsoTrivial.end(), name) != kAlsoTrivial.end()) {
            return {};
        }
        Kinematics found;
        if (!one_of(name, found, std::make_index_sequence<std::variant_size_v<Kinematics>>())) {
            throw InputError(ini_.file(), entry->line,
                             fmt::format("KINEMATICS = {}: one of {}; without [KINS] X Y Z are "
                                         "drawn as they are",
                                         name, fmt::join(kinematics_names(), ", ")));
        }
        return found;
    }

  private:
    template <std::size_t... I>
    bool one_of(const std::string& name, Kinematics& found,
                std::index_sequence<I...> /*all*/) const {
        return (is<std::variant_alternative_t<I, Kinematics>>(name, found) || ...);
    }

    template <class Of>
    bool is(const std::string& name, Kinematics& found) const {
        if (name != Of::kName) return false;
        if (!std::is_same_v<Of, TrivialKinematics>) {
            check_names<Of>(*ini_.find("KINS", "KINEMATICS"));
        }
        found = with_parameters<Of>(std::make_index_sequence<Of::kParameters.size()>());
        return true;
    }

    template <class Of, std::size_t... I>
    Of with_parameters(std::index_sequence<I...> /*all*/) const {
        return Of{parameter(std::string(Of::kName), Of::kParameters[I])...};
    }

    double parameter(const std::string& of, const KinematicsParameter& asked) const {
        using Kind = KinematicsParameter::Kind;
        const std::string name(asked.name);
        const std::optional<double> value = ini_.number("KINS", name);
        const int line = ini_.find("KINS", value ? name : "KINEMATICS")->line;
        if (!value && !asked.value) {
            throw InputError(ini_.file(), line, fmt::format("{} needs {} in [KINS]", of, name));
        }
        if (value && asked.kind == Kind::kLength && !(*value > 0)) {
            throw InputError(ini_.file(), line,
                             fmt::format("{} = {:g}: a length above 0", name, *value));
        }
        if (value && name == "ELBOW" && std::abs(*value) != 1) {
            throw InputError(ini_.file(), line,
                             fmt::format("ELBOW = {:g}: the sign of joint 1, 1 or -1", *value));
        }
        return value ? *value * (asked.kind == Kind::kNumber ? 1 : unit_) : *asked.value;
    }

    /// Refuses what would make another machine of it.
    template <class Of>
    void check_names(const IniEntry& entry) const {
        if (entry.value.find("sparm") != std::string::npos) {
            throw InputError(ini_.file(), entry.line,
                             fmt::format("KINEMATICS = {}: without sparm: the kinematics do not "
                                         "change within a program here",
                                         entry.value));
        }
        for (const auto& [place, value] : ini_.numbers()) {
            constexpr std::string_view kSection = "[KINS]";
            if (place.rfind(kSection, 0) != 0) continue;
            const std::string name = place.substr(kSection.size());
            const bool known =
                name == "JOINTS" || name == "JOINT_RATIO" ||
                std::any_of(Of::kParameters.begin(), Of::kParameters.end(),
                            [&](const KinematicsParameter& of) { return of.name == name; });
            if (known || value == 0) continue;
            throw InputError(ini_.file(), ini_.find("KINS", name)->line,
                             fmt::format("{} takes no {} here", Of::kName, name));
        }
    }

    const IniFile& ini_;
    double unit_;
};

}  // namespace

Kinematics read_kinematics(const IniFile& ini, double unit) {
    return KinematicsReader(ini, unit).read();
}

double read_joint_ratio(const IniFile& ini, double otherwise) {
    const std::optional<double> ratio = ini.number("KINS", "JOINT_RATIO");
    if (!ratio) return otherwise;
    if (*ratio >= otherwise && *ratio <= kLargestJointRatio) return *ratio;
    throw InputError(ini.file(), ini.find("KINS", "JOINT_RATIO")->line,
                     fmt::format("JOINT_RATIO = {:g}: {:g} .. {:g}, what a joint goes for a mm of "
                                 "the tool",
                                 *ratio, otherwise, kLargestJointRatio));
}

}  // namespace curvecore::ref
