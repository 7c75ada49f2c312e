// SPDX-License-Identifier: Apache-2.0
#include "sysc/cam/cam_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "sysc/cam/cam_template.hpp"
#include "sysc/cli/html_page.hpp"
#include "sysc/report/report.hpp"

namespace curvecore::sysc {
namespace {

/// Length as text in um; below a picometre the value is rounding and shown as 0.
std::string um(double mm) { return fmt::format("{:.4g} um", mm < 1e-9 ? 0 : mm * 1e3); }

void map(fmt::memory_buffer& text, const char* name, const std::vector<double>& cells) {
    auto out = std::back_inserter(text);
    fmt::format_to(out, ",\n\"{}\":[", name);
    const char* comma = "";
    for (const double cell : cells) {
        if (std::isnan(cell)) {
            fmt::format_to(out, "{}null", comma);
        } else {
            fmt::format_to(out, "{}{:.4g}", comma, cell * 1e3);
        }
        comma = ",";
    }
    text.push_back(']');
}

}  // namespace

double CamReport::scallop() const {
    return options.cutter > 0 ? ref::scallop_height(options.cutter, cut.pitch) : 0;
}

double CamReport::asymptotic() const {
    double sum = 0;
    for (std::size_t i = 0; i < surface.sections(); ++i) {
        sum += surface.pieces_per_turn(surface.first_x() + static_cast<double>(i) * surface.pitch(),
                                       cut.helix.delta);
    }
    return sum / static_cast<double>(surface.sections());
}

double CamReport::radii() const {
    return static_cast<double>(surface.sections()) * surface.angles();
}

double CamReport::linear_radii() const {
    return surface.linear_radii(std::max(watch.from_truth().most, cut.helix.delta));
}

nlohmann::ordered_json CamReport::json() const {
    nlohmann::ordered_json json;
    const auto surface_kind = static_cast<std::size_t>(options.kind.surface);
    json["input"] = options.common.file;
    json["sections"] = surface.sections();
    json["angles"] = surface.angles();
    json["section_pitch_mm"] = surface.pitch();
    json["surface"] = ref::kSurfaceNames[surface_kind];
    if (ref::has_generatrix(options.kind.surface)) {
        json["generatrix"] =
            ref::kGeneratrixNames[static_cast<std::size_t>(options.kind.generatrix)];
    }
    json["kappa"] = cut.helix.kappa;
    json["pitch_mm"] = cut.pitch;
    json["turns"] = cut.turns;
    json["ends"] = ref::kCamEndNames[static_cast<std::size_t>(cut.helix.ends)];
    json["delta_mm"] = cut.helix.delta;
    json["feed_mm_per_s"] = options.feed;
    json["duration_s"] = duration_s;
    json["pieces"] = cut.pieces;
    json["pieces_per_turn"] = static_cast<double>(cut.pieces) / cut.turns;
    json["asymptotic_pieces_per_turn"] = asymptotic();
    json["worst_piece_mm"] = cut.deviation;
    json["jump_mm"] = {{"on_path", cut.jump}, {"of_surface", surface.largest_jump()}};
    if (options.cutter > 0) json["scallop_mm"] = scallop();
    json["table_error_mm"] = surface.own_error();
    const auto error = [&](const SurfaceError& found) {
        return nlohmann::ordered_json{{"max_mm", found.most},
                                      {"rms_mm", found.rms(watch.samples())},
                                      {"x_mm", found.x},
                                      {"angle_degrees", found.degrees}};
    };
    json["samples_on_surface"] = watch.samples();
    json["from_surface"] = error(watch.from_surface());
    json["from_surface"]["of_allowed"] = watch.of_allowed();
    json["from_truth"] = error(watch.from_truth());
    json["truth"] = options.against.empty() ? "the table's tensor surface" : options.against;
    json["radii"] = {{"table", radii()},
                     {"read_linearly", std::ceil(linear_radii())},
                     {"saved_times", linear_radii() / radii()}};
    return json;
}

std::vector<std::pair<std::string, std::string>> CamReport::table() const {
    std::vector<std::pair<std::string, std::string>> rows;
    const auto kind = static_cast<std::size_t>(options.kind.surface);
    rows.emplace_back("cam", fmt::format("{} sections every {:g} mm, {} radii each",
                                         surface.sections(), surface.pitch(), surface.angles()));
    rows.emplace_back(
        "surface",
        std::string(ref::kSurfaceNames[kind]) +
            (ref::has_generatrix(options.kind.surface)
                 ? fmt::format(
                       ", generatrix {}",
                       ref::kGeneratrixNames[static_cast<std::size_t>(options.kind.generatrix)])
                 : ""));
    rows.emplace_back(
        "helix",
        fmt::format(
            "kappa {:g}: {:.4g} mm a turn, {:.4g} turns{}", cut.helix.kappa, cut.pitch, cut.turns,
            cut.helix.ends == ref::CamEnds::kTurn ? ", the first and the last on a section" : ""));
    if (options.cutter > 0) rows.emplace_back("scallop", um(scallop()));
    rows.emplace_back("pieces",
                      fmt::format("{}: {:.1f} a turn; {:.1f} if no knot cut them", cut.pieces,
                                  static_cast<double>(cut.pieces) / cut.turns, asymptotic()));
    rows.emplace_back("worst piece", fmt::format("{} of {} off the surface", um(cut.deviation),
                                                 um(cut.helix.delta)));
    rows.emplace_back("jumps", fmt::format("{} on the path, {} on all of the surface", um(cut.jump),
                                           um(surface.largest_jump())));
    rows.emplace_back("samples off surface",
                      fmt::format("{} at worst, {:.3f} of what is allowed",
                                  um(watch.from_surface().most), watch.of_allowed()));
    rows.emplace_back(options.against.empty() ? "off tensor surface" : "off finer table",
                      fmt::format("{} at worst, {} rms", um(watch.from_truth().most),
                                  um(watch.from_truth().rms(watch.samples()))));
    rows.emplace_back("the table's own error", um(surface.own_error()) + " estimated");
    rows.emplace_back("input", fmt::format("{:g} radii; read linearly {:.0f} for the same error",
                                           radii(), linear_radii()));
    return rows;
}

std::string CamReport::html() const {
    nlohmann::ordered_json head;
    head["title"] = std::filesystem::path(options.common.file).filename().string();
    head["held"] = held();
    for (const auto& [name, value] : table()) head["table"].push_back({name, value});
    head["truth"] = options.against.empty() ? "the table's tensor surface"
                                            : std::filesystem::path(options.against).filename();
    head["around"] = ErrorMap::kAround;
    head["along"] = ErrorMap::kAlong;
    head["first_x"] = surface.first_x();
    head["last_x"] = surface.last_x();
    head["delta_um"] = cut.helix.delta * 1e3;
    std::vector<double> rho;
    for (int row = 0; row < ErrorMap::kAlong; ++row) {
        for (int column = 0; column < ErrorMap::kAround; ++column) {
            const double x = surface.first_x() + (surface.last_x() - surface.first_x()) *
                                                     (row + 0.5) / ErrorMap::kAlong;
            rho.push_back(surface.at(x, 360 * (column + 0.5) / ErrorMap::kAround).rho * 1e-3);
        }
    }
    std::string text = page_json(head);
    text.pop_back();  // the closing brace
    fmt::memory_buffer rest;
    map(rest, "rho", rho);
    map(rest, "off_surface", watch.surface_map().cells());
    map(rest, "off_truth", watch.truth_map().cells());
    return html_page(kCamTemplate, text + fmt::to_string(rest) + "}");
}

}  // namespace curvecore::sysc
