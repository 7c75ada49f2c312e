// SPDX-License-Identifier: Apache-2.0
// Register accesses from frames: commands of LBP16 (Mesa's, of its space 0), low byte first.
//
//   command   2 bytes: 15 write, 14 an address follows, 13:10 zero, 9:8 width, 7 increment,
//             6:0 number
//   address   2 bytes, of a word, in bytes; by default the words that follow the last
//   data      of a write
//
// Width 2: words of 32 bits. Width 3: pairs of words, the low one first, at an address that is a
// multiple of 8. With the increment each goes to the next address, otherwise all to the same one.
//
// Writes are obeyed behind a write of EXPECT with the number that SEQUENCE has. A frame that begins
// so, and then gives SEQUENCE a number of its own, is obeyed once and in order, however often it
// comes; its reads are always answered.
//
// An invalid or cut command ends its frame, with an access that the registers refuse, and is
// answered: with STATE, behind the words read before.
`default_nettype none
module frame_reader (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Frames: rtl/line/frame_buffer.sv
    input  wire logic       read_valid_i,
    input  wire logic [7:0] read_i,
    output logic            next_o,

    // Answers: rtl/line/slip_sender.sv
    output logic            data_valid_o,
    output logic      [7:0] data_o,
    output logic            close_o,
    input  wire logic       ready_i,

    // Requests: rtl/bus/register_file.sv
    output logic             valid_o,
    output logic             write_o,
    output logic      [ 6:0] word_o,
    output logic      [31:0] data32_o,
    input  wire logic        done_i,
    input  wire logic [31:0] data32_i
);

  typedef enum logic [3:0] {
    Length,
    CommandLow,
    CommandHigh,
    AddressLow,
    AddressHigh,
    Data,
    Access,
    Answer,
    Refuse,
    Finish,
    Crc
  } state_t;
  state_t state_q;

  logic [7:0] words_q;  // to come
  logic writes_q;  // the command writes
  // Bytes
  localparam logic [7:0] CrcBytes = 8'd4;
  logic [7:0] left_q;  // bytes of the frame
  logic last;
  logic [7:0] low_q;  // the last byte
  logic takes;
  assign last = left_q == CrcBytes;
  always_comb begin
    case (state_q)
      Length: takes = 1'b1;
      Crc: takes = left_q != '0;
      Data: takes = writes_q && words_q != '0 && !last;
      CommandLow, CommandHigh, AddressLow, AddressHigh, Refuse: takes = !last;
      default: takes = 1'b0;
    endcase
  end
  assign next_o = takes && read_valid_i;
  always_ff @(posedge clk_i) begin
    if (next_o) low_q <= read_i;
    if (next_o) left_q <= (state_q == Length) ? read_i : left_q - 1'b1;
  end

  // The command
  logic pair_q;
  logic increment_q;
  logic [1:0] part_q;  // byte of a word
  logic known;  // a valid command, at its high byte
  logic aligned;  // a valid address
  assign known   = read_i[5:1] == 5'b00001;
  assign aligned = read_i[7:1] == '0 && low_q[1:0] == '0 && !(pair_q && low_q[2]);

  // The access, and the frames that are obeyed
  logic [31:0] word_q;  // word to write, or word read
  logic [6:0] place_q;
  logic obeyed_q;
  logic expects;  // SEQUENCE is read for it
  logic asks;
  logic accessed;
  logic answers;
  logic done;  // a word is done
  assign expects  = writes_q && place_q == registers_pkg::Expect;
  assign asks     = !writes_q || expects || obeyed_q;
  assign accessed = state_q == Access && (!asks || done_i);
  assign answers  = state_q == Answer && ready_i;
  assign done     = writes_q ? accessed : answers && part_q == '1;
  assign data32_o = word_q;
  always_ff @(posedge clk_i) begin
    valid_o <= rst_ni && state_q == Access && asks && !done_i;
    write_o <= writes_q && !expects;
    word_o  <= {place_q[6:1], place_q[0] || expects};
  end

  // Answers
  logic refused_q;  // the refusal is to be reported
  logic tells;
  assign tells = state_q == CommandLow && last && refused_q;
  logic answered_q;
  assign data_valid_o = state_q == Answer;
  assign data_o       = word_q[7:0];
  assign close_o      = state_q == Finish && answered_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= Length;
    end else begin
      case (state_q)
        Length:  if (next_o) state_q <= CommandLow;
        CommandLow: begin
          if (last) state_q <= refused_q ? Data : Finish;
          else if (next_o) state_q <= CommandHigh;
        end
        CommandHigh: begin
          if (last || (next_o && !known)) state_q <= Refuse;
          else if (next_o) state_q <= read_i[6] ? AddressLow : Data;
        end
        AddressLow: begin
          if (last) state_q <= Refuse;
          else if (next_o) state_q <= AddressHigh;
        end
        AddressHigh: begin
          if (last || (next_o && !aligned)) state_q <= Refuse;
          else if (next_o) state_q <= Data;
        end
        Data: begin
          if (words_q == '0) state_q <= CommandLow;
          else if (!writes_q || (next_o && part_q == '1)) state_q <= Access;
          else if (last) state_q <= Refuse;
        end
        Access:  if (accessed) state_q <= writes_q ? Data : Answer;
        Answer:  if (done) state_q <= Data;
        Refuse:  if (last) state_q <= Access;
        Finish:  if (!answered_q || ready_i) state_q <= Crc;
        default: if (left_q == '0) state_q <= Length;
      endcase
    end
  end

  always_ff @(posedge clk_i) begin
    if (state_q == Length) {obeyed_q, answered_q} <= '0;
    if (state_q == Length || state_q == CommandLow) part_q <= '0;
    else if (answers || (state_q == Data && next_o)) part_q <= part_q + 1'b1;

    if (state_q == CommandHigh && next_o) begin
      writes_q    <= read_i[7];
      pair_q      <= read_i[0];
      increment_q <= low_q[7];
      words_q     <= read_i[0] ? {low_q[6:0], 1'b0} : {1'b0, low_q[6:0]};
    end
    if (state_q == AddressHigh && next_o) place_q <= {read_i[0], low_q[7:2]};
    if (state_q == Refuse) begin  // an address that cannot be written
      writes_q <= 1'b1;
      place_q  <= registers_pkg::Id;
      words_q  <= 8'd1;
      obeyed_q <= 1'b1;
    end
    if (state_q == Length) refused_q <= 1'b0;
    else if (state_q == Refuse) refused_q <= 1'b1;
    else if (tells) refused_q <= 1'b0;
    if (tells) begin
      writes_q <= 1'b0;
      place_q  <= registers_pkg::State;
      words_q  <= 8'd1;
    end
    if (done) begin
      words_q <= words_q - 1'b1;
      place_q <= increment_q ? place_q + 1'b1 : place_q ^ {6'd0, pair_q};
    end

    if (accessed && !writes_q) word_q <= data32_i;
    else if (answers || (state_q == Data && next_o)) word_q <= {read_i, word_q[31:8]};
    if (accessed && expects) obeyed_q <= word_q == data32_i;
    if (answers) answered_q <= 1'b1;
  end

endmodule
`default_nettype wire
