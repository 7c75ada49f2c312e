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
