# SPDX-License-Identifier: Apache-2.0
# The configurations of all modules under test: those of the cores are the rows of
# configurations.csv, the others stand here.
#   core_test(<test file without _test.cpp> <configuration> TOP <module> PARAMS Name=Value ...)
# makes tests unit.<configuration>.<Suite>.<Test>; Name=Value reaches the RTL as a parameter and the
# test as CFG_Name.

# read_row(<value>,<value>,... <variable> <variable> ...)
macro(read_row row)
  string(REPLACE "," ";" row_values ${row})
  foreach(variable ${ARGN})
    list(POP_FRONT row_values ${variable})
  endforeach()
endmacro()

# Multipliers: Form is 0 portable, 1 ECP5, 2 UP5K.
set(form_0 portable)
set(form_1 ecp5)
set(form_2 up5k)
set(primitives_2 -Wno-lint -Wno-TIMESCALEMOD -DNO_ICE40_DEFAULT_ASSIGNMENTS -v ${ICE40_CELLS})
# Every form with factors of one digit and of more, on either side.
rows(sizes 0,18,18,0 0,36,36,35 1,18,36,17 1,36,36,0 2,36,18,0 2,33,27,20
     MORE 0,36,18,0 0,33,27,20 1,18,18,0 1,36,18,0 1,32,32,31 2,18,18,0 2,18,36,17 2,36,36,35)
foreach(size ${sizes})
  read_row(${size} form a b shift)
  core_test(multiplier ${form_${form}}_${a}x${b}_${shift} TOP multiplier
            PARAMS ABits=${a} BBits=${b} Shift=${shift} Form=${form} SOURCES ${primitives_${form}})
endforeach()
illegal_parameter_test(multiplier ABits=17 "ABits must be in .18, 36.")
illegal_parameter_test(multiplier BBits=37 "BBits must be in .18, 36.")
illegal_parameter_test(multiplier Shift=36 "Shift must be in .0, 35.")
illegal_parameter_test(multiplier Form=3 "Form must be 0, 1 or 2")

# The engine: instructions, bits of words, form.
rows(sizes 2048,8,0 128,9,1 MORE 32768,12,2)
foreach(size ${sizes})
  read_row(${size} instructions words form)
  core_test(motion_engine i${instructions}_w${words}_${form_${form}} TOP motion_engine
            PARAMS Instructions=${instructions} WordBits=${words} Form=${form}
            SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/unit/arithmetic/motion_engine.vlt
                    ${primitives_${form}})
endforeach()
illegal_parameter_test(motion_engine Instructions=32769 "Instructions must be in .2, 32768.")
illegal_parameter_test(motion_engine WordBits=7 "WordBits must be in .8, 12.")
illegal_parameter_test(motion_engine Form=3 "Form must be 0, 1 or 2")
illegal_parameter_test(motion_engine Foreground=2 "Foreground must be 0 or 1")

# The engine's words on their way.
foreach(words 2 128)
  core_test(engine_entry w${words} TOP engine_entry PARAMS Words=${words})
endforeach()
illegal_parameter_test(engine_entry Words=48 "Words must be a power of two in .2, 4096.")

# The engine's samples as rates: axes, sample period.
rows(sizes 3,13 9,6)
foreach(size ${sizes})
  read_row(${size} axes period)
  core_test(engine_rates a${axes}_k${period} TOP engine_rates
            PARAMS Axes=${axes} PeriodLog2=${period})
endforeach()
illegal_parameter_test(engine_rates Axes=10 "Axes must be in .1, 9.")
illegal_parameter_test(motion_system ScaleBits=46 "ScaleBits must be in .40, 45. with Build 2")
illegal_parameter_test(engine_rates PeriodLog2=14 "PeriodLog2 must be in .6, 13. with Build 2")
illegal_parameter_test(engine_motion Ahead=17 "Ahead must be in .1, 16.")

# Large memories: bits, words, form.
rows(sizes 16,20480,0 20,40000,2)
foreach(size ${sizes})
  read_row(${size} bits words form)
  core_test(single_port_memory b${bits}_w${words}_${form_${form}} TOP single_port_memory
            PARAMS Bits=${bits} Words=${words} Form=${form} SOURCES ${primitives_${form}})
