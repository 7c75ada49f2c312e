// SPDX-License-Identifier: Apache-2.0
#include "tb/program/gtkw_writer.hpp"

namespace curvecore::tb {

std::string gtkw(const CoreParameters&) { return ""; }

}  // namespace curvecore::tb
