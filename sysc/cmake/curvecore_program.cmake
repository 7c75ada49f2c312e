# SPDX-License-Identifier: Apache-2.0
# curvecore_program(<target> CORES "<line of compiled_cores.cmake>" ... [SOURCES <file> ...])
# The program with these cores inside, one object each from the same source.  SOURCES stand in for
# the modules of rtl/ that they define.
include(core_parameters)

function(curvecore_program target)
  cmake_parse_arguments(ARG "" "" "CORES;SOURCES" ${ARGN})
  set(builds parallel serial engine)  # as the RTL counts them
  set(build_values kParallel kSerial kEngine)
  set(declarations "")
  set(cores "")
  set(libraries "")
  foreach(line ${ARG_CORES})
    separate_arguments(words UNIX_COMMAND "${line}")
    string(REGEX REPLACE "[ =]+" "_" name "${line}")
    set(core ${target}_${name})
    list(POP_FRONT words build)
    list(FIND builds ${build} number)
    set(params Build=${number})
    list(GET build_values ${number} build)
    core_parameters(values ${words})
    list(APPEND params ${values} SegmentQueueWords=65536 ProfileQueueWords=4096)
    # Waveforms stop above the multipliers.
    verilated_model(${core}_model TOP motion_interpolator PREFIX V${name} TRACE PARAMS ${params}
                    SOURCES --trace-depth 6 ${ARG_SOURCES})
    list(TRANSFORM params PREPEND CFG_ OUTPUT_VARIABLE definitions)
    add_library(${core} OBJECT ${PROJECT_SOURCE_DIR}/sysc/cores/compiled_core.cpp)
    target_compile_definitions(${core} PRIVATE ${definitions} CFG_FUNCTION=core_${name}
                               CFG_MODEL=V${name} CFG_HEADER="V${name}.h")
    target_link_libraries(${core} PRIVATE ${core}_model curvecore_options)
    list(APPEND libraries ${core} ${core}_model)
    string(APPEND declarations "extern \"C\" MakeBoard core_${name};\n")
    list(TRANSFORM words REPLACE "(.+)" "\"\\1\"")
    list(JOIN words ", " set)
    string(APPEND cores "\n        core(Build::${build}, {${set}}, &core_${name}),")
  endforeach()
  set(list ${CMAKE_CURRENT_BINARY_DIR}/generated/${target}/compiled_cores.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/sysc/cores/compiled_cores.cpp.in ${list} @ONLY)
  add_executable(${target} ${list})
  # Cores that are made later share the program's Verilator library.
  set_target_properties(${target} PROPERTIES ENABLE_EXPORTS ON)
  target_link_libraries(${target} PRIVATE ${libraries} curvecore_commands)
endfunction()