endforeach()
illegal_parameter_test(single_port_memory Words=8 "Words must be in .16, 262144.")
rows(sizes 0,0 0,1 2,0 2,1)
foreach(size ${sizes})
  read_row(${size} form holds)
  core_test(position_buffer a3_${form_${form}}_h${holds} TOP position_buffer
            PARAMS Axes=3 Bits=32 Words=64 Form=${form} Holds=${holds}
            SOURCES ${primitives_${form}})
endforeach()
illegal_parameter_test(position_buffer Holds=2 "Holds must be 0 or 1")

# Outputs along the path: words that wait, form of their memory, samples that are kept for a delay.
rows(sizes 64,0,0 1024,2,0 64,0,64)
foreach(size ${sizes})
  read_row(${size} words form delay)
  core_test(path_outputs w${words}_${form_${form}}_d${delay} TOP path_outputs
            PARAMS Words=${words} Form=${form} Delay=${delay} SOURCES ${primitives_${form}})
endforeach()
illegal_parameter_test(path_outputs Delay=96 "Places must be a power of two in .64, 512.")
illegal_parameter_test(path_outputs Words=96 "Words must be a power of two in .64, 4096.")

# Shapers: axes, period, places that are kept.
rows(sizes 3,8,64 9,13,256)
foreach(size ${sizes})
  read_row(${size} axes period places)
  core_test(input_shaper a${axes}_p${period}_k${places} TOP input_shaper
            PARAMS Axes=${axes} PeriodLog2=${period} Places=${places})
endforeach()
illegal_parameter_test(input_shaper Places=32 "Places must be a power of two in .64, 512.")
illegal_parameter_test(input_shaper PeriodLog2=14 "PeriodLog2 must be at most 13")
illegal_parameter_test(input_shaper Axes=10 "Axes must be in .1, 9.")
illegal_parameter_test(input_shaper Axes=9,PeriodLog2=7 "27 clocks an axis and 6 must fit")
illegal_parameter_test(step_generator Shaper=64,FineBits=23 "FineBits must be at least 24 with a")
illegal_parameter_test(motion_pins Galvo=1,Shaper=64 "Galvo works without Shaper only")

# The serial build's datapath, for arcs and for both kinds.
foreach(splines 0 1)
  core_test(folded_datapath splines_${splines} TOP folded_datapath
            PARAMS CoefBits=36 Splines=${splines})
endforeach()

# Sums of products on one 18 x 18 multiplier: word, two shifts, form.
rows(sizes 36,33,40,1 18,15,22,0 MORE 36,34,35,0 29,30,26,1)
foreach(size ${sizes})
  read_row(${size} bits narrow wide form)
  core_test(folded_multiplier ${form_${form}}_w${bits}_${narrow}_${wide} TOP folded_multiplier
            PARAMS Bits=${bits} NarrowShift=${narrow} WideShift=${wide} Form=${form})
endforeach()
illegal_parameter_test(folded_multiplier Bits=37 "Bits must be in .18, 36.")
illegal_parameter_test(folded_multiplier WideShift=41 "WideShift must be in .1, 40.")

# Stieltjes integrators: word, shift of the sum, fraction bits dropped, first order, form.
rows(sizes 36,34,2,0,0 36,33,2,1,1 MORE 30,29,0,1,0 18,15,0,1,0)
foreach(size ${sizes})
  read_row(${size} bits shift drop first form)
  core_test(stieltjes_integrator ${form_${form}}_w${bits}_${shift}_${drop}_${first}
            TOP stieltjes_integrator
            PARAMS Bits=${bits} Shift=${shift} Drop=${drop} First=${first} Form=${form})
endforeach()

# The sixteen integrators of the spline: order, word, mode, anchor, form.
rows(sizes 6,36,1,1,0 2,29,0,0,0 5,18,1,1,0 12,36,0,1,1
     MORE 6,36,1,1,1 6,36,0,1,0 6,36,1,0,0 6,36,0,0,0 2,36,1,1,0 3,30,1,1,0 12,36,0,0,0)
foreach(size ${sizes})
  read_row(${size} order coef mode anchor form)
  core_test(spline_network p${order}_w${coef}_m${mode}_n${anchor}_${form_${form}}
            TOP spline_network
            PARAMS Order=${order} CoefBits=${coef} Mode=${mode} Anchor=${anchor} Form=${form})
