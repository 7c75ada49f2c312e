; OpenBuilds CAM 2.0: generated 2024-03-14
G21 ; mm-mode
G54; Work Coordinates
G90 ; Absolute mode
M3 S1000 ; Spindle On
G4 P1 ; wait

; Operation 0: CNC: Vector (path outside)
; Tool Diameter: 6.35
G0 Z5 ; move to clearance height
G0 X-3.175 Y0
G1 Z-3 F500
G1 F1000 X-3.175 Y50 Z-3
G1 F1000 X0 Y53.175 Z-3
G1 F1000 X50 Y53.175 Z-3
G1 F1000 X53.175 Y50 Z-3
G1 F1000 X53.175 Y0 Z-3
G1 F1000 X50 Y-3.175 Z-3
G1 F1000 X0 Y-3.175 Z-3
G1 F1000 X-3.175 Y0 Z-3
G0 Z5
; END Operation
M5 ; Spindle Off
G0 X0 Y0
M2 ; end
