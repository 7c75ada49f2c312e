// SPDX-License-Identifier: Apache-2.0
// A configuration of a core, and the table of its parameters (ref/format/parameters.def); text of
// both: ref/format/parameter_text.hpp.
#pragma once

#include <memory>

#include "ref/format/path_words.hpp"

namespace curvecore {
namespace ref {

struct CurveTable;  // ref/curves/curve_table.hpp

/// Builds of rtl/motion_interpolator.sv, by the number that its parameter Build has.
enum class Build { kParallel, kSerial, kEngine };

/// The fields of the table's rows, with their defaults.
struct CoreParameters {
#define PARAMETER(field, Name, low, high, default_value, ...) int field = default_value;
#include "ref/format/parameters.def"
    Build build = Build::kParallel;
    std::shared_ptr<const CurveTable> table = {};  // a further curve that it draws: none, or one
    int further_words = 0;                         // of each segment, for the table alone

    int axes() const { return 3 + aux_axes; }
    /// Words of a segment on the bus.
    int segment_words() const { return segment_bus_words(aux_axes) + further_words; }
    bool polynomial() const { return mode == 1; }
    /// Largest rounding of a position by the output, units.
    double rounding() const { return 0.5; }
};

enum class ParameterValues { kWhole, kPowerOfTwo };
enum class ParameterBuilds { kEveryBuild, kParallelAlone };

/// A row of the table.
struct Parameter {
    const char* field;
    const char* name;
    int CoreParameters::*value;
    int low;
    int high;
    int default_value;
    ParameterValues values;
    ParameterBuilds builds;
    const char* needs;
    bool samples;
    const char* sentence;

    constexpr bool holds(int number) const {
        return number >= low && number <= high &&
               (values == ParameterValues::kWhole || (number & (number - 1)) == 0);
    }
};

constexpr Parameter kParameters[] = {
#define PARAMETER(field, Name, low, high, default_value, values, builds, needs, samples, sentence) \
    {#field,                                                                                       \
     #Name,                                                                                        \
     &CoreParameters::field,                                                                       \
     low,                                                                                          \
     high,                                                                                         \
     default_value,                                                                                \
     ParameterValues::values,                                                                      \
     ParameterBuilds::builds,                                                                      \
     needs,                                                                                        \
     samples,                                                                                      \
     sentence},
#include "ref/format/parameters.def"
};

/// Returns the row of a field; every field has one.
constexpr const Parameter& parameter_of(int CoreParameters::*value) {
    const Parameter* row = kParameters;
    while (row->value != value) ++row;
    return *row;
}

inline bool operator==(const CoreParameters& a, const CoreParameters& b) {
    for (const Parameter& row : kParameters) {
        if (a.*row.value != b.*row.value) return false;
    }
    return a.build == b.build && a.table == b.table;
}

}  // namespace ref
}  // namespace curvecore
