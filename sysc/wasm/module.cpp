// SPDX-License-Identifier: Apache-2.0
// Functions that the page's script calls: emcc makes WebAssembly of them (scripts/site/wasm.py).
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "ref/text/input_error.hpp"
#include "sysc/cli/shipped_files.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/wasm/drawn_part.hpp"

namespace {

using namespace curvecore;

/// Result of the last call, which the script reads.
sysc::DrawnPart& last() {
    static sysc::DrawnPart part;
    return part;
}

std::string refused(const char* kind, const std::string& reason) {
    const nlohmann::ordered_json json{{"refused", kind}, {"reason", reason}};
    return json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

/// Draws a part, or says why not.
sysc::DrawnPart drawn(const std::string& arguments) {
    try {
        std::vector<std::string> words;
        std::istringstream text(arguments);
        for (std::string word; text >> word;) words.push_back(word);
        return sysc::draw_part(std::move(words));
    } catch (const ref::InputError& error) {
        return {refused("program", error.what()), ""};
    } catch (const sysc::UsageError& error) {
        return {refused("option", error.what()), ""};
    } catch (const std::bad_alloc&) {
        return {refused("memory", "there is not enough memory in the page for this part"), ""};
    } catch (const std::exception& error) {
        return {refused("program", error.what()), ""};
    }
}

}  // namespace

#define CURVECORE_EXPORT extern "C" __attribute__((used, visibility("default")))

/// Draws the part that FILE and options name; returns JSON, with `refused` where there is none.
CURVECORE_EXPORT const char* curvecore_draw(const char* arguments) {
    sysc::ship_from("/");
    last() = {};
    last() = drawn(arguments);
    return last().json.c_str();
}

/// The page report.html of the last part.
CURVECORE_EXPORT const char* curvecore_report() { return last().report.c_str(); }
