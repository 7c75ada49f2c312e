# SPDX-License-Identifier: Apache-2.0
# A board's motion, from its registers to its pins: configurations of motion_system under test.
function(system_test test configuration)
  core_test(${test} ${configuration} TOP motion_system ${ARGN} LIBRARIES curvecore_board
            curvecore_assembler)
  target_compile_definitions(
    ${test}_${configuration} PRIVATE DATA_DIR="${CMAKE_CURRENT_SOURCE_DIR}/data"
                                     RTL_DIR="${PROJECT_SOURCE_DIR}/rtl"
                                     CURVES_DIR="${PROJECT_SOURCE_DIR}/ref/curves")
endfunction()
set(system PARAMS TimeBits=10 ClockHertz=2560000 SamplesAhead=15 SampleBufferWords=512)
set(queues SegmentQueueWords=4096 ProfileQueueWords=512)
set(parallel ${system} ${queues} Build=0 PeriodLog2=8 ScaleBits=48 Galvo=1 Encoders=2)
set(engine ${system} Build=2 PeriodLog2=12 ScaleBits=44 Galvo=0)
foreach(test motion_system motion_begin motion_probe motion_encoder position_mode)
  system_test(${test} parallel ${parallel})
  system_test(${test} engine ${engine} ${queues} Encoders=2)
endforeach()
foreach(test system_microcode system_time)
  system_test(${test} engine ${engine} SegmentQueueWords=1024 ProfileQueueWords=1024
              SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/unit/motion/microcode.vlt)
endforeach()
# The same beside its flat file, clock by clock.
verilated_model(flat_motion_system TOP motion_system PREFIX Vflat_motion_system FLAT ${engine}
                ${queues} Encoders=2)
system_test(motion_system flat TESTS *.SaysWhat*:*.DrawsAProgram*:*.Random* ${engine} ${queues}
            Encoders=2)
target_link_libraries(motion_system_flat PRIVATE flat_motion_system)
target_compile_definitions(motion_system_flat PRIVATE FLAT_TWIN)
# With outputs along the path.
set(long_queues SegmentQueueWords=1024 ProfileQueueWords=2048)
system_test(motion_outputs parallel ${system} ${long_queues} Build=0 PeriodLog2=8 ScaleBits=48
            Galvo=0 Outputs=64 Shaper=0)
system_test(motion_outputs engine ${engine} ${long_queues} Outputs=1024 Shaper=0)
# With a shaper of what swings behind the drives.
system_test(motion_shaper parallel ${system} ${long_queues} Build=0 PeriodLog2=8 ScaleBits=48
            Galvo=0 Shaper=256)
system_test(motion_shaper engine ${engine} ${long_queues} Shaper=64)
# Both: outputs where the tool is.
set(where_the_tool_is *.ChangeWhere*:*.KeepTheir*)
system_test(motion_outputs parallel_shaped TESTS ${where_the_tool_is} ${system} ${long_queues}
            Build=0 PeriodLog2=8 ScaleBits=48 Galvo=0 Outputs=64 Shaper=256)
system_test(motion_outputs engine_shaped TESTS ${where_the_tool_is} ${engine} ${long_queues}
            Outputs=1024 Shaper=64)
