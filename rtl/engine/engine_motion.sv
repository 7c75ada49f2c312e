// SPDX-License-Identifier: Apache-2.0
// The motion of Build 2: the engine, its store, and the ports between its programs
// (rtl/engine/programs/motion.asm) and the streams.
//
//   words -> engine_words -> engine <-> engine_store      settings, requests -> engine -> out_o
//
//   clock             0      1            2
//   setting_next_o    1
//   setting_word_o           a register
//   setting_i                             what it says
//
// The programs' side of the ports: rtl/engine/programs/ports.asm. Program and data are files that
// the assembler makes for these parameters. A program says first what it is made for: fault_o[7] is
// up for one for other parameters, which finds no request, and as when it makes no sample for one
// that says nothing. A program one of whose instructions has changed puts out nothing from then on,
// and fault_o[7] comes at once.
// Samples come limb by limb at out_o, by the port's number, and wait outside: in engine_samples as
// positions, in engine_rates as rates of the axes.
//
//   from sample to sample, clocks     hls/clocks.hpp; some 2,000 with a tick for each
`default_nettype none
module engine_motion #(
    parameter int Order             = 6,     // [2, 12]
    parameter int CoefBits          = 36,    // [18, 36]
    parameter int PositionBits      = 32,    // [16, 32]
    parameter int GuardBits         = 10,    // [2, 12]
    parameter int AuxAxes           = 0,     // [0, 6]
    parameter int Splines           = 1,     // 0, 1
    parameter int Mode              = 1,     // 0, 1
    parameter int Table             = 0,     // [0, 1023] of a further curve; 0: none
    parameter int RateBits          = 0,     // 0: samples are positions, or width of a rate
    parameter int Ahead             = 16,    // [1, 16] samples asked for and not taken, at most
    parameter int MultiplierForm    = 0,     // 0 portable, 1 ECP5, 2 UP5K
    parameter int SegmentQueueWords = 1024,  // [64, 65536], a power of two
    parameter int ProfileQueueWords = 1024,  // [16, 4096], a power of two
    parameter     Program           = "",    // files of hexadecimal words
    parameter     Data              = ""
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Settings and scales, as the registers have them (rtl/bus/register_file.sv), in digits of 15
    // bits in clocks that follow each other. DIGEST is that of words beside digest_i.
    input  wire logic [15:0] digest_i,
    output logic             setting_next_o,
    output logic      [ 6:0] setting_word_o,
    input  wire logic [32:0] setting_i,

    // Ports of rtl/motion_interpolator.sv
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,
    input  wire logic        profile_valid_i,
    output logic             profile_ready_o,
    input  wire logic [47:0] profile_data_i,
    output logic             segment_leaves_o,
    output logic             profile_leaves_o,
    output logic      [15:0] segment_room_o,    // rtl/engine/engine_entry.sv
    output logic      [15:0] profile_room_o,

    input  wire logic sample_request_valid_i,
    output logic      sample_request_ready_o,
    input  wire logic hold_i,
    input  wire logic kill_i,

    // Samples: the limb that is put out, by its port; samples that are taken
    output logic      [31:0] out_o,
    output logic      [ 1:0] limb_o,
    output logic      [15:0] data_o,
    input  wire logic        leaves_i,
    input  wire logic        awaited_i, // somebody waits for a sample, with none there

    // What the programs of rates ask for: rtl/engine/engine_rates.sv, and positions of a host
    input  wire logic        position_waits_i,
    input  wire logic [31:0] position_i,        // signed
    input  wire logic [ 8:0] references_i,
    input  wire logic [ 3:0] axis_i,            // whose scale is read
    output logic             scale_last_o,

    output logic        path_valid_o,
    output logic [47:0] path_ds_o,
    output logic [16:0] path_rate_o,
    output logic        path_active_o,
    output logic [60:0] path_o,
    output logic        path_changes_o,   // path_o or path_rate_o, limb by limb
    output logic        active_o,
    output logic        underrun_o,
    output logic        killed_o,
    output logic        standing_o,
    output logic [ 7:0] fault_o,
    output logic [15:0] empty_segments_o
);

  initial if (Ahead < 1 || Ahead > 16) $fatal(1, "Ahead must be in [1, 16]");

  // Instructions and words of data that the programs of these parameters need
  localparam bit Small = Order <= 6 && AuxAxes == 0 && Table == 0;
  localparam bit Large = Order > 9 || Order + AuxAxes > 12 || Table != 0;
  localparam int Instructions = Small ? 1536 : Large ? 4096 : 2048;
  localparam int WordBits = Small ? 8 : 9;

  localparam int StopWords = 2 * words_pkg::StopSteps;
  localparam int Powers = 240;  // rtl/engine/programs/powers.asm
  localparam int Behind = 4;  // words behind the profile's end: rtl/engine/programs/pieces.asm
  localparam int Limbs = Powers + 3 * (SegmentQueueWords + ProfileQueueWords + Behind + StopWords);

  // Ports, as rtl/engine/programs/ports.asm numbers them
  localparam logic [4:0] InMemory = 5'd3;
  localparam logic [4:0] InWord = 5'd4;
  localparam logic [4:0] InCheck = 5'd5;
  localparam logic [4:0] InSettings = 5'd8;  // 8 to 23 are registers of that number
  localparam logic [4:0] InScaleLow = 5'd24;
  localparam logic [4:0] InScaleHigh = 5'd25;
  localparam logic [4:0] InPosition = 5'd26;
  localparam logic [4:0] InReferences = 5'd27;
  localparam int OutMemory = 3;
  localparam int OutAddress = 4;
  localparam int OutTake = 5;
  localparam int OutCheck = 6;
  localparam int OutSelect = 7;
  localparam int OutTakeRequest = 8;
  localparam int OutUnderrun = 9;
  localparam int OutShort = 10;
  localparam int OutSettings = 11;
  localparam int OutWordFaults = 12;
  localparam int OutActive = 13;
  localparam int OutStanding = 14;
  localparam int OutPathActive = 15;
  localparam int OutPath = 26;
  localparam int OutIncrement = 28;
  localparam int OutRate = 29;
  localparam int OutEmpties = 30;
  localparam int OutMadeFor = 31;

  // Engine
  logic [12:0] conditions;
  logic in_next, in_valid, out_next, out_valid;
  logic [4:0] in_port, out_next_port, out_port;
  logic [1:0] in_limb, out_limb;
  logic [15:0] in_data, out_data;
  logic changed;
  logic unused_busy, unused_late;
  motion_engine #(
      .Instructions(Instructions),
      .WordBits    (WordBits),
      .Form        (MultiplierForm),
      .Foreground  (0),
      .Program     (Program),
      .Data        (Data)
  ) u_engine (
      .clk_i,
      .rst_ni,
      .due_i          (1'b0),
      .tick_i         (1'b1),
      .busy_o         (unused_busy),
      .late_o         (unused_late),
      .changed_o      (changed),
      .conditions_i   (conditions),
      .in_next_o      (in_next),
      .in_valid_o     (in_valid),
      .in_port_o      (in_port),
      .in_limb_o      (in_limb),
      .in_data_i      (in_data),
      .out_next_o     (out_next),
      .out_next_port_o(out_next_port),
      .out_valid_o    (out_valid),
      .out_port_o     (out_port),
      .out_limb_o     (out_limb),
      .out_data_o     (out_data)
  );
  logic [31:0] out;  // the port that a limb comes to
  always_comb begin
    out = '0;
    out[out_port] = out_valid;
  end
  logic own, own_q;  // the program is made for these parameters
  logic [14:0] made_for;
  assign made_for = engine_pkg::made_for(
      system_pkg::core(
          Order, Mode, CoefBits, PositionBits, GuardBits, Table
      ),
      AuxAxes,
      Splines,
      SegmentQueueWords,
      ProfileQueueWords,
      RateBits
  );
  assign own = out_data[14:0] == made_for;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) own_q <= 1'b0;
    else if (out[OutMadeFor]) own_q <= own;
  end
  assign out_o = out;
  assign limb_o = out_limb;
  assign data_o = out_data;
  assign scale_last_o = in_valid && in_port == InScaleHigh && in_limb == 2'd2;

  // Words
  logic profile, holds, has_tag, segment_waits, profile_waits;
  logic [47:0] word;
  engine_entry #(
      .Words(engine_pkg::EntryWords)
  ) u_entry (
      .clk_i,
      .rst_ni,
      .segment_valid_i,
      .segment_ready_o,
      .segment_room_o,
      .segment_i      (segment_data_i),
      .profile_valid_i,
      .profile_ready_o,
      .profile_room_o,
      .profile_i      (profile_data_i),
      .of_profile_i   (profile),
      .word_o         (word),
      .take_i         (out[OutTake]),
      .segment_waits_o(segment_waits),
      .profile_waits_o(profile_waits)
  );
  assign segment_leaves_o = out[OutTake] && !profile;
  assign profile_leaves_o = out[OutTake] && profile;
  logic [15:0] word_limb, check;
  engine_words u_words (
      .clk_i,
      .word_i   (word),
      .select_i (out[OutSelect]),
      .check_i  (out[OutCheck]),
      .data_i   (out_data),
      .profile_o(profile),
      .limb_i   (in_limb),
      .limb_o   (word_limb),
      .check_o  (check),
      .holds_o  (holds),
      .tag_o    (has_tag)
  );

  logic [15:0] store_limb;
  engine_store #(
      .Limbs(Limbs),
      .Form (MultiplierForm)
  ) u_store (
      .clk_i,
      .address_i(out[OutAddress]),
      .high_i   (out_limb != 2'd0),
      .write_i  (out[OutMemory]),
      .data_i   (out_data),
      .read_i   (in_valid && in_port == InMemory),
      .limb_o   (store_limb)
  );

  // Requests
  logic held_q;
  logic [4:0] under_way_q, under_way;  // samples, requested and not taken
  assign sample_request_ready_o = out[OutTakeRequest];
  assign under_way = under_way_q + {{4{leaves_i && !out[OutTakeRequest]}},
                                    leaves_i != out[OutTakeRequest]};
  always_ff @(posedge clk_i) begin
    if (out[OutTakeRequest]) held_q <= hold_i;
    if (!rst_ni) under_way_q <= '0;
    else under_way_q <= under_way;
    if (!rst_ni) killed_o <= 1'b0;
    else if (kill_i) killed_o <= 1'b1;
  end
  assign conditions = {
    4'd0,
    awaited_i,
    position_waits_i && own_q,
    has_tag,
    held_q,
    killed_o,
    holds,
    profile_waits,
    segment_waits,
    sample_request_valid_i && own_q && under_way_q != 5'(Ahead) && !out[OutTakeRequest]
  };

  // Registers, read in the clock of a question; while programs ask for anything else but words no
  // register is written either.
  logic of_scale;
  assign of_scale = in_port == InScaleLow || in_port == InScaleHigh;
  assign setting_next_o = in_next && in_port >= InSettings;
  assign setting_word_o = of_scale ? {1'b1, axis_i, 1'b0, in_port == InScaleHigh} : {2'd0, in_port};

  // Answers, two clocks behind their question: what they are made of is chosen a clock ahead, from
  // registers the digits of the bits that they have.
  logic store_q, word_q, check_q, references_q, digest_q;
  logic [2:0] position_q;
  logic [15:0] first_q, second_q, third_q;
  logic of_register;
  assign of_register = in_valid && in_port >= InSettings && in_port != InPosition &&
      in_port != InReferences;
  always_ff @(posedge clk_i) begin
    store_q <= in_port == InMemory;
    word_q <= in_port == InWord;
    check_q <= in_port == InCheck;
    references_q <= in_port == InReferences;
    position_q <= (in_port == InPosition) ? {in_limb[1], in_limb == 2'd1, in_limb == 2'd0} : '0;
    digest_q <= of_register && setting_word_o == registers_pkg::Digest;
    first_q <= {setting_word_o == registers_pkg::Digest, 15'h7fff} &
        {16{of_register && in_limb == 2'd0}};
    second_q <= {1'b0, {15{of_register && in_limb == 2'd1}}};
    third_q <= {13'd0, setting_word_o == registers_pkg::HoldSlope, 2'b11} &
        {16{of_register && in_limb[1]}};
    if (setting_word_o == registers_pkg::Timing) first_q[14:4] <= '0;
    if (setting_word_o == registers_pkg::Override) second_q[14:2] <= '0;
  end
  logic [15:0] setting_limb, position_limb, references;
  assign setting_limb = ((first_q & setting_i[15:0]) | (second_q & {1'b0, setting_i[29:15]}) |
      (third_q & {13'd0, setting_i[32:30]})) ^ ({16{digest_q}} & digest_i);
  assign position_limb = ({16{position_q[0]}} & {1'b0, position_i[14:0]}) |
      ({16{position_q[1]}} & {1'b0, position_i[29:15]}) |
      ({16{position_q[2]}} & {{14{position_i[31]}}, position_i[31:30]});
  for (genvar axis = 0; axis < 9; axis++) assign references[13-axis] = references_i[axis];
  assign references[15:14] = '0;
  assign references[4:0]   = '0;
  always_ff @(posedge clk_i) begin
    in_data <= ({16{store_q}} & store_limb) | ({16{word_q}} & word_limb) |
        ({16{check_q}} & check) | ({16{references_q}} & references) | position_limb | setting_limb;
  end

  // A bound for invalid words and programs: a sample of a program comes, or this count is up.
  logic making_q;
  logic [17:0] patience_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || out[engine_pkg::OutSampleWhole]) making_q <= 1'b0;
    else if (out[OutTakeRequest]) making_q <= 1'b1;
    if (!rst_ni) patience_q <= '0;
    else if (!patience_q[17])
      patience_q <= ((making_q && active_o) || !own_q) ? patience_q + 1'b1 : '0;
  end

  // What the motion says of itself
  always_ff @(posedge clk_i) begin
    if (out[OutIncrement]) begin
      case (out_limb)
        2'd0: path_ds_o[14:0] <= out_data[14:0];
        2'd1: path_ds_o[29:15] <= out_data[14:0];
        2'd2: path_ds_o[44:30] <= out_data[14:0];
        default: path_ds_o[47:45] <= out_data[2:0];
      endcase
    end
    if (out[OutRate]) begin
      if (out_limb == 2'd0) path_rate_o[14:0] <= out_data[14:0];
      else path_rate_o[16:15] <= out_data[1:0];
    end
    path_changes_o <= out_next && (out_next_port == 5'(OutPath) || out_next_port == 5'(OutRate));
    if (out[OutPathActive]) path_active_o <= out_data != '0;
    if (!rst_ni) begin
      path_valid_o     <= 1'b0;
      path_o           <= '0;
      active_o         <= 1'b0;
      underrun_o       <= 1'b0;
      fault_o          <= '0;
      empty_segments_o <= '0;
    end else begin
      path_valid_o <= out[OutRate] && out_limb == 2'd1;
      if (out[OutPath]) begin
        case (out_limb)
          2'd0: path_o[14:0] <= out_data[14:0];
          2'd1: path_o[29:15] <= out_data[14:0];
          2'd2: path_o[44:30] <= out_data[14:0];
          default: path_o[60:45] <= out_data;
        endcase
      end
      if (out[OutActive]) active_o <= out_data[0];
      if (out[OutUnderrun]) underrun_o <= 1'b1;
      if (out[OutShort]) fault_o[5] <= 1'b1;
      if (out[OutSettings]) fault_o[6] <= 1'b1;
      if (patience_q[17] || changed || (out[OutMadeFor] && !own)) fault_o[7] <= 1'b1;
      if (out[OutWordFaults]) fault_o[4:0] <= fault_o[4:0] | out_data[4:0];
      if (out[OutEmpties] && out_limb == 2'd0) empty_segments_o[14:0] <= out_data[14:0];
      if (out[OutEmpties] && out_limb != 2'd0) empty_segments_o[15] <= out_data[0];
    end
  end

  // It stands once the samples that were under way when it came to rest have left.
  logic rests_q;
  logic [4:0] left_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      rests_q    <= 1'b1;
      left_q     <= '0;
      standing_o <= 1'b1;
    end else begin
      standing_o <= rests_q && left_q == '0;
      if (out[OutStanding]) rests_q <= out_data[0];
      if (out[OutStanding] && out_data[0] && !rests_q) left_q <= under_way;
      else if (leaves_i && left_q != '0) left_q <= left_q - 1'b1;
    end
  end

endmodule
`default_nettype wire
