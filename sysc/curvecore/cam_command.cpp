// SPDX-License-Identifier: Apache-2.0
// `curvecore cam`: converts a table of radii into a program, which runs as any part does, and
// checks the drawn positions against the cam's surface.
#include <fmt/format.h>

#include <algorithm>

#include "ref/cam/cam_program.hpp"
#include "ref/numeric/angles.hpp"
#include "ref/program/gcode_reader.hpp"
#include "ref/text/input_error.hpp"
#include "ref/text/text_file.hpp"
#include "sysc/cam/cam_report.hpp"
#include "sysc/commands/options/part_options.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/part/run_job.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/curvecore/commands.hpp"

namespace curvecore::sysc {
namespace {

constexpr const char* kProgram = "cam.ngc";

std::vector<std::string> remarks(const CamOptions& options, const ref::CamHelix& helix) {
    std::string surface(ref::kSurfaceNames[static_cast<std::size_t>(helix.kind.surface)]);
    if (ref::has_generatrix(helix.kind.surface)) {
        surface += " ";
        surface += ref::kGeneratrixNames[static_cast<std::size_t>(helix.kind.generatrix)];
    }
    return {"cam of " + std::filesystem::path(options.common.file).filename().string(),
            fmt::format("surface {}, kappa {:g}, delta {:g} um, {:g} mm/min over the surface",
                        surface, helix.kappa, helix.delta * 1e3, options.feed * 60),
            "X radius of the cutter's centre, Z along the axis (mm), A angle (degrees)"};
}

/// Cuts the table, section by section, into the program; `read` receives all sections, for the
/// check of the drawn cam against its surface.
CamCut cut_table(const CamOptions& options, const std::string& program,
                 std::vector<ref::CamSection>& read) {
    CamCut cut;
    std::ifstream in = ref::open_cam(options.common.file);
    ref::CamTable table(in, options.common.file);
    // The pitch of the sections is known with the second one.
    for (int i = 0; i < 2; ++i) read.push_back(*table.next());
    const double dx = read[1].x - read[0].x;
    cut.helix = helix_of(options, table.angles(), dx);
    cut.pitch = 2 * dx / cut.helix.kappa;
    ref::CamProgram writer(program, options.feed, remarks(options, cut.helix));
    double angle = 0;
    ref::CamPath path(cut.helix, table.angles(), [&](const ref::CamPiece& piece) {
        writer.piece(piece);
        cut.deviation = std::max(cut.deviation, piece.deviation);
        cut.jump = std::max(cut.jump, piece.jump);
        cut.jumps.push_back(static_cast<float>(piece.jump));
        angle = piece.to.angle;
    });
    int line = 0;
    try {
        const auto take = [&](const ref::CamSection& section) {
            line = section.line;
            path.section(section);
        };
        for (const ref::CamSection& section : read) take(section);
        while (const std::optional<ref::CamSection> section = table.next()) {
            read.push_back(*section);
            take(*section);
        }
        path.finish();
    } catch (const std::domain_error& error) {
        throw ref::InputError(table.file(), line, error.what());
    }
    writer.close();
    cut.pieces = writer.pieces();
    cut.turns = angle / ref::kTurnDegrees;
    return cut;
}

ref::CamShape truth_of(const CamOptions& options, const std::vector<ref::CamSection>& sections) {
    const ref::SurfaceKind tensor{ref::Surface::kLagrange, ref::Generatrix::kCubic};
    if (options.against.empty()) return {sections, tensor};
    std::vector<ref::CamSection> finer = ref::read_cam(options.against);
    constexpr double kSlack = 1e-6;  // mm
    if (finer.front().x > sections.front().x + kSlack ||
        finer.back().x < sections.back().x - kSlack) {
        throw ref::InputError(
            options.against, finer.front().line,
            fmt::format("sections from {:g} to {:g} mm; the cam is from {:g} to "
                        "{:g} mm",
                        finer.front().x, finer.back().x, sections.front().x, sections.back().x));
    }
    return {std::move(finer), tensor};
}

void warn_of_delta(const CamOptions& options, const ref::CamShape& surface, ref::Program& program) {
    const double own = surface.own_error();
    if (options.delta >= own) return;
    program.warnings.insert(
        program.warnings.begin(),
        fmt::format("{}: warning: delta {:g} um is below what the table itself misses, some {:.3g} "
                    "um",
                    options.common.file, options.delta * 1e3, own * 1e3));
}

struct CamChoice {
    PartOptions part;
    CamOptions cam;
};

int cam_command(CamChoice& asked) {
    CamOptions& options = asked.cam;
    options.common = asked.part.complete();
    complete(options);
    OutputFolder folder(options.common.folder);
    const std::string program = folder.path(kProgram);
    std::vector<ref::CamSection> sections;
    const CamCut cut = cut_table(options, program, sections);
    const ref::CamShape surface(sections, options.kind);
    const ref::CamShape truth = truth_of(options, sections);

    ref::Program moves = ref::read_gcode_text(ref::read_text_file(program), kProgram);
    warn_of_delta(options, surface, moves);
    CamWatch watch(surface, truth, options.delta, cut.jumps);
    Options drawn = options.common;
    drawn.program =
        std::make_shared<const ref::HeldProgram>(ref::HeldProgram{std::move(moves), {}, {}});
    Runner runner(std::move(drawn));
    watch.draws(runner.job());
    RunExtras extras;
    extras.sample = [&watch](std::size_t segment, const std::int64_t* position) {
        watch.sample(segment, position);
    };
    extras.finish = [&](const Report& report, const OutputFolder& to) {
        const CamReport cam{options, surface, cut, watch, report.duration_s()};
        to.write("cam.json", cam.json().dump(2) + "\n");
        to.write("cam.html", cam.html());
        if (!options.common.quiet && !options.common.json) {
            for (const auto& [name, value] : cam.table()) fmt::print("{:<22} {}\n", name, value);
        }
        if (!cam.held()) {
            fmt::print(stderr,
                       "curvecore: check failed: a sample is {:.3f} times as far from the "
                       "surface as it may be\n",
                       watch.of_allowed());
        }
        return cam.held();
    };
    return runner.run(folder, extras);
}

}  // namespace

void add_cam(CLI::App& app, int& status) {
    auto [command, asked] =
        add_command(app, status, "cam",
                    "a volumetric cam: TABLE of radii into a program, which runs as any part does",
                    cam_command);
    CamOptions& cam = asked.cam;
    begin_group(command, group::kInput);
    add_text(command, "TABLE", asked.part.options.file, "",
             "radii of the cutter's centre (.csv): 'x,0,7.5,..' (degrees), then a row per "
             "section: x and radii in mm")
        ->required();
    add_value(command, "--kappa", cam.kappa, "N",
              "half-turns of the spindle from section to section",
              within(plain_number, kAboveZero, 1e6, "above 0, up to 1e+06"));
    add_value(command, "--scallop", cam.scallop, "LENGTH",
              "instead: height that the cutter may leave between turns",
              in_range(length, 1e-6, 10));
    add_value(command, "--cutter", cam.cutter, "LENGTH", "radius of the cutter",
              in_range(length, 1e-3, 1e4));
    add_choice(command, "--surface", cam.kind.surface, ref::kSurfaceNames, "through the radii: {}");
    add_choice(command, "--generatrix", cam.generatrix, ref::kGeneratrixNames,
               "of tamm and blend: {}; parabola when left out");
    add_choice(command, "--ends", cam.ends, ref::kCamEndNames,
               "turn (default): once around the first and the last section too; helix: without")
        ->default_str("");
    add_value(command, "--delta", cam.delta, "LENGTH",
              "how far a piece may be off the surface, along the radius",
              in_range(length, ref::kLeastDelta, 10))
        ->default_val("5um");
    add_text(command, "--against", cam.against, "FINE.csv",
             "a finer table, to hold the drawn cam against");
    add_feed(command, asked.part, "over the surface: 1m/min, 20mm/s");
    add_surroundings(command, asked.part);
    add_timed_core(command, asked.part);
    add_drawing(command, asked.part);
}

}  // namespace curvecore::sysc
