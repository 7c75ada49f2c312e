// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/blocks/kept_text.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <utility>

namespace curvecore::ref {
namespace {

namespace fs = std::filesystem;
using Kind = OWord::Kind;

/// Reads the first file of that folder with one of these names.
std::shared_ptr<const KeptText> text_in(const fs::path& folder,
                                        const std::vector<std::string>& names,
                                        const std::string& extension, Dialect dialect) {
    for (const std::string& name : names) {
        for (const std::string& ending : {std::string(".ngc"), extension}) {
            auto text = std::make_shared<KeptText>();
            text->file = folder / (name + ending);
            std::error_code error;
            if (!fs::is_regular_file(text->file, error)) continue;
            std::ifstream stream = open_text_file(text->file);
            ProgramLines lines(stream, text->file, dialect);
            while (std::optional<ProgramLine> line = lines.next()) {
                text->lines.push_back(std::move(*line));
            }
            return text;
        }
    }
    return {};
}

}  // namespace

bool of_subs(Kind kind) {
    return kind == Kind::kNumber || kind == Kind::kSub || kind == Kind::kEndsub ||
           kind == Kind::kReturn || kind == Kind::kCall;
}

OWord last_of(const OWord& begin) {
    switch (begin.kind) {
        case Kind::kWhile:
            return {Kind::kEndwhile, begin.label};
        case Kind::kDo:
            return {Kind::kWhile, begin.label};
        case Kind::kRepeat:
            return {Kind::kEndrepeat, begin.label};
        default:
            return {Kind::kEndsub, begin.label};
    }
}

bool ends(const OWord& begin, const OWord& word, const Place& place) {
    const bool sub = begin.kind == Kind::kSub;
    if (sub && word.kind == Kind::kSub) {
        place.refuse(
            fmt::format("{} inside of {}: a sub is defined on its own", word.name(), begin.name()));
    }
    if (word.label != begin.label || of_subs(word.kind) != sub) return false;
    if (word.kind == last_of(begin).kind) return true;
    if (!sub && word.kind != Kind::kBreak && word.kind != Kind::kContinue) {
        place.refuse(
            fmt::format("{} inside of {}: give it another number", word.name(), begin.name()));
    }
    return false;
}

void refuse_unended(const OWord& begin, const Place& place) {
    place.refuse(fmt::format("{} lacks its {}", begin.name(),
                             begin.kind == Kind::kNumber ? "M99" : last_of(begin).name()));
}

std::optional<KeptPart> find_sub(const std::shared_ptr<const KeptText>& text, const OWord& begin,
                                 const ProgramParameters& parameters) {
    const std::size_t end = text->lines.size();
    for (std::size_t at = 0; at < end; ++at) {
        std::optional<OWord> found = text->word(at, parameters);
        if (!found || found->kind != begin.kind || found->label != begin.label) continue;
        if (begin.kind == Kind::kNumber) return KeptPart{text, at, end};
        for (std::size_t last = at + 1; last < end; ++last) {
            found = text->word(last, parameters);
            if (found && ends(begin, *found, text->place(last)))
                return KeptPart{text, at, last + 1};
        }
        refuse_unended(begin, text->place(at));
    }
    return std::nullopt;
}

std::shared_ptr<const KeptText> file_of_sub(const std::string& program,
                                            const std::vector<std::string>& folders,
                                            const std::string& label, Dialect dialect) {
    std::vector<std::string> names{label, "O" + label, "o" + label, fmt::format("O{:0>4}", label)};
    if (label[0] == '<') {
        names = {label.substr(1, label.size() - 2)};
        const char* const safe = "abcdefghijklmnopqrstuvwxyz0123456789_-";
        if (names[0].find_first_not_of(safe) != std::string::npos) return {};
    }
    const fs::path path(program);
    if (auto text = text_in(path.parent_path(), names, path.extension(), dialect)) return text;
    for (const std::string& folder : folders) {
        if (auto text = text_in(folder, names, path.extension(), dialect)) return text;
    }
    return {};
}

}  // namespace curvecore::ref
