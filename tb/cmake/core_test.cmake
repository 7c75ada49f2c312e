# SPDX-License-Identifier: Apache-2.0
# core_test(<test> <configuration> TOP <module> [PARAMS Name=Value ...] [SOURCES <file or flag> ...]
#           [LIBRARIES target ...] [FLAT] [TESTS <filter of GoogleTest>])
# builds tb/unit/<room>/<test>_test.cpp against the module in that configuration; its tests are
# called unit.<configuration>.<Suite>.<Test>.  The model is class V<module> in "V<module>.h";
# Name=Value reaches the test as CFG_Name.  FLAT: the model is made of scripts/flat.sh's file.
#
# core_test(<bench> <configuration> TOP <module> PORTS curve|motion [PARAMS ...] [SOURCES ...])
# the same for a bench of any widths, compiled once: bench_objects(<bench>).

# Reading these headers is two thirds of a test's compilation: once for all.
set(nothing ${CMAKE_CURRENT_BINARY_DIR}/nothing.cpp)
file(TOUCH ${nothing})
add_library(core_test_headers OBJECT ${nothing})
target_link_libraries(core_test_headers PRIVATE curvecore_test_options verilator_runtime
                                                Eigen3::Eigen GTest::gtest_main)
target_precompile_headers(core_test_headers PRIVATE <gtest/gtest.h> <verilated.h> <Eigen/Geometry>
                          <algorithm> <array> <functional> <map> <random> <string> <vector>)

