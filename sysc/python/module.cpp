// SPDX-License-Identifier: Apache-2.0
// The extension module curvecore._native; curvecore/__init__.py is what users see.
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "hls/words.hpp"
#include "ref/text/input_error.hpp"
#include "sysc/board/feeder.hpp"
#include "sysc/cli/shipped_files.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/python/arrays.hpp"
#include "sysc/python/planned_part.hpp"

namespace curvecore::sysc {
namespace {

namespace nb = nanobind;

/// One number of each segment.
template <class T, class Of>
Array<T> of_segments(const PlannedPart& part, Of of) {
    std::vector<T> values;
    const auto& segments = part.job().plan.segments;
    for (std::size_t n = 0; n < segments.size(); ++n) values.push_back(of(segments[n]));
    return to_array(std::move(values));
}

nb::dict parameters(const PlannedPart& part) {
    nb::dict values;
    for (const ref::Parameter& parameter : ref::kParameters) {
        values[parameter.name] = part.job().options.core.*parameter.value;
    }
    return values;
}

/// Inputs of rtl/motion_interpolator.sv, by their names without _i.
nb::dict settings(const PlannedPart& part) {
    const BoardSettings made = board_settings(part.job());
    nb::dict values;
    values["digest"] = made.digest;
    values["samples_per_tick_log2"] = made.samples_per_tick_log2;
    values["override"] = made.override_word;
    values["hold_acceleration"] = made.hold_acceleration;
    values["hold_slope"] = made.hold_slope;
    values["stop_ticks"] = made.stop_ticks;
    return values;
}

nb::dict segments(const PlannedPart& part) {
    const double quantum_mm = std::ldexp(part.job().plan.unit_mm, -hls::kPathFrac);
    nb::dict all;
    all["line"] = of_segments<int>(part, [](const ref::Segment& of) { return of.line; });
    all["kind"] = nb::list();
    for (std::size_t n = 0; n < part.job().plan.segments.size(); ++n) {
        nb::cast<nb::list>(all["kind"]).append(part.job().plan.segments[n].kind_name());
    }
    all["length_mm"] = of_segments<double>(
        part, [=](const ref::Segment& of) { return static_cast<double>(of.length) * quantum_mm; });
    all["bound_units"] = of_segments<double>(part, [](const ref::Segment& of) { return of.bound; });
    all["feed_end_mm_s"] =
        of_segments<double>(part, [](const ref::Segment& of) { return of.feed_end; });
    return all;
}

nb::tuple draw(const PlannedPart& part) {
    PlannedPart::Samples drawn;
    {
        const nb::gil_scoped_release others_run;
        drawn = part.draw();
    }
    const auto axes = static_cast<std::size_t>(part.axes());
    const std::size_t samples = drawn.position.size() / axes;
    return nb::make_tuple(to_array(std::move(drawn.position), {samples, axes}),
                          to_array(std::move(drawn.fine), {samples, axes}));
}

/// Raises curvecore.InputError with the text of what was refused.
void translate(const std::exception_ptr& thrown, void* /*unused*/) {
    const auto raise = [](const char* text) {
        const nb::object type = nb::module_::import_("curvecore").attr("InputError");
        PyErr_SetString(type.ptr(), text);
    };
    try {
        std::rethrow_exception(thrown);
    } catch (const ref::InputError& error) {
        raise(error.what());
    } catch (const UsageError& error) {
        raise(error.what());
    }
}

}  // namespace
}  // namespace curvecore::sysc

NB_MODULE(_native, module) {
    using namespace curvecore::sysc;
    nb::register_exception_translator(translate);
    module.def("ship_from", [](const std::string& folder) { ship_from(folder); });
    nb::class_<PlannedPart>(module, "PlannedPart")
        .def(nb::init<const std::vector<std::string>&>(), nb::arg("arguments"),
             nb::call_guard<nb::gil_scoped_release>())
        .def_prop_ro("axes", &PlannedPart::axes)
        .def_prop_ro("parameters", parameters)
        .def_prop_ro("settings", settings)
        .def_prop_ro("unit_mm", [](const PlannedPart& part) { return part.job().plan.unit_mm; })
        .def_prop_ro("sample_period_s",
                     [](const PlannedPart& part) { return part.job().options.sample_period_s; })
        .def_prop_ro("duration_s",
                     [](const PlannedPart& part) { return part.job().plan.duration_s; })
        .def_prop_ro("path_mm", [](const PlannedPart& part) { return part.job().path_mm(); })
        .def_prop_ro("bound_units", [](const PlannedPart& part) { return part.job().bound(); })
        .def_prop_ro("warnings",
                     [](const PlannedPart& part) { return part.job().program.warnings; })
        .def("segments", segments)
        .def("segment_words",
             [](const PlannedPart& part) { return to_array(part.segment_words()); })
        .def("profile_words",
             [](const PlannedPart& part) { return to_array(part.profile_words()); })
        .def("draw", draw);
}
