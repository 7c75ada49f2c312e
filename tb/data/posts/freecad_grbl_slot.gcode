(Exported by FreeCAD)
(Post Processor: grbl_post)
(Output Time:2024-03-12 07:02:33.731186)
(Begin preamble)
G17 G90
G21
(Begin operation: TC: 3mm)
(Begin toolchange)
( M6 T2 )
M3 S11000
(Finish operation: TC: 3mm)
(Begin operation: Slot)
(Path: Slot)
G0 Z10.000
G0 X0.000 Y0.000
G1 Z-1.000 F150.000
G1 X30.000 Y40.000 F600.000
G3 X30.000 Y60.000 I0.000 J10.000 K0.000 F600.000
G1 X0.000 Y60.000 F600.000
G1 Z-2.000 F150.000
G1 X30.000 Y60.000 F600.000
G2 X30.000 Y40.000 I0.000 J-10.000 K0.000 F600.000
G1 X0.000 Y0.000 F600.000
G0 Z10.000
(Finish operation: Slot)
(Begin postamble)
M5
G17 G90
M2
