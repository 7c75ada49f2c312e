# SPDX-License-Identifier: Apache-2.0
# curvecore_program(<target> CORES "<line of compiled_cores.cmake>" ... [SOURCES <file> ...])
# The program with these cores inside, one object each from the same source.  SOURCES stand in for
# the modules of rtl/ that they define.
function(curvecore_program target)
  cmake_parse_arguments(ARG "" "" "CORES;SOURCES" ${ARGN})
  set(declarations "")
  set(calls "")
  set(cores "")
  foreach(line ${ARG_CORES})
    separate_arguments(words UNIX_COMMAND "${line}")
    list(JOIN words "_" name)
    set(core ${target}_${name})
    list(POP_FRONT words build)
    string(COMPARE EQUAL ${build} serial params)
    set(params Build=${params})
    foreach(parameter Order CoefBits PositionBits GuardBits AuxAxes Splines Mode SampleInterval
                      TurnBits ParameterGuard)
      list(POP_FRONT words value)
      list(APPEND params ${parameter}=${value})
    endforeach()
    # Queues as deep as a host would keep its buffer; waveforms stop above the multipliers.
    verilated_model(${core}_model TOP motion_interpolator PREFIX V${name} TRACE
                    PARAMS ${params} SegmentQueueWords=256 ProfileQueueWords=4096
                    SOURCES --trace-depth 5 ${ARG_SOURCES})
    list(TRANSFORM params PREPEND CFG_ OUTPUT_VARIABLE definitions)
    add_library(${core} OBJECT ${PROJECT_SOURCE_DIR}/tb/program/compiled_core.cpp)
    target_compile_definitions(${core} PRIVATE ${definitions} CFG_FUNCTION=core_${name}
                               CFG_MODEL=V${name} CFG_HEADER="V${name}.h")
    target_link_libraries(${core} PRIVATE ${core}_model curvecore_options curvecore_ref
                                          curvecore_hls nlohmann_json::nlohmann_json)
    list(APPEND cores ${core} ${core}_model)
    string(APPEND declarations "CompiledCore core_${name}();\n")
    string(APPEND calls "core_${name}(), ")
  endforeach()
  set(list ${CMAKE_CURRENT_BINARY_DIR}/generated/${target}/compiled_cores.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/tb/program/compiled_cores.cpp.in ${list} @ONLY)
  add_executable(${target} ${list})
  target_link_libraries(${target} PRIVATE ${cores} curvecore_commands curvecore_choose
                                          curvecore_compare curvecore_command curvecore_options
                                          curvecore_ref curvecore_hls nlohmann_json::nlohmann_json
                                          fmt::fmt CLI11::CLI11 Threads::Threads)
endfunction()
