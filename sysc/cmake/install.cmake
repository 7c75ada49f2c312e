# SPDX-License-Identifier: Apache-2.0
# Rules of `cmake --install`, in three components:
#   libraries   ref, hls and the host's side, with the assembler that it asks for the engine's
#               clocks, for find_package(curvecore)
#   rtl         the cores' sources with their file lists
#   program     curvecore
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(headers ${CMAKE_INSTALL_INCLUDEDIR}/curvecore)  # they include each other as "ref/..", "hls/.."
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/curvecore)
foreach(library ref hls host assembler)
  set_target_properties(curvecore_${library} PROPERTIES EXPORT_NAME ${library})
  add_library(curvecore::${library} ALIAS curvecore_${library})
  install(TARGETS curvecore_${library} EXPORT curvecore COMPONENT libraries
          INCLUDES DESTINATION ${headers})
endforeach()
foreach(folder ref hls sysc/cli sysc/core sysc/kernel sysc/words sysc/job)
  cmake_path(GET folder PARENT_PATH parent)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${headers}/${parent}
          COMPONENT libraries FILES_MATCHING PATTERN *.hpp PATTERN *.def
          PATTERN kernel_text.hpp EXCLUDE PATTERN statements.hpp EXCLUDE
          PATTERN line_text.hpp EXCLUDE PATTERN row_names.hpp EXCLUDE
          PATTERN order_limits.hpp EXCLUDE)
endforeach()
install(EXPORT curvecore NAMESPACE curvecore:: FILE curvecoreTargets.cmake DESTINATION ${config}
        COMPONENT libraries)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/curvecoreConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/sysc/cmake/curvecoreConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/curvecoreConfigVersion.cmake
        DESTINATION ${config} COMPONENT libraries)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/rtl DESTINATION ${CMAKE_INSTALL_DATADIR}/curvecore
        COMPONENT rtl FILES_MATCHING PATTERN *.sv PATTERN *.vlt PATTERN *.f PATTERN *.core
        PATTERN *.asm)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/ref/curves
        DESTINATION ${CMAKE_INSTALL_DATADIR}/curvecore/ref
        COMPONENT rtl FILES_MATCHING PATTERN *.net)
if(CURVECORE_PROGRAM)
  install(TARGETS curvecore COMPONENT program)
  # Sources of cores that the program makes, in the tree's order beside rtl.
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/sysc/board ${PROJECT_SOURCE_DIR}/sysc/cores
                    ${PROJECT_SOURCE_DIR}/sysc/virtual ${PROJECT_SOURCE_DIR}/sysc/cmake
          DESTINATION ${CMAKE_INSTALL_DATADIR}/curvecore/sysc COMPONENT program
          USE_SOURCE_PERMISSIONS
          FILES_MATCHING PATTERN *.hpp PATTERN compiled_*.cpp PATTERN *.sh)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/sysc/formats
          DESTINATION ${CMAKE_INSTALL_DATADIR}/curvecore COMPONENT program
          FILES_MATCHING PATTERN *.schema.json)
  # LinuxCNC's interpreter, in a separate process and under its own licence.
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/sysc/linuxcnc
          DESTINATION ${CMAKE_INSTALL_DATADIR}/curvecore/sysc COMPONENT program
          USE_SOURCE_PERMISSIONS)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/scripts/boards
          DESTINATION ${CMAKE_INSTALL_DATADIR}/curvecore/scripts COMPONENT program)
  install(FILES ${PROJECT_SOURCE_DIR}/ref/format/queues.hpp
          DESTINATION ${CMAKE_INSTALL_DATADIR}/curvecore/ref/format COMPONENT program)
endif()
