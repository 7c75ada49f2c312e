// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/remedy.hpp"

#include <fmt/format.h>

namespace curvecore::ref {

std::string remedy(const PlanOptions& options,
                   const std::function<bool(const CoreParameters& format, double unit_mm)>& fits) {
    double unit = options.unit_mm;
    for (int i = 0; i < 3; ++i) {  // an arc of a few units needs no wider words
        unit /= 10;
        if (fits(options.format, unit)) return fmt::format("needs a unit of {:g} mm", unit);
    }
    CoreParameters format = options.format;
    const auto wide_enough = [&] { return fits(format, options.unit_mm); };
    while (format.coef_bits < 36) {
        ++format.coef_bits;
        if (wide_enough()) return fmt::format("needs CoefBits {}", format.coef_bits);
    }
    while (format.guard_bits < 12) {
        ++format.guard_bits;
        if (!wide_enough()) continue;
        format.coef_bits = options.format.coef_bits;
        while (format.coef_bits < 36 && !wide_enough()) ++format.coef_bits;
        return format.coef_bits == options.format.coef_bits
                   ? fmt::format("needs GuardBits {}", format.guard_bits)
                   : fmt::format("needs GuardBits {} and CoefBits {}", format.guard_bits,
                                 format.coef_bits);
    }
    while (format.order < 12) {
        ++format.order;
        if (wide_enough()) {
            return fmt::format("needs Order {}, CoefBits 36 and GuardBits 12", format.order);
        }
    }
    return "is beyond the widest words";
}

}  // namespace curvecore::ref
