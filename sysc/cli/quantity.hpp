// SPDX-License-Identifier: Apache-2.0
// Numbers with a unit on the command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace curvecore::sysc {

/// A unit: so many times a power of ten of the base.
struct Suffix {
    std::string_view name;
    int power;
    double times = 1;
};

/// A number or a fraction (1/65536) with one of these units, in the unit's base. A suffix without a
/// name is a number alone.
/// @throws UsageError that names `option`: not a finite number, another unit
double quantity(const std::string& option, const std::string& text,
                const std::vector<Suffix>& suffixes);

/// In mm, of nm, um, mm, m or in. @throws UsageError, also when it is not in [low, high] mm
double length(const std::string& option, const std::string& text, double low, double high);
/// In mm/s, of mm/min (also without a unit), m/min, in/min, mm/s or m/s. @throws UsageError
double speed(const std::string& option, const std::string& text);
/// In s, of ns, us, ms or s. @throws UsageError
double duration(const std::string& option, const std::string& text);
/// In Hz. @throws UsageError, also when it is not in [low, high] Hz
double frequency(const std::string& option, const std::string& text, double low, double high);

/// A length with its unit as these functions read it back exactly: "1nm", "2.5um", "10mm".
std::string exact_length(double mm);

}  // namespace curvecore::sysc
