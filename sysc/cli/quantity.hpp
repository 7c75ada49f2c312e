// SPDX-License-Identifier: Apache-2.0
// Numbers with a unit on the command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace curvecore::sysc {

/// A unit: a multiple of a power of ten of the base unit.
struct Suffix {
    std::string_view name;
    int power;
    double times = 1;
};

/// Reads a number or a fraction (1/65536) with one of these units, in the base unit. A suffix
/// without a name stands for a number alone.
/// @throws UsageError that names `option`: not a finite number, another unit
double quantity(const std::string& option, const std::string& text,
                const std::vector<Suffix>& suffixes);

/// Reads a number without a unit. @throws UsageError
double plain_number(const std::string& option, const std::string& text);
/// Reads a length in nm, um, mm, m or in; mm. @throws UsageError, also outside [low, high] mm
double length(const std::string& option, const std::string& text, double low, double high);
/// Reads a speed in mm/min (also without a unit), m/min, in/min, mm/s or m/s; mm/s. @throws
/// UsageError
double speed(const std::string& option, const std::string& text);
/// Reads a duration in ns, us, ms or s; s. @throws UsageError
double duration(const std::string& option, const std::string& text);
/// Reads a frequency, Hz. @throws UsageError, also outside [low, high] Hz
double frequency(const std::string& option, const std::string& text, double low, double high);

/// Writes a length with its unit so that length() reads it back exactly: "1nm", "2.5um", "10mm".
std::string exact_length(double mm);

}  // namespace curvecore::sysc
