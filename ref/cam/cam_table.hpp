// SPDX-License-Identifier: Apache-2.0
// A cam as a table: polar radii at equal angles in equally spaced sections, [Tamm] Fig. 1. Read
// section by section, so that a long cam needs no more memory than a short one.
//
//     x,0,7.5,15,..        header: angles in degrees, from 0, even; 360 is 0 again and not written
//     0,40.1,40.6,..       a section: its place along the axis and its radii, mm
#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace curvecore::ref {

/// | field | symbol     | unit | remark                                                        |
/// |-------|------------|------|---------------------------------------------------------------|
/// | x     | x_i        | mm   | x_0 + i Dx                                                    |
/// | rho   | rho_{i,m}  | mm   | > 0; of the cutter's centre, at theta_m = m Dtheta            |
struct CamSection {
    int line = 0;
    double x = 0;
    std::vector<double> rho;
    double x_slack = 0;  // half of the last digit of x in the table
};

class CamTable {
  public:
    static constexpr int kLeastAngles = 4;

    /// Reads the header; `file` is the table's name in messages, `in` outlives this object.
    /// @throws InputError
    CamTable(std::istream& in, const std::string& file);

    const std::string& file() const { return file_; }
    int angles() const { return angles_; }  // n
    int header_line() const { return header_line_; }

    /// Returns the next section; none after the last.
    /// @throws InputError: ragged, repeated, unsorted or uneven sections, a radius <= 0, fewer than
    ///         two sections
    std::optional<CamSection> next();

  private:
    std::optional<std::string> content();
    void read_header(const std::string& text);
    CamSection read_section(const std::string& text) const;
    void check_place(const CamSection& section) const;

    std::string file_;
    std::istream& in_;
    int line_ = 0;
    int header_line_ = 0;
    int angles_ = 0;
    int sections_ = 0;
    double first_x_ = 0;
    double pitch_ = 0;  // Dx
    double last_x_ = 0;
    int last_line_ = 0;
};

/// @throws InputError: missing, not a regular file, unreadable
std::ifstream open_cam(const std::string& file);

/// Reads the whole table. @throws InputError
std::vector<CamSection> read_cam(const std::string& file);

}  // namespace curvecore::ref
