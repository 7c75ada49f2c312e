// SPDX-License-Identifier: Apache-2.0
#include "ref/program/text_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "ref/program/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;

}  // namespace

std::string read_text_file(const std::string& file) {
    std::error_code error;
    if (std::filesystem::is_directory(file, error)) {
        throw InputError(file, 0, "is a directory, not a file");
    }
    if (!std::filesystem::exists(file, error)) {
        throw InputError(file, 0, "no such file");
    }
    if (!std::filesystem::is_regular_file(file, error)) {
        throw InputError(file, 0, "is not a regular file");
    }
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error || size > kLargestFile) {
        throw InputError(file, 0, "is larger than 1 GiB");
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw InputError(file, 0, std::string("cannot be read: ") + std::strerror(errno));
    }
    std::string text(size, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(stream.gcount()) != size) {
        throw InputError(file, 0, "cannot be read to its end");
    }
    return text;
}

TextLines::TextLines(std::string_view text) : rest_(text) {
    if (rest_.substr(0, 3) == "\xEF\xBB\xBF") {
        rest_.remove_prefix(3);
    }
}

std::optional<std::string_view> TextLines::next() {
    if (rest_.empty()) {
        return std::nullopt;
    }
    ++number_;
    const std::size_t end = rest_.find_first_of("\r\n");
    const std::string_view line = rest_.substr(0, end);
    if (end == std::string_view::npos) {
        rest_ = {};
    } else {
        rest_.remove_prefix(end + (rest_.substr(end, 2) == "\r\n" ? 2 : 1));
    }
    return line;
}

}  // namespace curvecore::ref
