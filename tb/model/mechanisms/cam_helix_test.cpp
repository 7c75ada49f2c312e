// SPDX-License-Identifier: Apache-2.0
// The helix over a cam, cut into pieces; invalid tables of radii.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "ref/cam/cam_path.hpp"
#include "ref/cam/cam_shape.hpp"
#include "ref/text/input_error.hpp"
#include "ref/text/text_file.hpp"
#include "tb/support/programs/mutator.hpp"
#include "tb/support/programs/sample_cam.hpp"

namespace curvecore::tb::cam_helix_test {

using ref::CamPath;
using ref::CamPiece;
using ref::CamShape;
using ref::Generatrix;
using ref::Surface;
using ref::SurfaceKind;

struct Walk {
    std::vector<CamPiece> pieces;
    std::vector<std::size_t> after_section;  // pieces so far
};

Walk walk(const ref::CamHelix& helix, const std::vector<ref::CamSection>& table) {
    Walk walk;
    CamPath path(helix, static_cast<int>(table[0].rho.size()),
                 [&](const CamPiece& piece) { walk.pieces.push_back(piece); });
    for (const ref::CamSection& section : table) {
        path.section(section);
        walk.after_section.push_back(walk.pieces.size());
    }
    path.finish();
    return walk;
}

double off(const CamShape& shape, const CamPiece& piece, double part) {
    const auto at = [part](double from, double to) { return from + (to - from) * part; };
    const double rho = at(piece.from.rho, piece.to.rho);
    return std::abs(
        rho - shape.at(at(piece.from.x, piece.to.x), at(piece.from.angle, piece.to.angle)).rho);
}

TEST(CamHelix, PiecesKeepDeltaWithTheirRounding) {
    for (const SurfaceKind kind : {kTensor, kSmooth}) {
        for (const double delta : {0.02, 1e-3, 2e-5}) {
            ref::CamHelix helix;
            helix.kind = kind;
            helix.kappa = 3;
            helix.delta = delta;
            const std::vector<ref::CamSection> table = sample_cam_table(24, 20, 6);
            const CamShape shape(table, kind);
            double worst = 0;
            for (const CamPiece& piece : walk(helix, table).pieces) {
                ASSERT_LE(piece.deviation, delta * (1 + 1e-6));
                for (int i = 0; i <= 8; ++i) {
                    const double error = off(shape, piece, i / 8.);
                    ASSERT_LE(error, piece.deviation * (1 + 1e-6) + 1e-9);
                    worst = std::max(worst, error);
                }
            }
            EXPECT_GT(worst, 0.9 * delta);
        }
    }
}

TEST(CamHelix, SurfacesThatJumpAreKeptToWithinTheirJump) {
    for (const SurfaceKind kind : all_kinds()) {
        ref::CamHelix helix;
        helix.kind = kind;
        helix.kappa = 2;
        const std::vector<ref::CamSection> table = sample_cam_table(24, 10, 11);
        const CamShape shape(table, kind);
        double jump = 0;
        for (const CamPiece& piece : walk(helix, table).pieces) {
            jump = std::max(jump, piece.jump);
            for (int i = 1; i < 8; ++i) {
                ASSERT_LE(off(shape, piece, i / 8.), helix.delta + piece.jump + 1e-6);
            }
        }
        EXPECT_LE(jump, shape.largest_jump() + 1e-5);
        EXPECT_EQ(jump > 1e-5,
                  kind.surface == Surface::kTamm || (kind.surface == Surface::kBlend &&
                                                     kind.generatrix == Generatrix::kParabola));
    }
}

TEST(CamHelix, IsOneHelixFromTheFirstSectionToTheLast) {
    ref::CamHelix helix;
    helix.kappa = 2.5;  // 2.5 * 24 / 2 = 30 intervals per section
    helix.ends = ref::CamEnds::kHelix;
    const std::vector<ref::CamSection> table = sample_cam_table(24, 10, 11);
    const Walk found = walk(helix, table);
    EXPECT_EQ(found.pieces.front().from.x, 0);
    EXPECT_EQ(found.pieces.front().from.angle, 0);
    EXPECT_NEAR(found.pieces.back().to.x, 100, 1e-6);
    EXPECT_NEAR(found.pieces.back().to.angle, 10 * 30 * 15., 1e-5);
    for (std::size_t i = 0; i < found.pieces.size(); ++i) {
        const CamPiece& piece = found.pieces[i];
        EXPECT_NEAR(piece.to.x, piece.to.angle / 360 * 2 * 10 / 2.5, 1e-6);  // H = 2 Dx / kappa
        EXPECT_NEAR(piece.to.rho, sample_cam(piece.to.x, radians(piece.to.angle)), 0.1);
        if (i == 0) continue;
        EXPECT_EQ(piece.from.angle, found.pieces[i - 1].to.angle);
        EXPECT_EQ(piece.from.rho, found.pieces[i - 1].to.rho);
    }
}

// Without the turns a cutter leaves a wedge of one pitch on both faces.
TEST(CamHelix, TurnsOnceOnTheFirstSectionAndOnceOnTheLast) {
    for (const int count : {2, 3, 4, 6}) {
        for (const SurfaceKind kind : all_kinds()) {
            ref::CamHelix helix;
            helix.kind = kind;
            helix.kappa = 2.5;
            const std::vector<ref::CamSection> table = sample_cam_table(24, 10, count, 5);
            const CamShape shape(table, kind);
            const Walk found = walk(helix, table);
            const double end = 5 + 10. * (count - 1);
            const double turns = (count - 1) * 2.5 / 2 + 2;
            EXPECT_NEAR(found.pieces.back().to.angle, 360 * turns, 1e-5);
            for (const CamPiece& piece : found.pieces) {
                const double along = (piece.to.angle / 360 - 1) * 2 * 10 / 2.5;  // of the helix
                ASSERT_NEAR(piece.to.x, std::clamp(5 + along, 5., end), 1e-6);
                for (const double part : {0.25, 0.5, 0.75}) {
                    ASSERT_LE(off(shape, piece, part), helix.delta + piece.jump + 1e-6);
                }
            }
            helix.ends = ref::CamEnds::kHelix;
            const Walk paper = walk(helix, table);
            EXPECT_NEAR(paper.pieces.back().to.angle, 360 * (turns - 2), 1e-5);
            EXPECT_LT(paper.pieces.size(), found.pieces.size());
        }
    }
}

TEST(CamHelix, StreamsWithFourSections) {
    ref::CamHelix helix;
    helix.kappa = 2;
    const Walk found = walk(helix, sample_cam_table(24, 10, 11));
    EXPECT_EQ(found.after_section[2], 0U);
    for (std::size_t i = 3; i < 11; ++i) {
        ASSERT_GT(found.after_section[i], found.after_section[i - 1]);
        // All pieces up to the section before the last one that came.
        EXPECT_NEAR(found.pieces[found.after_section[i] - 1].to.x, 10. * (i - 1), 1e-6);
    }
}

TEST(CamHelix, ShortTablesHaveGhostsOfLowerOrder) {
    for (const int count : {2, 3, 4}) {
        for (const SurfaceKind kind : all_kinds()) {
            ref::CamHelix helix;
            helix.kind = kind;
            const auto found = walk(helix, sample_cam_table(24, 10, count));
            EXPECT_NEAR(found.pieces.back().to.x, 10 * (count - 1), 1e-6);
            for (const CamPiece& piece : found.pieces) {
                EXPECT_NEAR(piece.to.rho, sample_cam(piece.to.x, radians(piece.to.angle)), 0.7);
            }
        }
    }
}

TEST(CamHelix, WantsWholeIntervalsAndADelta) {
    const auto make = [](double kappa, int angles, double delta) {
        ref::CamHelix helix;
        helix.kappa = kappa;
        helix.delta = delta;
        CamPath path(helix, angles, [](const CamPiece&) {});
    };
    EXPECT_NO_THROW(make(31.5, 24, 1e-3));
    EXPECT_NO_THROW(make(2, 7, 1e-3));
    EXPECT_THROW(make(31.6, 24, 1e-3), std::invalid_argument);
    EXPECT_THROW(make(1, 7, 1e-3), std::invalid_argument);
    EXPECT_THROW(make(0, 24, 1e-3), std::invalid_argument);
    EXPECT_THROW(make(2, 24, 1e-6), std::invalid_argument);
}

TEST(CamHelix, ScallopsGiveThePitch) {
    const double pitch = ref::scallop_pitch(10, 0.005);
    EXPECT_NEAR(pitch, 0.632, 5e-4);
    EXPECT_NEAR(ref::scallop_height(10, pitch), 0.005, 1e-12);
    const double kappa = ref::kappa_for(pitch, 10, 48);
    EXPECT_NEAR(kappa, 31.6, 0.1);
    EXPECT_LE(2 * 10 / kappa, pitch);
    EXPECT_NEAR(kappa * 24, std::round(kappa * 24), 1e-9);
}

// A cutter of 10 mm, scallops of 5 um: 158 turns of pieces as delta asks for; knots add some.
TEST(CamHelix, PiecesOfAWholeCam) {
    const std::vector<ref::CamSection> table = sample_cam_table(24, 10, 11);
    const CamShape shape(table, kTensor);
    const double kappa = ref::kappa_for(ref::scallop_pitch(10, 5e-3), 10, 24);
    EXPECT_NEAR(kappa * 10 / 2, 158, 1);  // turns
    const double delta[] = {0.01, 5e-3};
    const double asked[] = {10100, 14300};
    for (int i = 0; i < 2; ++i) {
        double sum = 0;
        for (int x = 0; x < 100; ++x) sum += shape.pieces_per_turn(x + 0.5, delta[i]) / 100;
        EXPECT_NEAR(sum * kappa * 10 / 2, asked[i], 0.03 * asked[i]);
        ref::CamHelix helix;
        helix.delta = delta[i];
        helix.kappa = kappa;
        helix.ends = ref::CamEnds::kHelix;
        const auto pieces = static_cast<double>(walk(helix, table).pieces.size());
        EXPECT_GT(pieces, asked[i]);
        EXPECT_LT(pieces, 1.2 * asked[i]);
    }
}

const std::vector<std::string> kCells{"1",
                                      "0",
                                      "-",
                                      ".",
                                      ",",
                                      "7",
                                      "45.5",
                                      "1e3",
                                      "1e-9",
                                      "1e9",
                                      "nan",
                                      "inf",
                                      "#",
                                      " ",
                                      "\n",
                                      "x",
                                      ",0",
                                      "\r",
                                      "x,0,90,180,270\n",
                                      "\n10,40,41,42,40\n",
                                      "\xFF"};

TEST(CamFuzz, MutatedTablesAreRefusedOrSound) {
    Mutator mutator({"x,0,90,180,270\n0,40,41,42,40\n10,40,44,42,41\n20,39,44,43,41\n",
                     "# cam\nX, 0, 60,120 ,180,240,300\r\n-5,9,9,9,8,8,8\r\n-4,9,9,8,8,8,8\r\n"
                     "-3,9,9,9,8,8,8\r\n-2,9,7,9,8,8,8\r\n-1,9,9,9,8,6,8\r\n",
                     ref::read_text_file(std::string(DATA_DIR) + "/cam.csv")},
                    kCells);
    const int cases = mutations(10000);
    int read = 0;
    for (int i = 0; i < cases; ++i) {
        std::string text = mutator.excerpt();
        for (std::size_t n = 1 + mutator.below(2); n > 0; --n) mutator.mutate(text);
        ref::CamHelix helix;
        helix.kind = all_kinds()[mutator.below(all_kinds().size())];
        helix.kappa = 1 + static_cast<double>(mutator.below(2));
        helix.delta = 0.1 + static_cast<double>(mutator.below(10));
        try {
            std::istringstream in(text);
            ref::CamTable table(in, "cam.csv");
            std::vector<CamPiece> pieces;
            std::vector<ref::CamSection> sections;
            std::optional<CamPath> path;
            bool giant = false;
            while (const std::optional<ref::CamSection> section = table.next()) {
                ASSERT_EQ(section->rho.size(), static_cast<std::size_t>(table.angles()));
                for (const double rho : section->rho) ASSERT_TRUE(rho > 0 && rho <= 1e6) << text;
                if (!path) {
                    path.emplace(helix, table.angles(),
                                 [&](const CamPiece& piece) { pieces.push_back(piece); });
                }
                giant = giant || *std::max_element(section->rho.begin(), section->rho.end()) > 200;
                if (!giant) path->section(*section);
                sections.push_back(*section);
            }
            ++read;
            const CamShape shape(sections, helix.kind);
            ASSERT_TRUE(std::isfinite(shape.own_error() + shape.largest_jump(2))) << text;
            ASSERT_GT(shape.linear_radii(helix.delta), 0) << text;
            if (giant) continue;  // pieces by the million
            path->finish();
            ASSERT_FALSE(pieces.empty()) << text;
            for (const CamPiece& piece : pieces) {
                ASSERT_TRUE(std::isfinite(piece.to.rho) && std::isfinite(piece.deviation)) << text;
                ASSERT_GT(piece.to.angle, piece.from.angle) << text;
                ASSERT_LE(piece.deviation, helix.delta * (1 + 1e-6)) << text;
            }
        } catch (const ref::InputError&) {
        } catch (const std::invalid_argument&) {  // kappa n / 2
        } catch (const std::domain_error&) {      // too steep
        }
    }
    EXPECT_GT(read, cases / 20) << "the mutations are too coarse";
    EXPECT_LT(read, cases * 9 / 10) << "the mutations are too fine to be refused";
}

}  // namespace curvecore::tb::cam_helix_test
