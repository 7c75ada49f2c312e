;FLAVOR:RepRap (Marlin/Sprinter)
;TIME:96
;Filament used: 0.0201m
;Layer height: 0.2
;Generated with Cura_SteamEngine 4.13.1
T0
M190 S50
M104 S205
M109 S205
G21 ;metric values
G90 ;absolute positioning
M83 ;relative extrusion mode
M107 ;start with the fan off
G28 X0 Y0 ;move X/Y to min endstops
G28 Z0 ;move Z to min endstops
G1 Z15.0 F9000 ;move the platform down 15mm
G92 E0 ;zero the extruded length
G1 F200 E3 ;extrude 3mm of feed stock
G92 E0 ;zero the extruded length again
G1 F9000
M117 Printing...
;LAYER_COUNT:1
;LAYER:0
M204 S500
M205 X8 Y8
G0 F9000 X30 Y30 Z0.2
;TYPE:SKIRT
G1 F1500 X70 Y30 E2
G1 X70 Y60 E1.5
G1 X30 Y60 E2
G1 X30 Y30 E1.5
;TIME_ELAPSED:6.6
G1 F1500 E-6.5
M107
M104 S0 ;extruder heater off
M140 S0 ;heated bed heater off (if you have it)
G91 ;relative positioning
G1 E-1 F300 ;retract the filament a bit before lifting the nozzle
G1 Z+0.5 E-5 X-20 Y-20 F9000 ;move Z up a bit and retract filament even more
G28 X0 Y0 ;move X/Y to min endstops, so the head is out of the way
M84 ;steppers off
G90 ;absolute positioning
;End of Gcode
