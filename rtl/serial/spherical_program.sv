// SPDX-License-Identifier: Apache-2.0
// Program of the serial build, made by rtl/serial/program_generator.cpp: do not edit.
// Its parts begin where rtl/spherical_program_pkg.sv says.
`default_nettype none
module spherical_program (
    input  wire logic        clk_i,
    input  wire logic [ 6:0] place_i,
    output logic      [50:0] word_o    // of the clock before
);

  logic [50:0] program_rom[128];
  always_ff @(posedge clk_i) word_o <= program_rom[place_i];

  initial begin
    program_rom[0]   = 51'h04b0028050da0;
    program_rom[1]   = 51'h00000280500a0;
    program_rom[2]   = 51'h00000280500a0;
    program_rom[3]   = 51'h00000280500a0;
    program_rom[4]   = 51'h00000280500a0;
    program_rom[5]   = 51'h00000280500a0;
    program_rom[6]   = 51'h00000280500a0;
    program_rom[7]   = 51'h00000280500a0;
    program_rom[8]   = 51'h70000280500a0;
    program_rom[9]   = 51'h05b2028048d80;
    program_rom[10]  = 51'h00000280500a0;
    program_rom[11]  = 51'h050e028040881;
    program_rom[12]  = 51'h00000280500a0;
    program_rom[13]  = 51'h00000280500a0;
    program_rom[14]  = 51'h00000280500a0;
    program_rom[15]  = 51'h00000280500a0;
    program_rom[16]  = 51'h00000280500a0;
    program_rom[17]  = 51'h10000280500a0;
    program_rom[18]  = 51'h00000280500a0;
    program_rom[19]  = 51'h00000280500a0;
    program_rom[20]  = 51'h06ac0282c0470;
    program_rom[21]  = 51'h06ae0282c8460;
    program_rom[22]  = 51'h00000280500a0;
    program_rom[23]  = 51'h00000280500a0;
    program_rom[24]  = 51'h00000280500a0;
    program_rom[25]  = 51'h00000280500a0;
    program_rom[26]  = 51'h00000280500a0;
    program_rom[27]  = 51'h00000280500a0;
    program_rom[28]  = 51'h20000280500a0;
    program_rom[29]  = 51'h00000280500a0;
    program_rom[30]  = 51'h00000280500a0;
    program_rom[31]  = 51'h040e0280500a0;
    program_rom[32]  = 51'h00000280500a0;
    program_rom[33]  = 51'h00000280500a0;
    program_rom[34]  = 51'h00000280500a0;
    program_rom[35]  = 51'h00000280500a0;
    program_rom[36]  = 51'h00000280500a0;
    program_rom[37]  = 51'h40000280500a0;
    program_rom[38]  = 51'h00000280500a0;
    program_rom[39]  = 51'h00000280500a0;
    program_rom[40]  = 51'h04160280500a0;
    program_rom[41]  = 51'h04162280500a0;
    program_rom[42]  = 51'h04164280500a0;
    program_rom[43]  = 51'h04166280500a0;
    program_rom[44]  = 51'h04168280500a0;
    program_rom[45]  = 51'h0416a280500a0;
    program_rom[46]  = 51'h10000280500a0;
    program_rom[47]  = 51'h00000280500a0;
    program_rom[48]  = 51'h00000280500a0;
    program_rom[49]  = 51'h06a00282c0410;
    program_rom[50]  = 51'h06a20282c8400;
    program_rom[51]  = 51'h06a40282c0430;
    program_rom[52]  = 51'h06a60282c8420;
    program_rom[53]  = 51'h06a80282c0450;
    program_rom[54]  = 51'h06aa0282c8440;
    program_rom[55]  = 51'h00000280500a0;
    program_rom[56]  = 51'h00000280500a0;
    program_rom[57]  = 51'h00000280500a0;
    program_rom[58]  = 51'h051602c040d00;
    program_rom[59]  = 51'h051622c440d10;
    program_rom[60]  = 51'h051642c840d20;
    program_rom[61]  = 51'h251662cc40d30;
    program_rom[62]  = 51'h051682d040d40;
    program_rom[63]  = 51'h0516a2d440d50;
    program_rom[64]  = 51'h05002004408c0;
    program_rom[65]  = 51'h05042084408c1;
    program_rom[66]  = 51'h45082104408c2;
    program_rom[67]  = 51'h00000280500a0;
    program_rom[68]  = 51'h00000280500a0;
    program_rom[69]  = 51'h04000000508b0;
    program_rom[70]  = 51'h04020040508b1;
    program_rom[71]  = 51'h04040080508b2;
    program_rom[72]  = 51'h040600c0508b3;
    program_rom[73]  = 51'h04080100508b4;
    program_rom[74]  = 51'h040a0140508b5;
    program_rom[75]  = 51'h1d0002c0408c0;
    program_rom[76]  = 51'h0d0022c8408c1;
    program_rom[77]  = 51'h0d0042d0408c2;
    program_rom[78]  = 51'h0d006280408c3;
    program_rom[79]  = 51'h0d008280408c4;
    program_rom[80]  = 51'h0d00a280408c5;
    program_rom[81]  = 51'h0d00c280408c6;
    program_rom[82]  = 51'h0d00e280408c7;
    program_rom[83]  = 51'h0d010280408c8;
    program_rom[84]  = 51'h40000280500a0;
    program_rom[85]  = 51'h00000280500a0;
    program_rom[86]  = 51'h00000280500a0;
    program_rom[87]  = 51'h343a1400e9e00;
    program_rom[88]  = 51'h043a3480e9e20;
    program_rom[89]  = 51'h043a5500e9e40;
    program_rom[90]  = 51'h243a1400e99d0;
    program_rom[91]  = 51'h043a3480e99d1;
    program_rom[92]  = 51'h043a5500e99d2;
    program_rom[93]  = 51'h58000280e99d0;
    program_rom[94]  = 51'h08002280e99d1;
    program_rom[95]  = 51'h08004280e99d2;
    program_rom[96]  = 51'h68006280e98c3;
    program_rom[97]  = 51'h08008280e98c4;
    program_rom[98]  = 51'h0800a280e98c5;
    program_rom[99]  = 51'h4800c280e98c6;
    program_rom[100] = 51'h0800e280e98c7;
    program_rom[101] = 51'h08010280e98c8;
    program_rom[102] = 51'h143a8280e99d3;
    program_rom[103] = 51'h00000280500a0;
    program_rom[104] = 51'h00000280500a0;
    program_rom[105] = 51'h343ab580ea760;
    program_rom[106] = 51'h043ad1c0ea670;
    program_rom[107] = 51'h00000280500a0;
    program_rom[108] = 51'h243ab580ea1d5;
    program_rom[109] = 51'h043ad1c0ea1d6;
    program_rom[110] = 51'h00000280500a0;
    program_rom[111] = 51'h153a0300ea810;
    program_rom[112] = 51'h053a2304ea830;
    program_rom[113] = 51'h053a4308ea850;
    program_rom[114] = 51'h153b0280eb000;
    program_rom[115] = 51'h053b2280eb020;
    program_rom[116] = 51'h053b4280eb040;
    program_rom[117] = 51'h58000760e99d0;
    program_rom[118] = 51'h08002764e99d1;
    program_rom[119] = 51'h08004768e99d2;
    program_rom[120] = 51'h68006280e98c3;
    program_rom[121] = 51'h08008280e98c4;
    program_rom[122] = 51'h0800a280e98c5;
    program_rom[123] = 51'h4800c280e98c6;
    program_rom[124] = 51'h0800e280e98c7;
    program_rom[125] = 51'h08010280e98c8;
    program_rom[126] = 51'h00000280500a0;
    program_rom[127] = 51'h00000280500a0;
  end

endmodule
`default_nettype wire
