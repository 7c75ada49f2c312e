// SPDX-License-Identifier: Apache-2.0
#include "ref/cam/cam_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ref/gcode/blocks/block.hpp"
#include "ref/gcode/state/coordinates.hpp"
#include "ref/text/csv_cells.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

// Tables print few digits of 360 / 7: angles are even to the last printed digit, and to
constexpr double kAngleSlack = 2e-3;  // degrees
constexpr double kPitchSlack = 1e-4;  // share of Dx
constexpr std::size_t kMostAngles = 100000;

double finite_number(std::string_view cell, const std::string& what, const Place& place) {
    const std::optional<double> value = cell_number(cell);
    if (!value || !std::isfinite(*value)) {
        place.refuse(fmt::format("{} = '{}' is not a number", what, shown(cell)));
    }
    if (std::abs(*value) > kFarthest) {
        place.refuse(fmt::format("{} = {:.10g} is out of range: beyond {:.10g} mm", what, *value,
                                 kFarthest));
    }
    return *value;
}

/// Half of the last printed digit of a number.
double half_digit(std::string_view cell) {
    const std::size_t exponent = std::min(cell.find_first_of("eE"), cell.size());
    const std::size_t point = std::min(cell.find('.') + 1, exponent);
    const double decimals = point == 0 ? 0 : static_cast<double>(exponent - point);
    const std::string_view power = cell.substr(std::min(exponent + 1, cell.size()));
    return 1e-9 + 0.5 * std::pow(10, cell_number(power).value_or(0) - decimals);
}

}  // namespace

CamTable::CamTable(std::istream& in, const std::string& file) : file_(file), in_(in) {
    const std::optional<std::string> header = content();
    if (!header) throw InputError(file, 0, "an empty table");
    read_header(*header);
}

/// Returns the next line with content.
std::optional<std::string> CamTable::content() {
    std::string line;
    while (std::getline(in_, line)) {
        ++line_;
        if (line_ == 1 && line.rfind("\xef\xbb\xbf", 0) == 0) line.erase(0, 3);
        if (!line.empty() && line.back() == '\r') line.pop_back();
        const std::string_view text = trim(std::string_view(line).substr(0, line.find('#')));
        if (!text.empty()) return std::string(text);
    }
    return std::nullopt;
}

void CamTable::read_header(const std::string& text) {
    header_line_ = line_;
    const Place place{file_, line_};
    const std::vector<std::string_view> cells = cells_of(text);
    if (cells[0] != "x" && cells[0] != "X") {
        place.refuse(fmt::format("a cam table begins with 'x,0,..' (angles in degrees), not '{}'",
                                 shown(cells[0])));
    }
    if (cells.size() > kMostAngles) {
        place.refuse(fmt::format("{} angles; {} are the most", cells.size() - 1, kMostAngles));
    }
    angles_ = static_cast<int>(cells.size()) - 1;
    std::vector<double> degrees;
    for (std::size_t m = 1; m < cells.size(); ++m) {
        degrees.push_back(finite_number(cells[m], fmt::format("angle {}", m), place));
    }
    if (angles_ > 1 && std::abs(degrees.back() - 360) <= kAngleSlack) {
        place.refuse("the last angle is 360, which is 0 again: leave that column out");
    }
    if (angles_ < kLeastAngles) {
        place.refuse(
            fmt::format("{} angles; the section's cubic goes through {}", angles_, kLeastAngles));
    }
    for (int m = 0; m < angles_; ++m) {
        const double wanted = 360.0 * m / angles_;
        const double angle = degrees[static_cast<std::size_t>(m)];
        const double slack = half_digit(cells[static_cast<std::size_t>(m) + 1]);
        if (std::abs(angle - wanted) > std::min(kAngleSlack, slack)) {
            place.refuse(fmt::format("angle {} is {:.6g}, and {} even angles from 0 want {:.6g}",
                                     m + 1, angle, angles_, wanted));
        }
    }
}

std::optional<CamSection> CamTable::next() {
    const std::optional<std::string> text = content();
    if (!text) {
        if (sections_ < 2) {
            throw InputError(file_, line_,
                             fmt::format("{} section{}; a cam has at least 2", sections_,
                                         sections_ == 1 ? "" : "s"));
        }
        return std::nullopt;
    }
    CamSection section = read_section(*text);
    check_place(section);
    if (sections_ == 0) first_x_ = section.x;
    if (sections_ == 1) pitch_ = section.x - first_x_;
    last_x_ = section.x;
    last_line_ = line_;
    section.x = first_x_ + sections_ * pitch_;  // even to the last bit
    ++sections_;
    return section;
}

CamSection CamTable::read_section(const std::string& text) const {
    const Place place{file_, line_};
    const std::vector<std::string_view> cells = cells_of(text);
    if (cells.size() != static_cast<std::size_t>(angles_) + 1) {
        place.refuse(
            fmt::format("{} cells where line {} has {}", cells.size(), header_line_, angles_ + 1));
    }
    CamSection section;
    section.line = line_;
    section.x = finite_number(cells[0], "x", place);
    section.x_slack = half_digit(cells[0]);
    section.rho.reserve(static_cast<std::size_t>(angles_));
    for (std::size_t m = 1; m < cells.size(); ++m) {
        const double rho = finite_number(cells[m], fmt::format("radius {}", m), place);
        if (rho <= 0) {
            place.refuse(fmt::format("radius {} is {:g}: a radius is above 0", m, rho));
        }
        section.rho.push_back(rho);
    }
    return section;
}

void CamTable::check_place(const CamSection& section) const {
    const Place place{file_, section.line};
    if (sections_ == 0) return;
    if (section.x == last_x_) {
        place.refuse(
            fmt::format("x = {:g} is the section of line {} again", section.x, last_line_));
    }
    if (section.x < last_x_) {
        place.refuse(fmt::format("x = {:g} comes after {:g}: sections go up", section.x, last_x_));
    }
    const double wanted = first_x_ + sections_ * pitch_;
    const double slack = std::min(kPitchSlack * pitch_, section.x_slack);
    if (sections_ > 1 && std::abs(section.x - wanted) > slack) {
        place.refuse(fmt::format("x = {:.10g}, and sections every {:.10g} mm want {:.10g}",
                                 section.x, pitch_, wanted));
    }
}

std::ifstream open_cam(const std::string& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) throw InputError(file, 0, "no such file");
    if (!std::filesystem::is_regular_file(file, error)) {
        throw InputError(file, 0, "is not a regular file");
    }
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError(file, 0, "cannot be read");
    return in;
}

std::vector<CamSection> read_cam(const std::string& file) {
    std::ifstream in = open_cam(file);
    CamTable table(in, file);
    std::vector<CamSection> sections;
    while (std::optional<CamSection> section = table.next()) sections.push_back(*section);
    return sections;
}

}  // namespace curvecore::ref
