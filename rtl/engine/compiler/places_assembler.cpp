// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/compiler/places_assembler.hpp"

#include <fmt/format.h>

#include <functional>

#include "rtl/engine/assembler/source.hpp"

namespace curvecore::assembler {
namespace {

using engine::Op;

constexpr int kFirstAuxiliary = 3;
constexpr int kPage = 1;      // of auxiliary axes: that of their places
constexpr int kProduct = 45;  // what MULR drops

/// Programs of the auxiliary axes, of which there are some, as places.asm has them for X, Y and Z.
class AuxiliaryPlaces {
  public:
    AuxiliaryPlaces(const ref::CoreParameters& core, Assembly& assembly)
        : axes_(core.axes()), assembly_(assembly) {}

    void write() {
        subroutine("place_auxiliary", [this](int axis) {
            assembly_.open_auxiliary();
            const Field fine = assembly_.auxiliary_word(fmt::format("fine[{}]", axis));
            multiply(position(), fine, power("fine_left"));
            assembly_.open_auxiliary(kPage);
            put_place(axis);
        });
        subroutine("place_auxiliary_positions", [this](int axis) {
            if (axis == kFirstAuxiliary) assembly_.open_auxiliary(kPage);
            in("position_in", position());
            multiply(position(), position(), power("position_room"));
            put_place(axis);
        });
        begin("read_auxiliary_scales");
        assembly_.open_auxiliary(kPage);
        for (int axis = kFirstAuxiliary; axis < axes_; ++axis) {
            const Field scale = word("scale", axis);
            in("scale_low", scale);
            in("scale_high", moved());
            multiply(moved(), moved(), assembly_.power(31));
            assembly_.add(scale, scale, moved());
            assembly_.add(scale, scale, moved());
        }
        end();
    }

  private:
    void begin(const std::string& label) {
        assembly_.from({"", 0, label});
        assembly_.label(label);
    }
    void end() {
        assembly_.close_axes();
        assembly_.give_back();
    }
    /// A subroutine that calls others for each axis.
    void subroutine(const std::string& label, const std::function<void(int)>& body) {
        const Field link{engine::kPortLink, "link"};
        begin(label);
        assembly_.put(Op::kIn, kept(), link, {}, false, 1);
        for (int axis = kFirstAuxiliary; axis < axes_; ++axis) {
            assembly_.from({"", 0, fmt::format("{}, axis {}", label, axis)});
            body(axis);
        }
        assembly_.put(Op::kOut, {}, kept(), link, false, 1);
        end();
    }

    void put_place(int axis) {
        const Field place = word("place", axis);
        assembly_.put(Op::kMulr, position(), position(), word("scale", axis), true);
        assembly_.put(Op::kSub, moved(), position(), place);
        assembly_.copy(place, position());
        assembly_.call("put_moved");
    }
    void multiply(const Field& to, const Field& a, const Field& b) {
        assembly_.put(Op::kMull, to, a, b);
    }
    void in(const std::string& port, const Field& to) {
        assembly_.put(Op::kIn, to, {static_cast<int>(*assembly_.defined(port)), port}, {});
    }
    Field power(const std::string& name) {
        return assembly_.power(static_cast<int>(*assembly_.defined(name)));
    }
    // Locals of places.asm, in their order
    Field position() { return assembly_.scratch(0); }
    Field moved() { return assembly_.scratch(1); }
    Field kept() { return assembly_.scratch(2); }
    Field word(const char* what, int axis) {
        return assembly_.auxiliary_word(fmt::format("{}[{}]", what, axis), kPage);
    }

    int axes_;
    Assembly& assembly_;
};

}  // namespace

void assemble_places(const std::string& programs, const ref::CoreParameters& core, int rate_bits,
                     Assembly& assembly) {
    assembly.define("fine_left", kProduct - core.position_bits - core.guard_bits);
    assembly.define("position_room", kProduct - core.position_bits);
    assembly.define("far_bound", kProduct + 1 - rate_bits);
    assembly.define("rate_room", 30 - rate_bits);
    if (core.aux_axes == 0) {
        for (const char* name :
             {"place_auxiliary", "place_auxiliary_positions", "read_auxiliary_scales"}) {
            assembly.leave_out(name);
        }
    }
    assemble_source(programs + "/places.asm", assembly);
    if (core.aux_axes > 0) AuxiliaryPlaces(core, assembly).write();
}

}  // namespace curvecore::assembler
