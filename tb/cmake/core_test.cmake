# SPDX-License-Identifier: Apache-2.0
# core_test(<test> <configuration> TOP <module> [PARAMS Name=Value ...] [SOURCES <file or flag> ...]
#           [LIBRARIES target ...] [TESTS <test> ...])
# builds tb/unit/<test>_test.cpp, or those of TESTS, against the module in that configuration; its
# tests are called unit.<configuration>.<Suite>.<Test>.  The model is class V<module> in
# "V<module>.h"; Name=Value reaches the test as CFG_Name.

# Reading these is two thirds of a test's compilation: once for all.
set(nothing ${CMAKE_CURRENT_BINARY_DIR}/nothing.cpp)
file(TOUCH ${nothing})
add_library(core_test_headers OBJECT ${nothing})
target_link_libraries(core_test_headers PRIVATE curvecore_options verilator_runtime Eigen3::Eigen
                                                GTest::gtest_main)
target_precompile_headers(core_test_headers PRIVATE <gtest/gtest.h> <verilated.h> <Eigen/Geometry>
                          <algorithm> <array> <functional> <map> <random> <string> <vector>)

function(core_test test configuration)
  cmake_parse_arguments(ARG "" "TOP" "PARAMS;SOURCES;LIBRARIES;TESTS" ${ARGN})
  if(NOT ARG_TESTS)
    set(ARG_TESTS ${test})
  endif()
  set(target ${test}_${configuration})
  # Tests of one module in one configuration share the model.
  string(REGEX REPLACE "[=;]" "_" model "${ARG_TOP};${ARG_PARAMS};model")
  if(NOT TARGET ${model})
    verilated_model(${model} TOP ${ARG_TOP} PARAMS ${ARG_PARAMS} SOURCES ${ARG_SOURCES})
  endif()
  list(TRANSFORM ARG_PARAMS PREPEND CFG_ OUTPUT_VARIABLE definitions)
  list(TRANSFORM ARG_TESTS REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/tb/unit/\\1_test.cpp"
       OUTPUT_VARIABLE files)
  add_executable(${target} ${files})
  list(LENGTH files count)
  if(count GREATER 1)
    # They read the same headers: once.
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
  endif()
  target_precompile_headers(${target} REUSE_FROM core_test_headers)
  target_compile_definitions(${target} PRIVATE ${definitions})
  target_link_libraries(${target} PRIVATE ${model} curvecore_options curvecore_hls
                                          ${ARG_LIBRARIES} Eigen3::Eigen GTest::gtest_main)
  gtest_discover_tests(${target} TEST_PREFIX unit.${configuration}. DISCOVERY_TIMEOUT 60
                       PROPERTIES LABELS unit)
  label_needs(unit ${target})
endfunction()

# core_tests(<test> TOP <module> [PARAMS Name=Value ...] ...)
# A core_test for every row of configurations/<test>.csv, called by its values.
set(letters Order=p CoefBits=w PositionBits=b GuardBits=g AuxAxes=a Mode=m Anchor=n SampleInterval=i
            ParameterGuard=u TurnBits=t Splines=s Build=build)
function(core_tests test)
  cmake_parse_arguments(ARG "" "TOP" "PARAMS;LIBRARIES;TESTS" ${ARGN})
  set(tables ${test}.csv)
  if(CURVECORE_FULL_CAMPAIGN)
    file(GLOB more RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/configurations
         CONFIGURE_DEPENDS configurations/long/${test}.csv)
    list(APPEND tables ${more})
  endif()
  foreach(table ${tables})
    set(table ${CMAKE_CURRENT_SOURCE_DIR}/configurations/${table})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
    file(STRINGS ${table} rows)
    list(POP_FRONT rows columns)
    string(REPLACE "," ";" columns ${columns})
    foreach(row ${rows})
      string(REPLACE "," ";" values ${row})
      set(params ${ARG_PARAMS})
      set(name "")
      foreach(column value IN ZIP_LISTS columns values)
        list(APPEND params ${column}=${value})
        string(REGEX MATCH "(^|;)${column}=([a-z]+)" letter "${letters}")
        list(APPEND name ${CMAKE_MATCH_2}${value})
      endforeach()
      list(JOIN name _ name)
      core_test(${test} ${name} TOP ${ARG_TOP} PARAMS ${params} LIBRARIES ${ARG_LIBRARIES}
                TESTS ${ARG_TESTS})
    endforeach()
  endforeach()
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