endforeach()
illegal_parameter_test(spline_network Order=13 "Order must be in .2, 12.")
illegal_parameter_test(spline_network Mode=2 "Mode must be 0 or 1")
illegal_parameter_test(spline_network Anchor=2 "Anchor must be 0 or 1")
illegal_parameter_test(spline_network Guest=2 "Guest must be 0 or 1")
illegal_parameter_test(spline_network Guest=1,Anchor=0 "Guest 1 works with Anchor 1 only")

# The start of a spline's step: word, parameter guard, anchor, form.
rows(sizes 36,0,1,1 36,8,1,0 18,3,1,0 27,1,0,0 MORE 36,0,1,0 36,0,0,0 29,0,1,0 18,0,1,0)
foreach(size ${sizes})
  read_row(${size} coef parameter anchor form)
  core_test(spline_anchor w${coef}_u${parameter}_n${anchor}_${form_${form}} TOP spline_anchor
            PARAMS CoefBits=${coef} ParameterGuard=${parameter} Anchor=${anchor} Form=${form})
endforeach()

illegal_parameter_test(spline_anchor CoefBits=37 "CoefBits must be in .18, 36.")
illegal_parameter_test(spline_anchor ParameterGuard=9 "ParameterGuard must be in .0, 8.")
illegal_parameter_test(spline_anchor Anchor=2 "Anchor must be 0 or 1")
illegal_parameter_test(spline_anchor Own=2 "Own must be 0 or 1")
illegal_parameter_test(spline_anchor Form=2 "Form must be 0 or 1")

# Steps of splines: order, word, parameter guard, fine position, guard bits, auxiliary axes, mode,
# anchor, form.
rows(sizes 6,36,0,42,10,0,1,1,1 8,36,8,44,12,6,1,1,0 12,36,0,42,10,1,0,1,0 2,33,0,39,9,0,1,0,0
           3,24,5,30,6,0,0,0,1
     MORE 6,36,0,42,10,2,1,1,0 6,36,0,42,10,0,0,1,0 6,36,0,42,10,0,1,0,0 2,36,0,42,10,0,1,1,0
          4,29,0,34,8,0,1,1,0 5,33,0,38,7,0,1,0,0 6,36,0,42,10,2,0,0,0 2,36,0,42,10,1,0,0,0
          4,28,4,42,10,0,1,1,0)
foreach(size ${sizes})
  read_row(${size} order coef parameter fine guard aux mode anchor form)
  core_test(spline_steps
            p${order}_w${coef}_u${parameter}_f${fine}_a${aux}_m${mode}_n${anchor}_${form_${form}}
            TOP spline_steps LIBRARIES curvecore_host
            PARAMS Order=${order} CoefBits=${coef} ParameterGuard=${parameter} FineBits=${fine}
                   GuardBits=${guard} AuxAxes=${aux} Mode=${mode} Anchor=${anchor} Form=${form})
endforeach()
illegal_parameter_test(spline_steps Order=1 "Order must be in .2, 12.")
illegal_parameter_test(spline_steps CoefBits=37 "CoefBits must be in .18, 36.")
illegal_parameter_test(spline_steps FineBits=45 "FineBits must be in .18, 44.")
illegal_parameter_test(spline_steps GuardBits=1 "GuardBits must be in .2, 12.")
illegal_parameter_test(spline_steps AuxAxes=7 "AuxAxes must be in .0, 6.")
illegal_parameter_test(spline_steps Mode=2 "Mode must be 0 or 1")
illegal_parameter_test(spline_steps Anchor=2 "Anchor must be 0 or 1")
illegal_parameter_test(spline_steps Form=2 "Form must be 0 or 1")

# The cores: of each every class of values stands in configurations.csv in the short form, every
# two that are legal in the short form or the pairs (lint/configurations.py has the classes); the
# flat form is scripts/flat.sh's file.
foreach(bench spherical_interpolator spherical_interpolator_serial curve_interpolator_serial
              spline_interpolator curve_interpolator empty_segments)
  bench_objects(${bench})
endforeach()
bench_objects(motion_interpolator TESTS motion_interpolator motion_hold motion_stop motion_time
              motion_words)
