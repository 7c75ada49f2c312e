// SPDX-License-Identifier: Apache-2.0
#include "sysc/join/join_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/gcode/state/coordinates.hpp"
#include "ref/text/input_error.hpp"
#include "ref/text/text_file.hpp"
#include "sysc/formats/json_file.hpp"

namespace curvecore::sysc {
namespace {

using Json = nlohmann::ordered_json;
using ref::Vec3;

constexpr double kUnitVectorError = 1e-6;   // greatest deviation of a unit vector in a file
constexpr double kSharpestCurvature = 1e6;  // 1/mm

double number(const Json& json, const char* key, double low, double high) {
    const double value = sysc::number(json, key);
    if (value >= low && value <= high) return value;
    throw JsonFlaw{key, fmt::format("'{}': {:g} is not in [{:g}, {:g}]", key, value, low, high)};
}

Vec3 vector(const Json& json, const char* key, double most) {
    if (!json.is_array() || json.size() != 3) {
        throw JsonFlaw{key, fmt::format("'{}': three numbers are wanted", key)};
    }
    return {number(json[0], key, -most, most), number(json[1], key, -most, most),
            number(json[2], key, -most, most)};
}

template <std::size_t Count>
std::size_t choice(const Json& json, const char* key,
                   const std::array<std::string_view, Count>& names) {
    const Json& value = member(json, key);
    const auto found = value.is_string() ? std::find(names.begin(), names.end(),
                                                     value.get_ref<const std::string&>())
                                         : names.end();
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    throw JsonFlaw{key, fmt::format("'{}' must be one of {}", key, fmt::join(names, ", "))};
}

std::string name(const Json& json, const char* key) {
    const Json& value = member(json, key);
    if (!value.is_string()) throw JsonFlaw{key, fmt::format("'{}': a file's name is wanted", key)};
    return value.get<std::string>();
}

ref::Joint joint(const Json& json, const char* key) {
    const Json& value = member(json, key);
    ref::Joint found;
    found.position = vector(member(value, "position", key), "position", ref::kFarthest);
    found.tangent = vector(member(value, "tangent", key), "tangent", 1 + kUnitVectorError);
    found.curvature = vector(member(value, "curvature", key), "curvature", kSharpestCurvature);
    found.feed = number(member(value, "feed", key), "feed", 1e-6, 1e8);
    if (std::abs(found.tangent.norm() - 1) > kUnitVectorError) {
        throw JsonFlaw{key, fmt::format("'{}': the tangent has not the length 1", key)};
    }
    return found;
}

std::vector<Json> list(const Json& json, const char* key) {
    const Json& value = member(json, key);
    if (!value.is_array() || value.size() > kMostJoinPoints + 2) {
        throw JsonFlaw{
            key, fmt::format("'{}': a list of at most {} is wanted", key, kMostJoinPoints + 2)};
    }
    return {value.begin(), value.end()};
}

constexpr std::array<std::string_view, 11> kMoveKeys{
    "curvecore_join", "a", "b", "start", "end", "fit", "speed", "gcode", "t", "points", "result"};

JoinFile parsed(const Json& json) {
    if (!json.is_object() || !json.contains("curvecore_join")) {
        throw JsonFlaw{"curvecore_join",
                       "is no file of curvecore join: 'curvecore_join' is missing"};
    }
    if (json["curvecore_join"] != kJoinVersion) {
        throw JsonFlaw{"curvecore_join",
                       fmt::format("is of version {}, this program reads version {}",
                                   json["curvecore_join"].dump().substr(0, 20), kJoinVersion)};
    }
    check_keys(json, kMoveKeys, "a move");
    JoinFile file;
    file.a = name(json, "a");
    file.b = name(json, "b");
    file.move.start = joint(json, "start");
    file.move.end = joint(json, "end");
    file.move.fit = static_cast<ref::JoinFit>(choice(json, "fit", ref::kJoinFitNames));
    file.law = static_cast<ref::SpeedLaw>(choice(json, "speed", ref::kSpeedLawNames));
    const Json& gcode = member(json, "gcode");
    file.gcode.form = static_cast<ref::GcodeForm>(choice(gcode, "form", ref::kGcodeFormNames));
    if (file.gcode.form != ref::GcodeForm::kExact) {
        file.gcode.size = number(member(gcode, "size_mm", "gcode"), "size_mm", 1e-6, 1e4);
    }
    for (const Json& t : list(json, "t")) file.move.t.push_back(number(t, "t", 0, ref::kFarthest));
    for (const Json& point : list(json, "points")) {
        file.move.points.push_back(vector(point, "points", ref::kFarthest));
    }
    const std::string flaw = flaw_of(file.move);
    if (!flaw.empty()) throw JsonFlaw{flaw[0] == 't' ? "t" : "points", flaw};
    return file;
}

Json vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json jump_json(const ref::Jump& jump) {
    return {{"slope_rad", jump.slope},
            {"curvature", jump.curvature},
            {"across_g", jump.across},
            {"along_g", jump.along}};
}

}  // namespace

std::string flaw_of(const ref::IdleMove& move) {
    constexpr double kLeastStep = 1e-6;  // mm
    const std::vector<Vec3> all = move.positions();
    if (move.t.size() != all.size()) {
        return fmt::format(
            "t: {} values for {} points: start, control points and end have one each",
            move.t.size(), all.size());
    }
    if (move.t[0] != 0) return "t: begins at 0";
    if ((all.back() - all.front()).norm() < ref::kStill) return "the start and the end coincide";
    const auto called = [&all](std::size_t i) {
        return i == 0               ? std::string("the start")
               : i + 1 < all.size() ? fmt::format("control point {}", i)
                                    : std::string("the end");
    };
    for (std::size_t i = 1; i < all.size(); ++i) {
        if (!(move.t[i] - move.t[i - 1] >= kLeastStep)) {
            return fmt::format("t: must ascend by {:g} mm or more, from {} to {} it does not",
                               kLeastStep, called(i - 1), called(i));
        }
        if ((all[i] - all[i - 1]).norm() < ref::kStill) {
            return fmt::format("{} and {} coincide", called(i - 1), called(i));
        }
    }
    return "";
}

Json joint_json(const ref::Joint& joint) {
    return {{"position", vector_json(joint.position)},
            {"tangent", vector_json(joint.tangent)},
            {"curvature", vector_json(joint.curvature)},
            {"feed", joint.feed}};
}

Json JoinFile::json() const {
    Json json{{"curvecore_join", kJoinVersion},
              {"a", a},
              {"b", b},
              {"start", joint_json(move.start)},
              {"end", joint_json(move.end)},
              {"fit", ref::kJoinFitNames[static_cast<std::size_t>(move.fit)]},
              {"speed", ref::kSpeedLawNames[static_cast<std::size_t>(law)]},
              {"gcode", {{"form", ref::kGcodeFormNames[static_cast<std::size_t>(gcode.form)]}}},
              {"t", move.t},
              {"points", Json::array()},
              {"result", Json::array()}};
    if (gcode.form != ref::GcodeForm::kExact) json["gcode"]["size_mm"] = gcode.size;
    for (const Vec3& point : move.points) json["points"].push_back(vector_json(point));
    for (const ref::JoinJumps& row : ref::compare_joins(move, law)) {
        json["result"].push_back({{"move", row.name},
                                  {"length_mm", row.length},
                                  {"start", jump_json(row.start)},
                                  {"end", jump_json(row.end)}});
    }
    return json;
}

std::string JoinFile::text() const {
    return json().dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

JoinFile read_join_file(const std::string& file) {
    return read_join_text(ref::read_text_file(file), file);
}

JoinFile read_join_text(const std::string& text, const std::string& file_name) {
    return read_json(text, file_name, "curvecore join writes such files", parsed);
}

}  // namespace curvecore::sysc
