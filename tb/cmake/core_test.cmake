# SPDX-License-Identifier: Apache-2.0
# core_test(<test> <configuration> TOP <module> [PARAMS Name=Value ...] [SOURCES <file or flag> ...]
#           [LIBRARIES target ...])
# builds tb/unit/<test>_test.cpp against the module in that configuration; its tests are called
# unit.<configuration>.<Suite>.<Test>.  The model is class V<module> in "V<module>.h"; Name=Value
# reaches the test as CFG_Name.
# Reading these is two thirds of a test's compilation: once for all.
set(nothing ${CMAKE_CURRENT_BINARY_DIR}/nothing.cpp)
file(TOUCH ${nothing})
add_library(core_test_headers OBJECT ${nothing})
target_link_libraries(core_test_headers PRIVATE curvecore_options verilator_runtime Eigen3::Eigen
                                                GTest::gtest_main)
target_precompile_headers(core_test_headers PRIVATE <gtest/gtest.h> <verilated.h> <Eigen/Geometry>
                          <algorithm> <array> <functional> <map> <random> <string> <vector>)

function(core_test test configuration)
  cmake_parse_arguments(ARG "" "TOP" "PARAMS;SOURCES;LIBRARIES" ${ARGN})
  set(target ${test}_${configuration})
  # Tests of one module in one configuration share the model.
  string(REGEX REPLACE "[=;]" "_" model "${ARG_TOP};${ARG_PARAMS};model")
  if(NOT TARGET ${model})
    verilated_model(${model} TOP ${ARG_TOP} PARAMS ${ARG_PARAMS} SOURCES ${ARG_SOURCES})
  endif()
  list(TRANSFORM ARG_PARAMS PREPEND CFG_ OUTPUT_VARIABLE definitions)
  add_executable(${target} ${PROJECT_SOURCE_DIR}/tb/unit/${test}_test.cpp)
  target_precompile_headers(${target} REUSE_FROM core_test_headers)
  target_compile_definitions(${target} PRIVATE ${definitions})
  target_link_libraries(${target} PRIVATE ${model} curvecore_options curvecore_hls
                                          ${ARG_LIBRARIES} Eigen3::Eigen GTest::gtest_main)
  gtest_discover_tests(${target} TEST_PREFIX unit.${configuration}. DISCOVERY_TIMEOUT 60
                       PROPERTIES LABELS unit)
endfunction()

# illegal_parameter_test(<module> Name=Value[,Name=Value ...] "message")
# The module refuses the parameters when elaborated, and says why.
find_program(IVERILOG iverilog REQUIRED)
find_program(VVP vvp REQUIRED)
function(illegal_parameter_test module parameter message)
  rtl_file(${module} file)
  set(name unit.${module}.Rejects.${parameter})
  string(REPLACE "," ";-P${module}." parameters ${parameter})
  add_test(NAME ${name}
           COMMAND ${PROJECT_SOURCE_DIR}/tb/cmake/elaborate.sh ${IVERILOG} ${VVP} -s ${module}
                   -P${module}.${parameters} -Y .sv ${RTL_SEARCH} ${RTL_PACKAGES} ${file})
  set_tests_properties(${name} PROPERTIES LABELS unit
                       PASS_REGULAR_EXPRESSION "FATAL: [^\n]*${message}")
endfunction()
