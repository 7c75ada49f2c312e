# SPDX-License-Identifier: Apache-2.0
# The one table of configurations:
#   core_test(<test file without _test.cpp> <configuration> TOP <module> PARAMS Name=Value ...)
# makes tests unit.<configuration>.<Suite>.<Test>; Name=Value reaches the RTL as a parameter and the
# test as CFG_Name.

# Multipliers: Form is 0 portable, 1 ECP5, 2 UP5K.
set(form_0 portable)
set(form_1 ecp5)
set(form_2 up5k)
set(primitives_2 -Wno-lint -Wno-TIMESCALEMOD -DNO_ICE40_DEFAULT_ASSIGNMENTS -v ${ICE40_CELLS})
foreach(form 0 1 2)
  foreach(size 36,36,0 36,36,35 36,18,0 18,36,17 18,18,0 32,32,31 33,27,20)
    string(REPLACE "," ";" words ${size})
    list(GET words 0 a)
    list(GET words 1 b)
    list(GET words 2 shift)
    core_test(multiplier ${form_${form}}_${a}x${b}_${shift} TOP multiplier
              PARAMS ABits=${a} BBits=${b} Shift=${shift} Form=${form}
              SOURCES ${primitives_${form}})
  endforeach()
endforeach()
illegal_parameter_test(multiplier ABits=17 "ABits must be in .18, 36.")
illegal_parameter_test(multiplier BBits=37 "BBits must be in .18, 36.")
illegal_parameter_test(multiplier Shift=36 "Shift must be in .0, 35.")
illegal_parameter_test(multiplier Form=3 "Form must be 0, 1 or 2")

# The arc core: order, widths, auxiliary axes, sampler mode, clocks per sample.
function(arc_configuration order coef position guard aux mode interval)
  set(name p${order}_w${coef}_b${position}_g${guard}_a${aux}_m${mode}_i${interval})
  core_test(sample_campaign ${name} TOP spherical_interpolator
            PARAMS Order=${order} CoefBits=${coef} PositionBits=${position} GuardBits=${guard}
                   AuxAxes=${aux} Mode=${mode} SampleInterval=${interval})
endfunction()
arc_configuration(6 36 32 10 0 0 1)
arc_configuration(6 36 32 10 0 0 2)
arc_configuration(6 36 32 10 0 0 4)
arc_configuration(6 36 32 10 0 0 8)
arc_configuration(6 36 32 10 0 1 1)
arc_configuration(6 36 32 10 0 1 2)
arc_configuration(6 36 32 10 0 1 4)
arc_configuration(6 36 32 10 0 1 8)
arc_configuration(6 36 32 12 6 0 1)
arc_configuration(2 36 32 10 0 0 1)
arc_configuration(2 36 32 10 0 1 4)
arc_configuration(3 36 32 10 0 1 1)
arc_configuration(3 24 24 6 2 0 8)
arc_configuration(4 36 32 10 3 0 1)
arc_configuration(4 18 20 4 1 1 2)
arc_configuration(5 30 32 8 1 1 4)
arc_configuration(6 18 16 2 0 0 1)
arc_configuration(7 27 28 7 6 1 1)
arc_configuration(8 36 32 10 0 0 1)
arc_configuration(8 36 32 12 6 0 4)
arc_configuration(9 35 31 11 0 1 1)
arc_configuration(10 33 32 9 1 0 4)
arc_configuration(11 29 26 5 0 1 2)
arc_configuration(12 36 32 12 0 0 2)
arc_configuration(12 36 32 12 0 1 8)
