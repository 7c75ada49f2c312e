// SPDX-License-Identifier: Apache-2.0
// Cases of tb/cli/bad_input_cases.json as files.
//
// A case is a program `file` (its `content`, or `base64` bytes, or a `folder`; none: the file is
// missing), sometimes a `machine` file or the `fit` of points, and the `stderr` that `curvecore
// plan` must give with FILE and MACHINE in place of their paths. Cases of the `stage` "plan" pass
// the readers.
#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace curvecore::tb {

inline std::vector<nlohmann::json> bad_input_cases(const std::string& file) {
    std::ifstream stream(file);
    return nlohmann::json::parse(stream).get<std::vector<nlohmann::json>>();
}

inline std::string decode_base64(const std::string& text) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::size_t digit = letters.find(c);
        if (digit == std::string::npos) break;
        bits = bits << 6 | static_cast<unsigned>(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += static_cast<char>(bits >> count & 0xff);
        }
    }
    return bytes;
}

/// Writes a program or machine of a case, if it exists there; returns its path.
inline std::string write_bad_input(const std::filesystem::path& folder,
                                   const nlohmann::json& file) {
    const std::filesystem::path path = folder / file.at("file").get<std::string>();
    if (file.contains("folder")) {
        std::filesystem::create_directory(path);
    } else if (file.contains("content") || file.contains("base64")) {
        std::ofstream(path, std::ios::binary)
            << (file.contains("content") ? file["content"].get<std::string>()
                                         : decode_base64(file["base64"]));
    }
    return path.string();
}

/// Returns `stderr` of a case with a path in place of FILE or MACHINE.
inline std::string with_path(std::string text, const std::string& name, const std::string& path) {
    return text.rfind(name + ":", 0) == 0 ? text.replace(0, name.size(), path) : text;
}

}  // namespace curvecore::tb
