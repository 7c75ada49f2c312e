// SPDX-License-Identifier: Apache-2.0
#include "sysc/cache/dut_ports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cstdlib>
#include <set>
#include <stdexcept>

namespace curvecore::sysc {
namespace {

using Node = boost::property_tree::ptree;

std::string attribute(const Node& node, const char* name) {
    return node.get<std::string>(std::string("<xmlattr>.") + name, "");
}

/// Adds the modules that are inside others.
void find_inside(const Node& node, std::set<std::string>& inside) {
    for (const auto& [kind, child] : node) {
        if (kind == "instance") inside.insert(attribute(child, "defName"));
        find_inside(child, inside);
    }
}

/// Value of a number such as 32'sh1f.
int number_of(const std::string& text) {
    return static_cast<int>(std::strtol(text.c_str() + text.find('h') + 1, nullptr, 16));
}

/// Widths of a design's types.
class Types {
  public:
    explicit Types(const Node& table) {
        for (const auto& [kind, type] : table) {
            types_.emplace(attribute(type, "id"), Type{kind, &type});
        }
    }

    int bits(const std::string& id) const {
        const auto found = types_.find(id);
        if (found == types_.end()) return 0;
        const auto& [kind, node] = found->second;
        const auto inner = [this, node = node] { return bits(attribute(*node, "sub_dtype_id")); };
        if (kind == "refdtype" || kind == "enumdtype") return inner();
        if (kind == "packarraydtype") {
            std::vector<int> ends;
            for (const auto& [name, end] : node->get_child("range")) {
                if (name == "const") ends.push_back(number_of(attribute(end, "name")));
            }
            return (std::abs(ends.at(0) - ends.at(1)) + 1) * inner();
        }
        if (kind != "basicdtype") return 0;
        return std::abs(node->get("<xmlattr>.left", 0) - node->get("<xmlattr>.right", 0)) + 1;
    }

  private:
    struct Type {
        std::string kind;
        const Node* node;
    };
    std::map<std::string, Type> types_;
};

TopModule module_of(const Node& node, const Types& types) {
    TopModule module{attribute(node, "name"), {}, {}};
    for (const auto& [kind, variable] : node) {
        if (kind != "var") continue;
        const std::string name = attribute(variable, "origName");
        if (attribute(variable, "param") == "true") module.parameters.push_back(name);
        const std::string direction = attribute(variable, "dir");
        if (direction.empty()) continue;
        module.ports[name] = {direction, types.bits(attribute(variable, "dtype_id"))};
    }
    return module;
}

std::string bits_text(int bits) {
    return bits == 0 ? "no vector of bits" : fmt::format("{} bit{}", bits, bits == 1 ? "" : "s");
}

}  // namespace

std::vector<TopModule> top_modules(const std::filesystem::path& xml) {
    try {
        Node root;
        boost::property_tree::read_xml(xml.string(), root);
        const Node& design = root.get_child("verilator_xml.netlist");
        const Types types(design.get_child("typetable"));
        std::set<std::string> inside;
        find_inside(design, inside);
        std::vector<TopModule> modules;
        for (const auto& [kind, node] : design) {
            if (kind != "module" || inside.count(attribute(node, "name")) != 0) continue;
            modules.push_back(module_of(node, types));
        }
        return modules;
    } catch (const boost::property_tree::ptree_error& error) {
        throw std::runtime_error(fmt::format("Verilator's XML is another: {}", error.what()));
    }
}

const TopModule* likest(const std::vector<TopModule>& modules, const TopModule& core) {
    const TopModule* best = nullptr;
    std::ptrdiff_t most = 0;
    for (const TopModule& module : modules) {
        const std::ptrdiff_t common =
            std::count_if(module.ports.begin(), module.ports.end(),
                          [&](const auto& port) { return core.ports.count(port.first) != 0; });
        if (common <= most) continue;
        most = common;
        best = &module;
    }
    return best;
}

std::string lacking_ports(const TopModule& module, const TopModule& core) {
    std::vector<std::string> all;
    for (const auto& [name, wanted] : core.ports) {
        const auto found = module.ports.find(name);
        if (found == module.ports.end()) {
            all.push_back(fmt::format("it has no {} {} of {}", wanted.direction, name,
                                      bits_text(wanted.bits)));
        } else if (found->second.direction != wanted.direction) {
            all.push_back(fmt::format("its {} is an {}, expected is an {}", name,
                                      found->second.direction, wanted.direction));
        } else if (found->second.bits != wanted.bits) {
            all.push_back(fmt::format("its {} has {}, expected are {}", name,
                                      bits_text(found->second.bits), wanted.bits));
        }
    }
    constexpr std::size_t kShown = 5;
    if (all.size() <= kShown) return fmt::format("{}", fmt::join(all, "; "));
    const std::size_t more = all.size() - kShown;
    all.resize(kShown);
    return fmt::format("{}; and {} more", fmt::join(all, "; "), more);
}

}  // namespace curvecore::sysc
