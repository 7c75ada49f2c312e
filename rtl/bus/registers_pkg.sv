// SPDX-License-Identifier: Apache-2.0
// Made by hls/registers/make_registers.py from registers.rdl, which explains the registers.
`default_nettype none
package registers_pkg;

  // Addresses in words of 32 bits
  localparam logic [6:0] Id = 7'd0;
  localparam logic [6:0] Version = 7'd1;
  localparam logic [6:0] Capability = 7'd2;
  localparam logic [6:0] Core = 7'd3;
  localparam logic [6:0] Clock = 7'd4;
  localparam logic [6:0] Control = 7'd5;
  localparam logic [6:0] State = 7'd6;
  localparam logic [6:0] Axes = 7'd7;
  localparam logic [6:0] Reference = 7'd8;
  localparam logic [6:0] Override = 7'd9;
  localparam logic [6:0] Watchdog = 7'd10;
  localparam logic [6:0] Timing = 7'd11;
  localparam logic [6:0] HoldAcceleration = 7'd12;
  localparam logic [6:0] HoldSlope = 7'd13;
  localparam logic [6:0] StopTicks = 7'd14;
  localparam logic [6:0] Pulse = 7'd15;
  localparam logic [6:0] Direction = 7'd16;
  localparam logic [6:0] Pins = 7'd17;
  localparam logic [6:0] Widths = 7'd18;
  localparam logic [6:0] Digest = 7'd19;
  localparam logic [6:0] SegmentLo = 7'd20;
  localparam logic [6:0] SegmentHi = 7'd21;
  localparam logic [6:0] ProfileLo = 7'd22;
  localparam logic [6:0] ProfileHi = 7'd23;
  localparam logic [6:0] PathLo = 7'd24;
  localparam logic [6:0] PathHi = 7'd25;
  localparam logic [6:0] Rate = 7'd26;
  localparam logic [6:0] Room = 7'd27;
  localparam logic [6:0] Expect = 7'd28;
  localparam logic [6:0] Sequence = 7'd29;
  localparam logic [6:0] Sample = 7'd30;
  localparam logic [6:0] Samples = 7'd31;
  localparam logic [6:0] Probe = 7'd32;
  localparam logic [6:0] Switches = 7'd33;
  localparam logic [6:0] CaughtPath = 7'd34;
  localparam logic [6:0] Homed = 7'd35;
  localparam logic [6:0] Origin0 = 7'd36;
  localparam logic [6:0] Encoder0 = 7'd45;
  localparam logic [6:0] FollowingWorst0 = 7'd54;
  localparam logic [6:0] Outputs = 7'd63;
  localparam logic [6:0] Following0 = 7'd100;
  localparam logic [6:0] EncoderRatio0 = 7'd109;
  localparam logic [6:0] FollowingLimit0 = 7'd118;
  localparam logic [6:0] Shaper = 7'd127;

  // Axes: the first one's words, and the number of words of each
  localparam logic [6:0] AxisFirst = 7'd64;
  localparam int AxisWords = 4;
  localparam logic [1:0] AxisScaleLo = 2'd0;
  localparam logic [1:0] AxisScaleHi = 2'd1;
  localparam logic [1:0] AxisSteps = 2'd2;
  localparam logic [1:0] AxisCaught = 2'd3;

  // Lowest bits
  localparam int IdIdLow = 0;
  localparam int VersionMapLow = 0;
  localparam int VersionWordsLow = 8;
  localparam int CapabilityAxesLow = 0;
  localparam int CapabilityPeriodLog2Low = 4;
  localparam int CapabilityBuildLow = 9;
  localparam int CapabilitySplinesLow = 10;
  localparam int CapabilitySegmentQueueLog2Low = 11;
  localparam int CapabilityProfileQueueLog2Low = 16;
  localparam int CapabilitySampleBufferLog2Low = 21;
  localparam int CapabilityEncodersLow = 25;
  localparam int CapabilityEngineLow = 26;
  localparam int CapabilityOutputsLog2Low = 27;
  localparam int CoreOrderLow = 0;
  localparam int CoreModeLow = 4;
  localparam int CoreCoefBitsLow = 6;
  localparam int CorePositionBitsLow = 12;
  localparam int CoreGuardBitsLow = 18;
  localparam int CoreTableLow = 22;
  localparam int ClockHertzLow = 0;
  localparam int ControlEnableLow = 0;
  localparam int ControlHoldLow = 1;
  localparam int ControlFlushLow = 2;
  localparam int ControlEstopLow = 3;
  localparam int ControlPositionLow = 4;
  localparam int ControlKeepLow = 5;
  localparam int StateBusLow = 0;
  localparam int StateWatchdogLow = 1;
  localparam int StateEstopLow = 2;
  localparam int StateEstopInputLow = 3;
  localparam int StateLimitLow = 4;
  localparam int StateOverrunLow = 5;
  localparam int StateRefusedLow = 6;
  localparam int StateLateLow = 7;
  localparam int StateMotionLow = 8;
  localparam int StateEnabledLow = 16;
  localparam int StateHoldingLow = 17;
  localparam int StateActiveLow = 18;
  localparam int StateStandingLow = 19;
  localparam int StateUnderrunLow = 20;
  localparam int StateFlushingLow = 21;
  localparam int StateCleanLow = 22;
  localparam int StateReadyLow = 23;
  localparam int StateEstopPinLow = 24;
  localparam int StateEncoderLow = 25;
  localparam int StateFollowingLow = 26;
  localparam int StateFaultAxisLow = 27;
  localparam int StateCaughtLow = 31;
  localparam int AxesReferencedLow = 0;
  localparam int AxesUncertainLow = 9;
  localparam int AxesLimitLow = 18;
  localparam int ReferenceAxesLow = 0;
  localparam int OverrideRateLow = 0;
  localparam int WatchdogSamplesLow = 0;
  localparam int TimingSamplesPerTickLog2Low = 0;
  localparam int HoldAccelerationAccelerationLow = 0;
  localparam int HoldSlopeSlopeLow = 0;
  localparam int StopTicksTicksLow = 0;
  localparam int PulseSteplenLow = 0;
  localparam int PulseStepspaceLow = 16;
  localparam int DirectionDirsetupLow = 0;
  localparam int DirectionDirholdLow = 16;
  localparam int PinsStepInvertedLow = 0;
  localparam int PinsDirectionInvertedLow = 9;
  localparam int PinsLimitMaskedLow = 18;
  localparam int WidthsTimeBitsLow = 0;
  localparam int WidthsScaleBitsLow = 5;
  localparam int WidthsSamplesAheadLow = 11;
  localparam int WidthsShaperLog2Low = 15;
  localparam int DigestDigestLow = 0;
  localparam int SegmentLoWordLow = 0;
  localparam int SegmentHiWordLow = 0;
  localparam int ProfileLoWordLow = 0;
  localparam int ProfileHiWordLow = 0;
  localparam int PathLoPathLow = 0;
  localparam int PathHiPathLow = 0;
  localparam int RateRateLow = 0;
  localparam int RoomSegmentLow = 0;
  localparam int RoomProfileLow = 16;
  localparam int ExpectFrameLow = 0;
  localparam int SequenceFrameLow = 0;
  localparam int SamplePositionLow = 0;
  localparam int SamplesRoomLow = 0;
  localparam int SamplesQueuedLow = 16;
  localparam int ProbeSwitchLow = 0;
  localparam int ProbeHighLow = 4;
  localparam int ProbeArmedLow = 5;
  localparam int SwitchesHomeLow = 0;
  localparam int SwitchesProbeLow = 9;
  localparam int SwitchesHomedLow = 10;
  localparam int CaughtPathPathLow = 0;
  localparam int HomedAxesLow = 0;
  localparam int Origin0StepsLow = 0;
  localparam int Encoder0CountLow = 0;
  localparam int FollowingWorst0ErrorLow = 0;
  localparam int OutputsPowerLow = 8;
  localparam int OutputsBitsLow = 24;
  localparam int ScaleLoScaleLow = 0;
  localparam int ScaleHiScaleLow = 0;
  localparam int StepsCountLow = 0;
  localparam int CaughtCountLow = 0;
  localparam int Following0ErrorLow = 0;
  localparam int EncoderRatio0CountsLow = 0;
  localparam int EncoderRatio0StepsLow = 16;
  localparam int FollowingLimit0LimitLow = 0;
  localparam int ShaperValueLow = 0;
  localparam int ShaperAxisLow = 18;
  localparam int ShaperKindLow = 22;

  // Words that can be read, without axes
  function automatic logic can_read(input logic [6:0] word);
    case (word)
      Id,
      Version,
      Capability,
      Core,
      Clock,
      State,
      Axes,
      Override,
      Watchdog,
      Timing,
      HoldAcceleration,
      HoldSlope,
      StopTicks,
      Pulse,
      Direction,
      Pins,
      Widths,
      Digest,
      PathLo,
      PathHi,
      Rate,
      Room,
      Sequence,
      Samples,
      Probe,
      Switches,
      CaughtPath,
      Origin0,
      7'd37,
      7'd38,
      7'd39,
      7'd40,
      7'd41,
      7'd42,
      7'd43,
      7'd44,
      Encoder0,
      7'd46,
      7'd47,
      7'd48,
      7'd49,
      7'd50,
      7'd51,
      7'd52,
      7'd53,
      FollowingWorst0,
      7'd55,
      7'd56,
      7'd57,
      7'd58,
      7'd59,
      7'd60,
      7'd61,
      7'd62,
      Outputs,
      Following0,
      7'd101,
      7'd102,
      7'd103,
      7'd104,
      7'd105,
      7'd106,
      7'd107,
      7'd108,
      EncoderRatio0,
      7'd110,
      7'd111,
      7'd112,
      7'd113,
      7'd114,
      7'd115,
      7'd116,
      7'd117,
      FollowingLimit0,
      7'd119,
      7'd120,
      7'd121,
      7'd122,
      7'd123,
      7'd124,
      7'd125,
      7'd126:
      can_read = 1'b1;
      default: can_read = 1'b0;
    endcase
  endfunction

  // Words that can be written, without axes
  function automatic logic can_write(input logic [6:0] word);
    case (word)
      Control,
      State,
      Reference,
      Override,
      Watchdog,
      Timing,
      HoldAcceleration,
      HoldSlope,
      StopTicks,
      Pulse,
      Direction,
      Pins,
      Digest,
      SegmentLo,
      SegmentHi,
      ProfileLo,
      ProfileHi,
      Expect,
      Sequence,
      Sample,
      Probe,
      Homed,
      Origin0,
      7'd37,
      7'd38,
      7'd39,
      7'd40,
      7'd41,
      7'd42,
      7'd43,
      7'd44,
      EncoderRatio0,
      7'd110,
      7'd111,
      7'd112,
      7'd113,
      7'd114,
      7'd115,
      7'd116,
      7'd117,
      FollowingLimit0,
      7'd119,
      7'd120,
      7'd121,
      7'd122,
      7'd123,
      7'd124,
      7'd125,
      7'd126,
      Shaper:
      can_write = 1'b1;
      default: can_write = 1'b0;
    endcase
  endfunction

  // Value of a word after a reset
  function automatic logic [31:0] reset_value(input logic [6:0] word);
    case (word)
      Id: reset_value = 32'h43564d31;
      Version: reset_value = 32'h00000002;
      Override: reset_value = 32'h00010000;
      default: reset_value = 32'd0;
    endcase
  endfunction

endpackage
`default_nettype wire
