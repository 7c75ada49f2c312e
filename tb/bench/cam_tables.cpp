// SPDX-License-Identifier: Apache-2.0
// Prints the figures of [Tamm]'s scheme on a sample cam in closed form, and writes them as JSON.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>

#include "ref/cam/cam_program.hpp"
#include "ref/cam/cam_shape.hpp"
#include "tb/bench/claim_table.hpp"
#include "tb/support/judge/cam_claims.hpp"

namespace {

using namespace curvecore;
using namespace curvecore::ref;
using curvecore::tb::Table;
using tb::radians;
using tb::sample_cam;

/// Worst error, mm, on a grid of `places` (even) in each cell and direction: corners and mid-lines.
template <class Radius>
double worst_error(int n, double dx, int intervals, int places, const Radius& radius) {
    double worst = 0;
    for (int i = 0; i <= intervals * places; ++i) {
        const double x = dx * i / places;
        for (int m = 0; m < n * places; ++m) {
            const double degrees = 360. * m / (n * places);
            worst = std::max(worst, std::abs(radius(x, degrees) - sample_cam(x, radians(degrees))));
        }
    }
    return worst;
}

CamShape shape_of(SurfaceKind kind, int n, int intervals) {
    const double dx = 100. / intervals;
    return {tb::sample_cam_table(n, dx, intervals + 3, -dx), kind};
}

double surface_error(SurfaceKind kind, int n, int intervals, int places) {
    const CamShape shape = shape_of(kind, n, intervals);
    return worst_error(n, 100. / intervals, intervals, places,
                       [&](double x, double degrees) { return shape.at(x, degrees).rho; });
}

Table pieces_table() {
    Table table{
        "cam_pieces",
        "Archimedean pieces a turn by delta (section x = 50 mm of a cam of 30 to 54 mm), of "
        "24, 48 and 72 radii, and as delta asks for where no knot cuts them",
        {"delta, um", "24 radii", "48", "72", "no knots"},
        {}};
    const CamShape exact = shape_of(tb::kTensor, 72, 20);
    for (const double delta : {0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001}) {
        std::vector<std::string> row{fmt::format("{:g}", delta * 1e3)};
        for (const int n : {24, 48, 72}) {
            const std::vector<double> rho = tb::sample_cam_table(n, 1, 1, 50)[0].rho;
            row.push_back(std::to_string(tb::pieces_a_turn(rho, delta)));
        }
        row.push_back(fmt::format("{:.0f}", exact.pieces_per_turn(50, delta)));
        table.rows.push_back(row);
    }
    return table;
}

Table surfaces_table() {
    Table table{
        "cam_surfaces",
        "Error of the surfaces / largest jump, um, of 48 radii by the pitch of the sections",
        {"surface", "20 mm", "10 mm", "5 mm", "2.5 mm"},
        {}};
    for (const SurfaceKind kind : tb::all_kinds()) {
        std::string name(kSurfaceNames[static_cast<std::size_t>(kind.surface)]);
        if (has_generatrix(kind.surface)) {
            name += ", ";
            name += kGeneratrixNames[static_cast<std::size_t>(kind.generatrix)];
        }
        std::vector<std::string> row{name};
        for (const int intervals : {5, 10, 20, 40}) {
            const double jump = shape_of(kind, 48, intervals).largest_jump() * 1e3;
            row.push_back(fmt::format("{:.2g} / {:.2g}",
                                      surface_error(kind, 48, intervals, 4) * 1e3,
                                      jump < 1e-6 ? 0 : jump));
        }
        table.rows.push_back(row);
    }
    return table;
}

Table input_table() {
    Table table{"cam_input",
                "Tables read by cubics both ways, and how many radii a table has that is read "
                "linearly and keeps the same error",
                {"angles x sections", "error, um", "radii", "read linearly", "times as many"},
                {}};
    const CamShape exact = shape_of(tb::kTensor, 96, 40);
    for (const auto& [n, intervals] : {std::pair(16, 6), std::pair(20, 9), std::pair(24, 12),
                                       std::pair(28, 15), std::pair(36, 20), std::pair(48, 24)}) {
        const double error = surface_error(tb::kTensor, n, intervals, 6);
        const int radii = n * (intervals + 1);
        const double linear = exact.linear_radii(error);
        table.rows.push_back({fmt::format("{} x {}", n, intervals + 1),
                              fmt::format("{:.3g}", error * 1e3), std::to_string(radii),
                              fmt::format("{:.0f}", linear),
                              fmt::format("{:.1f}", linear / radii)});
    }
    return table;
}

Table stages_table() {
    Table table{"cam_stages",
                "A section (x = 50 mm) by the angle between its radii: they are joined by "
                "Archimedean spirals, or by cubics that spirals follow within delta",
                {"angle, degrees", "spirals alone are off, um", "cubics are off, um"},
                {}};
    for (const int n : {180, 120, 72, 48, 36, 24}) {
        const tb::StageErrors off = tb::stage_errors(sample_cam, 50, n);
        table.rows.push_back({fmt::format("{:g}", 360. / n),
                              fmt::format("{:.3g}", off.spirals * 1e3),
                              fmt::format("{:.2g}", off.cubics * 1e3)});
    }
    return table;
}

Table concave_table() {
    Table table{"cam_concave",
                "Mean length of a piece, degrees, on parts that bend inwards and outwards "
                "(delta 10 um)",
                {"section", "concave", "convex", "times shorter"},
                {}};
    const auto row = [&table](const char* name, const auto& radius) {
        const tb::MeanSteps steps = tb::mean_steps(radius, 0.01);
        const bool both = steps.concave > 0;
        table.rows.push_back({name, both ? fmt::format("{:.2f}", steps.concave) : "-",
                              fmt::format("{:.2f}", steps.convex),
                              both ? fmt::format("{:.1f}", steps.convex / steps.concave) : "-"});
    };
    row("40 + 8 cos 3 theta", [](double theta) { return 40 + 8 * std::cos(3 * theta); });
    row("40 + 2 cos 6 theta", [](double theta) { return 40 + 2 * std::cos(6 * theta); });
    row("eccentric with concave flanks", [](double theta) { return tb::harmonic_cam(0, theta); });
    row("base circle with a lobe", [](double theta) { return tb::lobe_cam(0, theta); });
    row("circle, 5 mm off its centre", [](double theta) {
        return 5 * std::cos(theta) + std::sqrt(1600 - std::pow(5 * std::sin(theta), 2));
    });
    return table;
}

/// Table of the whole sample cam: a cutter of 10 mm, scallops of 5 um, 6 m/min.
Table time_table() {
    Table table{
        "cam_time",
        "All of the cam's helix from 48 radii every 5 mm, scallops of 5 um: the time that "
        "computing and machining take, and pieces beside pieces of one length",
        {"delta, um", "pieces", "computed in, ms", "us a piece", "machined at 6 m/min in, s",
         "computing, of machining", "of one length", "times as many"},
        {}};
    constexpr double kFeed = 100;  // mm/s
    const std::vector<CamSection> sections = tb::sample_cam_table(48, 5, 21);
    for (const double delta : {0.02, 0.01, 0.005, 0.002}) {
        CamHelix helix;
        helix.delta = delta;
        helix.kappa = kappa_for(scallop_pitch(10, 5e-3), 5, 48);
        std::size_t pieces = 0;
        double length = 0, angle = 0;
        const auto begin = std::chrono::steady_clock::now();
        CamPath path(helix, 48, [&](const CamPiece& piece) {
            ++pieces;
            length += surface_length(piece);
            angle = piece.to.angle;
        });
        for (const CamSection& section : sections) path.section(section);
        path.finish();
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        double even = 0;
        for (const CamSection& section : sections) {
            even = std::max(even,
                            tb::even_pieces_a_turn(
                                [&](double theta) { return sample_cam(section.x, theta); }, delta));
        }
        const auto count = static_cast<double>(pieces);
        const double share = took.count() / (length / kFeed);
        table.rows.push_back({fmt::format("{:g}", delta * 1e3), std::to_string(pieces),
                              fmt::format("{:.0f}", took.count() * 1e3),
                              fmt::format("{:.1f}", took.count() * 1e6 / count),
                              fmt::format("{:.0f}", length / kFeed),
                              share < 0.01 ? "below 1 %" : fmt::format("{:.0f} %", share * 100),
                              fmt::format("{:.0f}", even * angle / 360),
                              fmt::format("{:.1f}", even * angle / 360 / count)});
    }
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Cams: pieces, surfaces, input saved");
    std::string json_path;
    app.add_option("-o,--json", json_path, "write {tables: {NAME: {claim, header, rows}}}");
    CLI11_PARSE(app, argc, argv);
    std::vector<Table> tables;
    for (const auto make :
         {pieces_table, surfaces_table, input_table, stages_table, concave_table, time_table}) {
        tables.push_back(make());
        print(tables.back());
    }
    return curvecore::tb::write_tables(tables, json_path);
}
