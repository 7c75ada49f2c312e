// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/blocks/codes.hpp"

#include <fmt/format.h>

#include <string_view>

namespace curvecore::ref {
namespace {

std::optional<Group> g_group(int code) {
    switch (code) {
        case 40:
        case 100:
        case 280:
        case 281:
        case 300:
        case 301:
        case 520:
        case 530:
        case 920:
        case 921:
        case 922:
        case 923:
            return Group::kAction;
        case 0:
        case 10:
        case 20:
        case 24:
        case 30:
        case 34:
        case 50:
        case 51:
        case 52:
        case 53:
        case 330:
        case 331:
        case 382:
        case 383:
        case 384:
        case 385:
        case 730:
        case 740:
        case 760:
        case 800:
        case 810:
        case 820:
        case 830:
        case 840:
        case 850:
        case 860:
        case 870:
        case 880:
        case 890:
            return Group::kMotion;
        case 170:
        case 180:
        case 190:
            return Group::kPlane;
        case 900:
        case 910:
            return Group::kDistance;
        case 901:
        case 911:
            return Group::kArcDistance;
        case 930:
        case 940:
        case 950:
            return Group::kFeedMode;
        case 200:
        case 210:
            return Group::kUnits;
        case 400:
        case 410:
        case 411:
        case 420:
        case 421:
            return Group::kCompensation;
        case 430:
        case 431:
        case 432:
        case 490:
            return Group::kToolLength;
        case 980:
        case 990:
            return Group::kReturn;
        case 540:
        case 550:
        case 560:
        case 570:
        case 580:
        case 590:
        case 591:
        case 592:
        case 593:
            return Group::kSystem;
        case 610:
        case 611:
        case 640:
            return Group::kPathControl;
        case 960:
        case 970:
            return Group::kSpindleMode;
        case 70:
        case 80:
            return Group::kDiameter;
        default:
            return std::nullopt;
    }
}

Group m_group(int code) {
    switch (code) {
        case 0:
        case 1:
        case 2:
        case 30:
        case 60:
            return Group::kStop;
        case 3:
        case 4:
        case 5:
        case 19:
            return Group::kSpindle;
        case 6:
        case 61:
            return Group::kToolChange;
        case 7:
        case 8:
        case 9:
            return Group::kCoolant;
        case 48:
        case 49:
        case 50:
        case 51:
        case 52:
        case 53:
            return Group::kOverride;
        case 62:
        case 63:
        case 64:
        case 65:
        case 66:
        case 67:
        case 68:
            return Group::kOutput;
        default:
            return Group::kOwn;
    }
}

/// Returns the reason why this reader refuses a G code that LinuxCNC knows; empty if LinuxCNC does
/// not.
std::string_view g_refusal(int code) {
    const int whole = code / 10;
    if (whole >= 70 && whole <= 72) {
        return "turning cycles belong to LinuxCNC's interpreter (--interpreter linuxcnc)";
    }
    if (whole >= 17 && whole <= 19) {
        return "arcs of U V W are not supported";
    }
    return "";
}

std::string_view m_refusal(int code) {
    if (code == 98 || code == 99) return "one call or return in a block";
    if (code >= 70 && code <= 73) return "one code of M70 to M73 in a block";
    return "";
}

/// Translates another controller's code to LinuxCNC's. G70 and G71 are inches and mm to Mach3 and
/// Siemens, but turning cycles with these words; G31 is probing to Fanuc and Mach3.
int as_linuxcnc(int code, const Block& block) {
    const bool cycle = block.has_any("PQRUWD");
    if (code == 700 && !cycle) return 200;
    if (code == 710 && !cycle) return 210;
    return code == 310 ? 382 : code;
}

[[noreturn]] void refuse_code(const std::string& name, std::string_view why, const Place& place) {
    place.refuse(why.empty() ? fmt::format("unknown code {}", name)
                             : fmt::format("{}: {}", name, why));
}

}  // namespace

Codes::Codes(const Block& block, const Place& place) {
    for (const int given : block.g) {
        const int code = as_linuxcnc(given, block);
        const std::optional<Group> group = g_group(code);
        if (!group) {
            refuse_code(g_name(code), g_refusal(code), place);
        }
        add(*group, code, 'G', place);
    }
    for (const int code : block.m) {
        const Group group = m_group(code);
        if (!m_refusal(code).empty()) {
            refuse_code(fmt::format("M{}", code), m_refusal(code), place);
        }
        if (group != Group::kCoolant && group != Group::kOwn) add(group, code, 'M', place);
    }
}

bool Codes::known(int m_code) {
    return m_group(m_code) != Group::kOwn || (m_code >= 100 && m_code <= 199);
}

void Codes::add(Group group, int code, char letter, const Place& place) {
    std::optional<int>& slot = code_[static_cast<int>(group)];
    if (group == Group::kMotion && slot && *slot != code) {
        if (code == kNoMotion) return;
        if (*slot == kNoMotion) slot.reset();
    }
    if (slot) {
        const auto name = [letter](int c) {
            return letter == 'G' ? g_name(c) : fmt::format("M{}", c);
        };
        place.refuse(*slot == code ? fmt::format("{} twice in one block", name(code))
                                   : fmt::format("{} and {} exclude each other in one block",
                                                 name(*slot), name(code)));
    }
    slot = code;
}

}  // namespace curvecore::ref
