# SPDX-License-Identifier: Apache-2.0
# Kept negative controls: a copy of a source with one defect, and the test that must turn red, of
# label long: scripts/campaign.sh builds and runs them. A mutation whose text is no longer in the
# source stops the configuration.

# mutated_file(<result> <mutant> <file> "old text" "new text"): the broken copy, in the build tree
function(mutated_file result mutant file old new)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${file})
  file(READ ${PROJECT_SOURCE_DIR}/${file} text)
  string(REPLACE "${old}" "${new}" broken "${text}")
  if(broken STREQUAL text)
    message(FATAL_ERROR "mutant ${mutant}: '${old}' is not in ${file}")
  endif()
  set(copy ${CMAKE_CURRENT_BINARY_DIR}/sources/${mutant}/${file})
  file(CONFIGURE OUTPUT ${copy} CONTENT "${broken}" @ONLY)
  set(${result} ${copy} PARENT_SCOPE)
endfunction()

# killed_by(<mutant> <test command> ... MESSAGE <regex>): the command must fail, saying so
function(killed_by mutant)
  cmake_parse_arguments(ARG "" "MESSAGE" "COMMAND" ${ARGN})
  add_test(NAME unit.Mutant.${mutant}IsKilled COMMAND ${ARG_COMMAND})
  set_tests_properties(unit.Mutant.${mutant}IsKilled
                       PROPERTIES LABELS "unit;long" PASS_REGULAR_EXPRESSION "${ARG_MESSAGE}")
  list(GET ARG_COMMAND 0 target)
  label_needs(long ${target})
endfunction()

# survives(<mutant> COMMAND ...): a defect that this test cannot see, stated as a test
function(survives mutant)
  cmake_parse_arguments(ARG "" "" "COMMAND" ${ARGN})
  add_test(NAME unit.Mutant.${mutant}Survives COMMAND ${ARG_COMMAND})
  set_tests_properties(unit.Mutant.${mutant}Survives PROPERTIES LABELS "unit;long")
  list(GET ARG_COMMAND 0 target)
  label_needs(long ${target})
endfunction()