core_tests(spherical_interpolator TOP spherical_interpolator PORTS curve)
core_tests(spherical_interpolator_serial TOP curve_interpolator_serial PORTS curve)
core_tests(curve_interpolator_serial TOP curve_interpolator_serial PORTS curve PARAMS Splines=1)
core_tests(spline_interpolator TOP spline_interpolator PORTS curve)
core_tests(curve_interpolator TOP curve_interpolator PORTS curve)
core_tests(motion_interpolator TOP motion_interpolator PORTS motion
           PARAMS SegmentQueueWords=4096 ProfileQueueWords=512)

# Build 2 with microcode that is not its own, or not as it was made; or that has a table's curve.
foreach(bench microcode table_microcode)
  bench_objects(${bench})
  target_link_libraries(bench_${bench} PUBLIC curvecore_assembler)
  target_compile_definitions(bench_${bench} PRIVATE RTL_DIR="${PROJECT_SOURCE_DIR}/rtl")
  set(configuration b2)
  set(tables)
  set(profile 256)
  if(bench STREQUAL "table_microcode")
    set(configuration b2_t1)
    set(tables -GTable=1)  # not of the parameters, of which its first program is made
    set(profile 512)  # .. and the model's name
  endif()
  core_test(${bench} ${configuration} TOP motion_interpolator PORTS motion
            PARAMS Build=2 Order=6 CoefBits=36 PositionBits=32 GuardBits=10 AuxAxes=0 Splines=1
                   Mode=1 SegmentQueueWords=1024 ProfileQueueWords=${profile}
            SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/unit/motion/microcode.vlt ${tables})
endforeach()

set(small PARAMS Order=2 CoefBits=18 PositionBits=16 GuardBits=2 AuxAxes=0 Mode=0)
core_test(empty_segments parallel TOP spherical_interpolator PORTS curve ${small})
core_test(empty_segments serial TOP curve_interpolator_serial PORTS curve ${small})

# Clocks of arcs in the serial core of both curves.
core_test(spherical_interpolator_serial both_curves TOP curve_interpolator_serial PORTS curve
          PARAMS Splines=1 Order=5 CoefBits=33 PositionBits=32 GuardBits=9 AuxAxes=1 Mode=1)

# Both builds with the multipliers of ECP5 and UP5K inside.
foreach(form 1 2)
  set(size PARAMS Order=6 CoefBits=36 PositionBits=32 GuardBits=10 AuxAxes=0 Mode=0
           MultiplierForm=${form})
  rows(intervals 1 MORE 4)
  foreach(interval ${intervals})
    core_test(spherical_interpolator ${form_${form}}_i${interval} TOP spherical_interpolator
              PORTS curve ${size} SampleInterval=${interval} SOURCES ${primitives_${form}})
  endforeach()
  core_test(curve_interpolator_serial ${form_${form}} TOP curve_interpolator_serial PORTS curve
            PARAMS Splines=1 Order=6 CoefBits=36 PositionBits=32 GuardBits=10 AuxAxes=0 Mode=1
                   MultiplierForm=${form}
            SOURCES ${primitives_${form}})
endforeach()

# Horner's rule, folded and not.
rows(intervals 1 4 MORE 2 8)
foreach(interval ${intervals})
  core_test(horner interval_${interval} TOP horner
            PARAMS Passes=6 Lanes=3 Bits=36 Shift=35 LastShift=35 Interval=${interval})
  core_test(horner cubic_${interval} TOP horner
            PARAMS Passes=3 Lanes=3 Bits=36 Shift=34 LastShift=35 Interval=${interval})
endforeach()
core_test(horner narrow TOP horner
          PARAMS Passes=3 Lanes=1 Bits=18 Shift=17 LastShift=17 Interval=4)
core_test(horner narrow_cubic TOP horner
          PARAMS Passes=3 Lanes=3 Bits=18 Shift=16 LastShift=17 Interval=4)
illegal_parameter_test(horner Interval=3 "Interval must be 1, 2, 4 or 8")
illegal_parameter_test(horner Passes=13 "Passes must be in .1, 12.")
illegal_parameter_test(horner Shift=15 "Shift must be in .16, Bits - 1.")
illegal_parameter_test(horner LastShift=36 "LastShift must be in .16, Bits - 1.")

