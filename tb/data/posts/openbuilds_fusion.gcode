(Made in : Autodesk CAM Post Processor)
(G-Code optimized for OpenBuilds GRBL controllers)
(Program Name : 1001)
(1 Operation :)
(1 : 2D Contour1)
(  Work Coordinate System : G54)
(  Tool #1: flat end mill 6 mm)
G90 G94 G17
G21
(This relies on homing, see https://docs.example)
G53 G0 Z0 (safe height)

G54
M5
(Operation 1 of 1 : 2D Contour1)
M3 S10000
G4 P2.0
G0 X-4 Y0
G0 Z10
G1 Z-2 F300
G1 X0 Y30 F1000
G2 X30 Y60 I30 J0
G1 X60
G1 X60 Y0
G1 X-4
G0 Z10
M5
G53 G0 Z0
G53 G0 X0 Y0
M30