# bench_file(<test> <variable>): its file, in whichever room of tb/unit
function(bench_file test variable)
  file(GLOB file ${PROJECT_SOURCE_DIR}/tb/unit/*/${test}_test.cpp)
  list(LENGTH file files)
  if(NOT files EQUAL 1)
    message(FATAL_ERROR "tb/unit has ${files} files ${test}_test.cpp in its rooms, and not one")
  endif()
  set(${variable} ${file} PARENT_SCOPE)
endfunction()

# bench_objects(<bench> [TESTS <test> ...]): bench_<bench>, of <bench>_test.cpp or those of TESTS
function(bench_objects bench)
  cmake_parse_arguments(ARG "" "" "TESTS" ${ARGN})
  if(NOT ARG_TESTS)
    set(ARG_TESTS ${bench})
  endif()
  set(files "")
  foreach(test ${ARG_TESTS})
    bench_file(${test} file)
    list(APPEND files ${file})
  endforeach()
  add_library(bench_${bench} OBJECT ${files}
                                    ${PROJECT_SOURCE_DIR}/tb/support/bench/core_configuration.cpp)
  target_link_libraries(bench_${bench} PUBLIC curvecore_host GTest::gtest_main
                                       PRIVATE curvecore_test_options verilator_runtime)
  target_precompile_headers(bench_${bench} REUSE_FROM core_test_headers)
endfunction()

# core_bench(<target> <bench> MODEL <verilated model> TOP <module> PORTS curve|motion PARAMS ...)
# An executable: the bench's objects with support/bench/<ports>_model.cpp for that configuration.
function(core_bench target bench)
  cmake_parse_arguments(ARG "" "MODEL;TOP;PORTS" "PARAMS" ${ARGN})
  add_executable(${target} ${PROJECT_SOURCE_DIR}/tb/support/bench/${ARG_PORTS}_model.cpp)
  target_precompile_headers(${target} REUSE_FROM core_test_headers)
  list(JOIN ARG_PARAMS " " text)
  target_compile_definitions(${target} PRIVATE MODEL=V${ARG_TOP} MODEL_HEADER="V${ARG_TOP}.h"
                                               CONFIGURATION="${text}")
  target_link_libraries(${target} PRIVATE curvecore_test_options bench_${bench} ${ARG_MODEL})
endfunction()

function(core_test test configuration)
  cmake_parse_arguments(ARG "FLAT" "TOP;PORTS;TESTS" "PARAMS;SOURCES;LIBRARIES" ${ARGN})
  set(target ${test}_${configuration})
  # Tests of one module in one configuration share the model.
  set(flat "")
  if(ARG_FLAT)
    set(flat FLAT)
  endif()
  string(REGEX REPLACE "[=;]" "_" model "${ARG_TOP};${ARG_PARAMS};${flat}model")
  if(NOT TARGET ${model})
    verilated_model(${model} TOP ${ARG_TOP} PARAMS ${ARG_PARAMS} SOURCES ${ARG_SOURCES} ${flat})
  endif()
  if(ARG_PORTS)
    core_bench(${target} ${test} MODEL ${model} TOP ${ARG_TOP} PORTS ${ARG_PORTS}
               PARAMS ${ARG_PARAMS})
  else()
    bench_file(${test} file)
    add_executable(${target} ${file})
    target_precompile_headers(${target} REUSE_FROM core_test_headers)
    list(TRANSFORM ARG_PARAMS PREPEND CFG_ OUTPUT_VARIABLE definitions)
    target_compile_definitions(${target} PRIVATE ${definitions})
    target_link_libraries(${target} PRIVATE curvecore_test_options ${model} curvecore_hls
                                            ${ARG_LIBRARIES} Eigen3::Eigen GTest::gtest_main)
  endif()
  gtest_discover_tests(${target} TEST_PREFIX unit.${configuration}. DISCOVERY_TIMEOUT 600
                       NO_PRETTY_VALUES TEST_FILTER "${ARG_TESTS}" PROPERTIES LABELS unit)
  label_needs(unit ${target})
endfunction()

option(CURVECORE_FULL_CAMPAIGN "Build every configuration, as scripts/campaign.sh does" OFF)
# rows(<variable> <row> ... MORE <row> ...): those of MORE with CURVECORE_FULL_CAMPAIGN alone
function(rows variable)
  cmake_parse_arguments(ARG "" "" "MORE" ${ARGN})
  if(CURVECORE_FULL_CAMPAIGN)
    list(APPEND ARG_UNPARSED_ARGUMENTS ${ARG_MORE})
  endif()
  set(${variable} ${ARG_UNPARSED_ARGUMENTS} PARENT_SCOPE)
endfunction()

# core_tests(<bench> TOP <module> PORTS curve|motion [PARAMS Name=Value ...])
# A core_test for every row of the bench in configurations.csv, of the pairs and the long form with
# CURVECORE_FULL_CAMPAIGN alone; it is called by its values, each after its name's capitals, of the
# flat form by "flat" before them. Of the flat form the short form has what compares samples.
set(table ${CMAKE_CURRENT_SOURCE_DIR}/configurations.csv)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
file(STRINGS ${table} core_rows)
list(POP_FRONT core_rows core_columns)
string(REPLACE "," ";" core_columns ${core_columns})
function(core_tests bench)
  cmake_parse_arguments(ARG "" "TOP;PORTS" "PARAMS" ${ARGN})
  rows(forms short flat MORE pairs long)
  list(JOIN forms "|" form)
  set(rows ${core_rows})
  list(FILTER rows INCLUDE REGEX "^${bench},(${form}),")
  foreach(row ${rows})
    string(REPLACE "," ";" values ${row})
    set(params ${ARG_PARAMS})
    set(name "")
    set(flat "")
    if(row MATCHES "^${bench},flat,")
      set(name flat)
      set(flat FLAT)
      if(NOT CURVECORE_FULL_CAMPAIGN)
        list(APPEND flat TESTS *EqualsKernel*:-MotionStop*)
      endif()
    endif()
    foreach(column value IN ZIP_LISTS core_columns values)
      if(value MATCHES "^[0-9]+$")
        list(APPEND params ${column}=${value})
        string(REGEX REPLACE "[a-z]" "" letters ${column})
        list(APPEND name ${letters}${value})
      endif()
    endforeach()
    list(JOIN name _ name)
    string(TOLOWER ${name} name)
    core_test(${bench} ${name} TOP ${ARG_TOP} PORTS ${ARG_PORTS} PARAMS ${params} ${flat})
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

# illegal_core_parameters(<core>)
# The core refuses values outside the ranges of ref/format/parameters.def;
# tb/model/hls/parameters_test.cpp holds the words of its messages.  A core of several builds, which
# leaves ranges to its parts, refuses what the others than its parallel build do not have.
set(parameter_table ${PROJECT_SOURCE_DIR}/ref/format/parameters.def)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${parameter_table})
file(STRINGS ${parameter_table} parameter_rows REGEX "^PARAMETER")
function(illegal_core_parameters core)
  rtl_file(${core} file)
  file(READ ${file} text)
  string(FIND "${text}" "parameter int Build " both_builds)
  foreach(row ${parameter_rows})
    string(REPLACE ", " ";" row "${row}")
    list(SUBLIST row 1 6 row)
    list(POP_FRONT row name low high default kind builds)
    if(NOT text MATCHES "parameter int ${name} ")
      continue()
    endif()
    if(NOT both_builds EQUAL -1)
      math(EXPR other "${low} + ${high} - ${default}")
      if(builds STREQUAL kParallelAlone)
        illegal_parameter_test(${core} Build=2,${name}=${other}
                               "Build 2 works with ${name} ${default} only")
      endif()
      continue()
    endif()
    math(EXPR values "${high} + 1")
    if(low GREATER 0)
      math(EXPR below "${low} - 1")
      list(APPEND values ${below})
    endif()
    if(kind STREQUAL kPowerOfTwo)
      list(APPEND values 3)
    endif()
    foreach(value ${values})
      illegal_parameter_test(${core} ${name}=${value} "${name} must be ")
    endforeach()
  endforeach()
endfunction()
