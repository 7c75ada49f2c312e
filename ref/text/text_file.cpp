// SPDX-License-Identifier: Apache-2.0
#include "ref/text/text_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;

}  // namespace

std::ifstream open_text_file(const std::string& file) {
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
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw InputError(file, 0, std::string("cannot be read: ") + std::strerror(errno));
    }
    return stream;
}

std::string read_text_file(const std::string& file) {
    std::ifstream stream = open_text_file(file);
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error || size > kLargestFile) {
        throw InputError(file, 0, "is larger than 1 GiB");
    }
    std::string text(size, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(stream.gcount()) != size) {
        throw InputError(file, 0, "cannot be read to its end");
    }
    return text;
}

TextLines::TextLines(std::istream& text) : text_(*text.rdbuf()) {}

std::optional<std::string_view> TextLines::next() {
    constexpr int kEnd = std::char_traits<char>::eof();
    int c = text_.sbumpc();
    if (c == kEnd) {
        return std::nullopt;
    }
    line_.clear();
    for (; c != kEnd && c != '\n' && c != '\r'; c = text_.sbumpc()) {
        line_.push_back(static_cast<char>(c));
    }
    if (c == '\r' && text_.sgetc() == '\n') {
        text_.sbumpc();
    }
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    const bool marked = ++number_ == 1 && line_.compare(0, kMark.size(), kMark) == 0;
    if (marked && line_.size() == kMark.size() && text_.sgetc() == kEnd) {
        return std::nullopt;
    }
    return std::string_view(line_).substr(marked ? kMark.size() : 0);
}

}  // namespace curvecore::ref