# Sine and cosine: order, word length.
rows(sizes 6,36 7,29 MORE 2,18 12,33)
foreach(size ${sizes})
  read_row(${size} order bits)
  core_test(sine_cosine_interpolator p${order}_w${bits} TOP sine_cosine_interpolator
            PARAMS Order=${order} CoefBits=${bits})
endforeach()
core_test(sine_cosine_interpolator flat TOP sine_cosine_interpolator PARAMS Order=6 CoefBits=36
          FLAT)

# The hyperbola: order, word length, anchor, form.
rows(sizes 2,18,1,0 12,33,1,1 6,36,0,0
     MORE 6,36,1,0 6,36,1,1 7,29,1,0 2,36,0,1 5,18,0,0 12,29,0,0)
foreach(size ${sizes})
  read_row(${size} order bits anchor form)
  core_test(hyperbola_interpolator p${order}_w${bits}_n${anchor}_${form_${form}}
            TOP hyperbola_interpolator
            PARAMS Order=${order} CoefBits=${bits} Anchor=${anchor} MultiplierForm=${form})
endforeach()
core_test(hyperbola_interpolator flat TOP hyperbola_interpolator
          PARAMS Order=6 CoefBits=36 Anchor=1 MultiplierForm=0 FLAT)
illegal_parameter_test(square_integrator Gain=2 "Gain must be 1 or 3")

foreach(core spherical_interpolator spline_interpolator curve_interpolator
             curve_interpolator_serial motion_interpolator sine_cosine_interpolator
             hyperbola_interpolator)
  illegal_core_parameters(${core})
endforeach()
illegal_parameter_test(curve_interpolator Curves=4 "Curves must be 1, 2 or 3")
foreach(other Anchor=0 ParameterGuard=1)
  illegal_parameter_test(curve_interpolator Networks=0,${other}
                         "Networks 0 works with Anchor 1 and ParameterGuard 0 only")
endforeach()

# The path side: queue depth, interval between ticks.
foreach(depth 2 16 512)
  core_test(word_queue d${depth} TOP word_queue PARAMS Bits=48 Depth=${depth})
endforeach()
core_test(word_streams c36 TOP word_streams PARAMS CoefBits=36 FineBits=42 AuxAxes=0 Splines=0
          SegmentQueueWords=64 ProfileQueueWords=16)
core_test(word_streams c30_aux2_splines TOP word_streams PARAMS CoefBits=30 FineBits=38 AuxAxes=2
          Splines=1 SegmentQueueWords=128 ProfileQueueWords=32)
core_test(time_scaler default TOP time_scaler)
core_test(rate_generator default TOP rate_generator PARAMS Room=128)
rows(intervals 1 4 MORE 2 8)
foreach(interval ${intervals})
  core_test(path_generator interval_${interval} TOP path_generator
            PARAMS Interval=${interval})
endforeach()
illegal_parameter_test(word_queue Depth=48 "Depth must be a power of two in .2, 65536.")
illegal_parameter_test(path_generator Interval=3 "Interval must be 1, 2, 4 or 8")
illegal_parameter_test(piece_ledger QueueWords=8 "QueueWords must be in .16, 4096.")

# The step generator: axes, position, scale, sample period, times of pulses.
rows(sizes 3,42,44,9,12 9,44,56,9,16 2,18,40,6,5 MORE 1,42,44,6,12 3,42,44,13,12)
foreach(size ${sizes})
  read_row(${size} axes fine scale period time)
  set(parameters Axes=${axes} FineBits=${fine} ScaleBits=${scale} PeriodLog2=${period}
                 TimeBits=${time})
  foreach(test step_generator step_pins)
    core_test(${test} a${axes}_f${fine}_s${scale}_k${period}_t${time} TOP step_generator
              PARAMS ${parameters})
  endforeach()
endforeach()
core_test(step_edges k13 TOP step_generator
          PARAMS Axes=3 FineBits=42 ScaleBits=44 PeriodLog2=13 TimeBits=12)
# A program from words to steps: the parallel core beside the step generator.
verilated_model(motion_steps_core TOP motion_interpolator
                PARAMS Build=0 Splines=1 Mode=1 SampleInterval=8)
core_test(motion_steps parallel TOP step_generator LIBRARIES motion_steps_core curvecore_board
          PARAMS Axes=3 FineBits=42 ScaleBits=44 PeriodLog2=8 TimeBits=12)
