# SPDX-License-Identifier: Apache-2.0
# verilated_model(<target> TOP <module> [PREFIX V<module>] [TRACE] [PARAMS Name=Value ...]
#                 [SOURCES <file or flag> ...] [FLAT] [SC])
# A library: one module as a C++ class PREFIX in PREFIX.h.  Verilator runs at build time, and again
# only when a source that this model reads has changed (it writes the dependency file).
# SOURCES may contain another file of the module itself.
# SC makes a module of SystemC.
# A model of Build=2, said or by default, comes with the engine's programs for its parameters.
# FLAT reads the one file that scripts/flat.sh makes of the module.
find_program(VERILATOR verilator REQUIRED)
execute_process(COMMAND ${VERILATOR} --getenv VERILATOR_ROOT OUTPUT_VARIABLE VERILATOR_ROOT
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

execute_process(COMMAND ${VERILATOR} --version OUTPUT_VARIABLE VERILATOR_VERSION
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "[0-9]+\\.[0-9]+" VERILATOR_VERSION "${VERILATOR_VERSION}")

# Verilator's own C++ library, once for all models.
set(verilator_include ${VERILATOR_ROOT}/include)
add_library(verilator_runtime STATIC
            ${verilator_include}/verilated.cpp ${verilator_include}/verilated_threads.cpp
            ${verilator_include}/verilated_fst_c.cpp ${verilator_include}/verilated_cov.cpp)
target_include_directories(verilator_runtime SYSTEM PUBLIC ${verilator_include}
                                                           ${verilator_include}/vltstd)
target_compile_definitions(verilator_runtime PUBLIC VM_SC=0 VM_TRACE=1 VM_TRACE_FST=1 VM_TRACE_VCD=0
                           VM_COVERAGE=$<BOOL:${CURVECORE_COVERAGE}>)
target_compile_options(verilator_runtime PRIVATE -w)
if(CURVECORE_SANITIZE)
  # GTKWave's writer of waveforms, in Verilator's library, shifts negative words and stores
  # unaligned words. Models are not instrumented: their C++ is Verilator's.
  target_compile_options(verilator_runtime PRIVATE -fno-sanitize=undefined)
endif()
find_package(ZLIB REQUIRED)
find_package(Threads REQUIRED)
target_link_libraries(verilator_runtime PUBLIC ZLIB::ZLIB Threads::Threads)

# Headers that every model reads first, half of its compilation: compiled once, with the options of
# Verilator's makefile, for models without traces and SystemC: those set other macros.
set(verilated_headers ${PROJECT_BINARY_DIR}/verilated/verilated.hpp CACHE INTERNAL "")
file(CONFIGURE OUTPUT ${verilated_headers} CONTENT "#include <verilated.h>\n")
set(any_time "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  set(any_time -Xclang -fno-pch-timestamp)
endif()
add_custom_command(
  OUTPUT ${verilated_headers}.gch
  COMMAND ${CMAKE_CXX_COMPILER} -x c++-header -I${verilator_include}
          -DVM_COVERAGE=$<BOOL:${CURVECORE_COVERAGE}> -DVM_SC=0 -DVM_TRACE=0 -DVM_TRACE_FST=0
          -DVM_TRACE_VCD=0 -faligned-new -fcf-protection=none -std=c++17 -w -O1
          ${any_time}
          -o ${verilated_headers}.gch ${verilated_headers}
  DEPENDS ${verilated_headers} ${verilator_include}/verilated.h
  VERBATIM)
add_custom_target(verilated_headers DEPENDS ${verilated_headers}.gch)

function(verilated_model target)
  cmake_parse_arguments(ARG "TRACE;FLAT;SC" "TOP;PREFIX" "PARAMS;SOURCES" ${ARGN})
  if(NOT ARG_PREFIX)
    set(ARG_PREFIX V${ARG_TOP})
  endif()
  rtl_file(${ARG_TOP} top_file)
  set(dir ${CMAKE_CURRENT_BINARY_DIR}/model/${target})
  set(archive ${dir}/${ARG_PREFIX}__ALL.a)
  set(flags --top-module ${ARG_TOP} --prefix ${ARG_PREFIX})
  set(flat "")
  set(microcode "")
  set(makes_programs "")
  set(build "${ARG_PARAMS}")
  if(top_file AND NOT build MATCHES "Build=")
    file(STRINGS ${top_file} build REGEX "parameter int Build  *= ")
  endif()
  if("${build}" MATCHES "Build *= *2")
    set(makes_programs microcode_generator ${ENGINE_SOURCES})
  endif()
  if(ARG_FLAT)
    set(flat ${dir}/${ARG_TOP}.v)
    add_custom_command(
      OUTPUT ${flat}
      COMMAND ${CMAKE_COMMAND} -E env MICROCODE_GENERATOR=$<TARGET_FILE:microcode_generator>
              ${PROJECT_SOURCE_DIR}/scripts/flat.sh ${ARG_TOP} ${ARG_PARAMS} -o ${flat}
      DEPENDS ${PROJECT_SOURCE_DIR}/scripts/flat.sh ${RTL_PACKAGES} ${RTL_MODULES}
              ${makes_programs}
      VERBATIM)
    set(sources ${flat})
    # Words of the levels of a hierarchy are merged; one part of such a word may depend on another.
    # Verilator 5.006 makes wrong models of some of these with its data flow graphs.
    list(APPEND flags --language 1364-2005 -Wno-lint -Wno-UNOPTFLAT -fno-dfg)
  else()
    if(makes_programs)
      set(microcode ${dir}/program.hex ${dir}/data.hex)
      add_custom_command(
        OUTPUT ${microcode}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${dir}
        COMMAND microcode_generator ${PROJECT_SOURCE_DIR} ${dir} ${ARG_TOP} ${ARG_PARAMS}
        DEPENDS ${makes_programs}
        VERBATIM)
      list(APPEND flags "-GProgram=\"${dir}/program.hex\"" "-GData=\"${dir}/data.hex\"")
    endif()
    list(TRANSFORM ARG_PARAMS PREPEND -G)
    list(APPEND flags ${ARG_PARAMS} ${RTL_SEARCH})
    set(sources ${RTL_PACKAGES} ${ARG_SOURCES})
    if(NOT "${ARG_SOURCES}" MATCHES "/${ARG_TOP}\\.sv")
      list(APPEND sources ${top_file})
    endif()
  endif()
  set(headers "-include ${verilated_headers}")
  if(ARG_SC)
    list(APPEND flags --sc)
    set(headers "")
  endif()
  if(ARG_TRACE)
    list(APPEND flags --trace-fst)
    set(headers "")
  endif()
  if(CURVECORE_COVERAGE)
    list(APPEND flags --coverage-line)
  endif()
  add_custom_command(
    OUTPUT ${archive}
    BYPRODUCTS ${dir}/${ARG_PREFIX}.h
    COMMAND ${CMAKE_COMMAND} -E env "CXX=${CMAKE_CXX_COMPILER}"
            "CCACHE=${CMAKE_CXX_COMPILER_LAUNCHER}" "VERILATOR=${VERILATOR}"
            "CFLAGS=${headers}"
            ${PROJECT_SOURCE_DIR}/sysc/cmake/verilate.sh ${dir} ${ARG_PREFIX} ${flags}
            ${sources}
    DEPENDS ${PROJECT_SOURCE_DIR}/sysc/cmake/verilate.sh ${verilated_headers}.gch ${flat}
            ${microcode}
    DEPFILE ${dir}/model.d
    COMMENT "Verilating ${target}"
    VERBATIM COMMAND_EXPAND_LISTS)
  add_custom_target(${target}_archive DEPENDS ${archive})
  add_dependencies(${target}_archive verilated_headers)
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_archive)
  target_include_directories(${target} SYSTEM INTERFACE ${dir})
  target_link_libraries(${target} INTERFACE ${archive} verilator_runtime)
endfunction()
