// SPDX-License-Identifier: Apache-2.0
// `curvecore cam`: converts a table of radii into a program, which runs as any part does, and
// checks the drawn positions against the cam's surface.
#include "sysc/curvecore/cam_command.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/cam/cam_program.hpp"
#include "ref/program/gcode_reader.hpp"
#include "ref/text/input_error.hpp"
#include "ref/text/text_file.hpp"
#include "sysc/cam/cam_report.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/commands/part/run_job.hpp"

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
    cut.turns = angle / ref::kTurn;
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

}  // namespace

int cam_command(const CamOptions& options) {
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
        if (!options.common.quiet) {
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

}  // namespace curvecore::sysc
