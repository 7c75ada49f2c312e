# SPDX-License-Identifier: Apache-2.0
# add_lint_tests(): every module of rtl as its own top through five tools, and the C++ trees.
#   lint.<module>.verilator|icarus|yosys|verible    lint.slang    lint.<tree>.format|tidy
#   lint.files    lint.configurations    lint.licences
# Waivers: rtl/waivers.vlt, each with its reason; verible's and clang-tidy's rules beside this.
find_program(YOSYS yosys REQUIRED)
find_program(VERIBLE_LINT verible-verilog-lint)
find_program(VERIBLE_FORMAT verible-verilog-format)
find_program(CLANG_FORMAT clang-format REQUIRED)
find_program(CLANG_TIDY clang-tidy REQUIRED)
if(NOT VERIBLE_LINT OR NOT VERIBLE_FORMAT)
  message(FATAL_ERROR "verible is missing: run scripts/setup.sh")
endif()

function(lint_test name)
  add_test(NAME lint.${name} COMMAND ${ARGN})
  set_tests_properties(lint.${name} PROPERTIES LABELS lint)
endfunction()

function(lint_module file)
  cmake_path(GET file STEM module)
  lint_test(${module}.verilator ${VERILATOR} --lint-only -Wall --top-module ${module}
            ${lint_waivers} ${RTL_SEARCH} -DNO_ICE40_DEFAULT_ASSIGNMENTS -v ${ICE40_CELLS}
            ${RTL_PACKAGES} ${file})
  lint_test(${module}.icarus ${IVERILOG} -g2012 -Wall -Wno-timescale -tnull -s ${module} -Y .sv
            ${RTL_SEARCH} -DNO_ICE40_DEFAULT_ASSIGNMENTS -l ${ICE40_CELLS} ${RTL_PACKAGES} ${file})
  lint_test(${module}.yosys ${PROJECT_SOURCE_DIR}/tb/lint/yosys.sh ${YOSYS} ${file}
            ${RTL_PACKAGES} ${RTL_MODULES})
  set_tests_properties(lint.${module}.verilator lint.${module}.icarus lint.${module}.yosys
                       PROPERTIES FAIL_REGULAR_EXPRESSION "[Ww]arning")
endfunction()

function(lint_style file)
  cmake_path(GET file STEM module)
  lint_test(${module}.verible ${PROJECT_SOURCE_DIR}/tb/lint/verible.sh ${VERIBLE_LINT}
            ${VERIBLE_FORMAT} ${file})
endfunction()

function(add_lint_tests)
  file(GLOB lint_waivers ${PROJECT_SOURCE_DIR}/rtl/waivers.vlt)
  foreach(file ${RTL_MODULES})
    lint_module(${file})
  endforeach()
  file(GLOB_RECURSE test_modules CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tb/*.sv)
  foreach(file ${RTL_PACKAGES} ${RTL_MODULES} ${RTL_EXAMPLES} ${test_modules})
    lint_style(${file})
  endforeach()
  foreach(tree ref hls rtl sysc tb)
    lint_test(${tree}.format ${PROJECT_SOURCE_DIR}/tb/lint/clang_format.sh ${CLANG_FORMAT}
              ${PROJECT_SOURCE_DIR}/${tree})
  endforeach()
  # hls has headers only: they are seen through these. Not the tests: GoogleTest's macros take
  # clang-tidy half a minute a file.
  foreach(tree ref rtl sysc tb/campaign)
    string(REPLACE "/" "." name ${tree})
    lint_test(${name}.tidy ${PROJECT_SOURCE_DIR}/tb/lint/clang_tidy.sh ${CLANG_TIDY}
              ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR}/${tree})
    set_tests_properties(lint.${name}.tidy PROPERTIES PROCESSORS 2 COST 1000 TIMEOUT 7200)
  endforeach()
  lint_test(files.curvecore.f.elaborates ${VERILATOR} --lint-only -Wall ${lint_waivers}
            -F ${PROJECT_SOURCE_DIR}/rtl/curvecore.f --top-module motion_interpolator)
  cmake_path(GET ICE40_CELLS PARENT_PATH cells)
  lint_test(slang ${PROJECT_SOURCE_DIR}/.venv/bin/python3 ${PROJECT_SOURCE_DIR}/tb/lint/slang.py
            ${ICE40_CELLS} ${cells}/../ecp5/cells_bb.v)
  lint_test(packages ${PROJECT_SOURCE_DIR}/.venv/bin/python3
            ${PROJECT_SOURCE_DIR}/tb/lint/packages.py)
  lint_test(configurations ${PROJECT_SOURCE_DIR}/tb/lint/configurations.py)
  lint_test(rooms ${PROJECT_SOURCE_DIR}/tb/lint/rooms.py)
  lint_test(readmes ${PROJECT_SOURCE_DIR}/tb/lint/readmes.py)
  lint_test(test_names ${PROJECT_SOURCE_DIR}/tb/lint/test_names.sh ${PROJECT_BINARY_DIR})
  lint_test(long_tests ${PROJECT_SOURCE_DIR}/tb/lint/long_tests.sh ${PROJECT_BINARY_DIR}
            ${PROJECT_SOURCE_DIR}/tb/long/tests.txt)
  lint_test(language ${PROJECT_SOURCE_DIR}/tb/lint/language.py)
  lint_test(results ${PROJECT_SOURCE_DIR}/scripts/results.py --check)
  lint_test(files ${PROJECT_SOURCE_DIR}/tb/lint/files.py ${PROJECT_SOURCE_DIR})
  lint_test(c_headers ${PROJECT_SOURCE_DIR}/tb/lint/c_headers.sh ${PROJECT_SOURCE_DIR})
  lint_test(licences ${PROJECT_SOURCE_DIR}/tb/lint/licences.sh ${PROJECT_SOURCE_DIR})
  lint_test(licences.breaches ${PROJECT_SOURCE_DIR}/tb/lint/licence_breaches.sh
            ${PROJECT_SOURCE_DIR})
endfunction()
