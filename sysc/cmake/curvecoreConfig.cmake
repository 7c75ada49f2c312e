# SPDX-License-Identifier: Apache-2.0
# find_package(curvecore):
#   curvecore::ref    curves, plans, bounds
#   curvecore::hls    words and kernels, headers only
#   curvecore::host   programs as words; links both
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 NO_MODULE)
find_dependency(fmt)
find_dependency(nlohmann_json)
find_dependency(Boost)
include(${CMAKE_CURRENT_LIST_DIR}/curvecoreTargets.cmake)
