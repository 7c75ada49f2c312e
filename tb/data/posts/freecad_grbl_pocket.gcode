(Exported by FreeCAD)
(Post Processor: grbl_post)
(Output Time:2024-03-11 20:15:45.108339)
(Begin preamble)
G17 G90
G21
(Begin operation: Fixture)
(Path: Fixture)
G54
(Finish operation: Fixture)
(Begin operation: TC: 4mm)
(Path: TC: 4mm)
(TC: 4mm)
(Begin toolchange)
( M6 T1 )
M3 S9000
(Finish operation: TC: 4mm)
(Begin operation: Helix)
(Path: Helix)
(Helix)
G0 X14.000 Y10.000
G0 Z5.000
G1 Z0.000 F200.000
G2 X6.000 Y10.000 Z-0.500 I-4.000 J0.000 K0.000 F400.000
G2 X14.000 Y10.000 Z-1.000 I4.000 J0.000 K0.000 F400.000
G2 X6.000 Y10.000 Z-1.500 I-4.000 J0.000 K0.000 F400.000
G2 X14.000 Y10.000 Z-2.000 I4.000 J0.000 K0.000 F400.000
G2 X6.000 Y10.000 Z-2.000 I-4.000 J0.000 K0.000 F400.000
G2 X14.000 Y10.000 Z-2.000 I4.000 J0.000 K0.000 F400.000
G0 Z5.000
(Finish operation: Helix)
(Begin postamble)
M5
G17 G90
M2
