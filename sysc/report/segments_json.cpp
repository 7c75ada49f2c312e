// SPDX-License-Identifier: Apache-2.0
#include "sysc/report/segments_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "ref/plan/segment_curve.hpp"
#include "sysc/words/bus_words.hpp"

namespace curvecore::sysc {
namespace {

using Text = fmt::memory_buffer;

/// Writes three axes and the auxiliary ones that the program uses, mm.
void point(Text& text, const char* name, const Job& job, const ref::Vec3& xyz, const ref::Aux& aux,
           const ref::Aux& turned) {
    const double unit = job.plan.unit_mm;
    fmt::format_to(std::back_inserter(text), ", \"{}\": [{:.12g}, {:.12g}, {:.12g}", name,
                   xyz.x() * unit, xyz.y() * unit, xyz.z() * unit);
    for (std::size_t a = 0; a < static_cast<std::size_t>(job.plan.aux_axes); ++a) {
        fmt::format_to(std::back_inserter(text), ", {:.12g}", (aux[a] + turned[a]) * unit);
    }
    text.push_back(']');
}

/// Writes r(v) = start + 2^lambda ((a v + b) v + c) v in length units, up to v = beta.
void spline(Text& text, const ref::SplinePiece& piece) {
    const auto out = std::back_inserter(text);
    const auto vector = [&](const char* name, const ref::Vec3& v) {
        fmt::format_to(out, ", \"{}\": [{:.15g}, {:.15g}, {:.15g}]", name, v.x(), v.y(), v.z());
    };
    vector("a", piece.a);
    vector("b", piece.b);
    vector("c", piece.c);
    fmt::format_to(out, ", \"lambda\": {}, \"beta\": {:.15g}", piece.lambda, piece.beta);
}

/// Writes the rows of a table's bus at the segment's start, in powers of 1 / length unit.
void rows(Text& text, const ref::TablePiece& piece) {
    const auto out = std::back_inserter(text);
    const char* comma = "";
    fmt::format_to(out, ", \"rows\": {{");
    for (const auto& [row, values] : piece.rows(1)) {
        const std::size_t axes = piece.table->rows.at(row).of_axis ? 3 : 1;
        fmt::format_to(out, "{}\"{}\": [", comma, row);
        for (std::size_t axis = 0; axis < axes; ++axis) {
            fmt::format_to(out, "{}{:.15g}", axis == 0 ? "" : ", ", values[axis]);
        }
        fmt::format_to(out, "]");
        comma = ", ";
    }
    text.push_back('}');
}

/// Number as text; JSON has no infinity, so a cusp's curvature is null.
std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{:.9g}", value) : "null";
}

/// Writes the derivatives at both ends and at the sharpest place.
void shape(Text& text, const ref::Segment& segment, double unit_mm) {
    const auto out = std::back_inserter(text);
    const double length = std::ldexp(static_cast<double>(segment.length), -16);
    const auto curve = ref::exact_curve(segment);
    const ref::SharpestPlace sharpest = curve->sharpest();
    const auto vector = [&](const char* name, const ref::Vec3& v) {
        fmt::format_to(out, ", \"{}\": [{}, {}, {}]", name, number(v.x()), number(v.y()),
                       number(v.z()));
    };
    vector("tangent_start", curve->direction(0));
    vector("tangent_end", curve->direction(length));
    fmt::format_to(out, ", \"curvature_start_per_mm\": {}, \"curvature_end_per_mm\": {}",
                   number(curve->curvature(0) / unit_mm),
                   number(curve->curvature(length) / unit_mm));
    fmt::format_to(out, ", \"least_radius_mm\": {}, \"least_radius_at_mm\": {}",
                   number(unit_mm / sharpest.curvature), number(sharpest.s * unit_mm));
}

}  // namespace

void write_segments(const Job& job, const std::function<void(const std::string& text)>& write) {
    write(fmt::format(
        "{{\n\"unit_mm\": {:g}, \"quantum_units\": {}, \"words_bits\": 48,\n\"segments\": [",
        job.plan.unit_mm, std::ldexp(1.0, -16)));
    SegmentWriter writer(job.options.core, job.digest());
    for (std::size_t i = 0; i < job.plan.segments.size(); ++i) {
        const ref::Segment& segment = job.plan.segments[i];
        Text text;
        const auto out = std::back_inserter(text);
        fmt::format_to(out, "{}\n{{\"segment\": {}, \"move\": {}, \"line\": {}, \"kind\": \"{}\"",
                       i == 0 ? "" : ",", i, segment.move, segment.line, segment.kind_name());
        point(text, "start_mm", job, segment.start, segment.aux_start, segment.aux_turned);
        point(text, "end_mm", job, segment.end, segment.aux_end, segment.aux_turned);
        const auto* piece = std::get_if<ref::SplinePiece>(&segment.curve);
        if (piece != nullptr) spline(text, *piece);
        if (segment.kind() == ref::CurveKind::kTable) rows(text, segment.table());
        const double radius = segment.kind() == ref::CurveKind::kArc ? segment.arc().radius : 0;
        shape(text, segment, job.plan.unit_mm);
        fmt::format_to(out,
                       ", \"s_quanta\": {}, \"length_quanta\": {}, \"length_mm\": {:.12g}, "
                       "\"radius_mm\": {:.12g}, \"step_exponent\": {}, \"bound_lsb\": {}, "
                       "\"feed_start\": {:.9g}, \"feed_end\": {:.9g}, \"ticks\": {}, \"words\": [",
                       segment.s_start, segment.length,
                       std::ldexp(static_cast<double>(segment.length), -16) * job.plan.unit_mm,
                       radius * job.plan.unit_mm, segment.step_exponent,
                       job.bounded(segment.kind()) ? fmt::format("{:.6g}", segment.bound) : "null",
                       segment.feed_start, segment.feed_end, segment.ticks);
        const char* comma = "";
        for (const std::uint64_t word : writer.write(segment)) {
            fmt::format_to(out, "{}\"{:012x}\"", comma, word);
            comma = ", ";
        }
        fmt::format_to(out, "]}}");
        write(fmt::to_string(text));
    }
    write("\n]\n}\n");
}

}  // namespace curvecore::sysc