target_compile_definitions(motion_steps_parallel
                           PRIVATE DATA_DIR="${CMAKE_CURRENT_SOURCE_DIR}/data")
# The system's step blocks.
foreach(size 3,8 9,9 3,13)
  read_row(${size} axes period)
  core_test(step_blocks a${axes}_k${period} TOP step_generator LIBRARIES curvecore_system
            PARAMS Axes=${axes} PeriodLog2=${period} FineBits=44 ScaleBits=56 TimeBits=16)
endforeach()
# Frames of scan heads.
rows(sizes 3,42,9 4,18,7 MORE 9,44,13)
foreach(size ${sizes})
  read_row(${size} axes fine period)
  core_test(xy2_100 a${axes}_f${fine}_k${period} TOP xy2_100
            PARAMS Axes=${axes} FineBits=${fine} PeriodLog2=${period})
endforeach()
illegal_parameter_test(xy2_100 Axes=2 "Axes must be in .3, 9.")
illegal_parameter_test(xy2_100 FineBits=45 "FineBits must be in .18, 44.")
foreach(module motion_system motion_board motion_axi)
  illegal_parameter_test(${module} Build=2,Networks=0 "Build 2 works with Networks 1 only")
endforeach()
illegal_parameter_test(motion_system Galvo=2 "Galvo must be 0 or 1")
illegal_parameter_test(motion_pins Galvo=1,Rates=1 "Galvo works with Build 0 only")
illegal_parameter_test(motion_system Encoders=16 "Encoders must be in .0, 15.")
illegal_parameter_test(xy2_100 PeriodLog2=6 "PeriodLog2 must be in .7, 20.")
illegal_parameter_test(step_generator Axes=10 "Axes must be in .1, 9.")
illegal_parameter_test(step_generator FineBits=45 "FineBits must be in .18, 44.")
illegal_parameter_test(step_generator ScaleBits=39 "ScaleBits must be in .40, 56.")
illegal_parameter_test(step_generator PeriodLog2=21 "PeriodLog2 must be in .6, 20.")
illegal_parameter_test(step_generator TimeBits=3 "TimeBits must be in .4, 16.")
illegal_parameter_test(step_generator PeriodLog2=7 "Axes .FineBits . 7. . 4 clocks must fit")

illegal_parameter_test(motion_interpolator Build=3 "Build must be 0 or 2")
foreach(module motion_interpolator motion_system motion_board motion_axi)
  illegal_parameter_test(${module} Build=1 "Build 1 is a curve core alone")
endforeach()
foreach(module motion_interpolator motion_system motion_board motion_axi)
  illegal_parameter_test(${module} Build=2 "Build 2 needs Program and Data")
endforeach()
illegal_parameter_test(motion_interpolator Splines=2 "Splines must be 0 or 1")
foreach(module motion_interpolator motion_system)
  illegal_parameter_test(${module} Build=0,Table=1 "Build 0 works with Table 0 only")
endforeach()
foreach(module motion_interpolator motion_system)
  illegal_parameter_test(${module} Build=0,Table=1024 "Table must be in .0, 1023.")
endforeach()

# The registers: axes, bits of scale and of times.
rows(sizes 3,44,12 1,33,4 MORE 9,56,16)
foreach(size ${sizes})
  read_row(${size} axes scale time)
  core_test(register_file a${axes}_s${scale}_t${time} TOP register_file
            LIBRARIES nlohmann_json::nlohmann_json
            PARAMS Axes=${axes} ScaleBits=${scale} TimeBits=${time} Capability=1234567 Core=89
            Widths=543
                   ClockHertz=100000000)
  target_compile_definitions(register_file_a${axes}_s${scale}_t${time}
                             PRIVATE REGISTERS_JSON="${REGISTERS_JSON}")
  add_dependencies(register_file_a${axes}_s${scale}_t${time} made_registers)
endforeach()
illegal_parameter_test(register_file Axes=10 "Axes must be in .1, 9.")
illegal_parameter_test(register_file ScaleBits=57 "ScaleBits must be in .33, 56.")
illegal_parameter_test(register_file TimeBits=17 "TimeBits must be in .4, 16.")
illegal_parameter_test(uart_line BitClocks=3 "BitClocks must be in .4, 65535.")
