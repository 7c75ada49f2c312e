# SPDX-License-Identifier: Apache-2.0
"""The devices: their resources (sysc/cost/devices.def), and the calls of their tools."""

import dataclasses
import pathlib

from synthesis.refused import Refused, TooLarge
from synthesis.tables import rows

HERE = pathlib.Path(__file__).resolve().parent
PINS = HERE / "pins"


@dataclasses.dataclass(frozen=True)
class Family:
    """Devices with the same netlist."""

    name: str
    nextpnr: str  # empty: no place and route, its cells alone are counted
    freq: int  # MHz requested, more than can be reached
    yosys: tuple  # commands after reading the sources; {netlist} is the file to write
    lut: dict  # LUTs that a cell occupies
    ff: tuple  # the cells' names begin so
    dsp: dict  # multipliers 18 x 18 (UP5K: 16 x 16) in a cell
    bram: dict  # block memories that a cell occupies whose name begins so
    files: tuple = ()  # files that its Yosys commands read
    routed_timing: bool = True  # nextpnr times every net after routing
    lut_name: str = "LUT4"


# A distributed RAM takes four LUTs for the data and two for its write port.
ECP5 = Family(
    name="ecp5", nextpnr="nextpnr-ecp5", freq=250,
    yosys=("synth_ecp5 -top harness -json {netlist}",),
    lut={"LUT4": 1, "CCU2C": 2, "TRELLIS_DPR16X4": 6}, ff=("TRELLIS_FF",),
    dsp={"MULT18X18D": 1}, bram={"DP16KD": 1, "PDPW16KD": 1})

ICE40 = Family(
    name="ice40", nextpnr="nextpnr-ice40", freq=120,
    yosys=("synth_ice40 -top harness -json {netlist}",),
    lut={"SB_LUT4": 1}, ff=("SB_DFF",), dsp={"SB_MAC16": 1}, bram={"SB_RAM40": 1})

UP5K = dataclasses.replace(ICE40, name="ice40-up5k", freq=60)

# Yosys would put pads on the ports of the core too, which stays a module of its own here.
GOWIN = Family(
    name="gowin", nextpnr="nextpnr-himbaechel-gowin", freq=150,
    yosys=("synth_gowin -family gw2a -noiopads -top harness -json {netlist} -run begin:map_ffs",
           "iopadmap -bits -inpad IBUF O:I -outpad OBUF I:O harness",
           "synth_gowin -family gw2a -top harness -run map_ffs: -json {netlist}"),
    lut={"LUT1": 1, "LUT2": 1, "LUT3": 1, "LUT4": 1, "ALU": 1, "RAM16SDP1": 1, "RAM16SDP2": 2,
         "RAM16SDP4": 4},
    ff=("DFF",), dsp={"MULT9X9": 0.5, "MULT18X18": 1, "MULT36X36": 4},
    bram={"SP": 1, "DP": 1, "SDP": 1, "pROM": 1}, routed_timing=False)

# Yosys ties the carry into the first cell of a chain to 0, which nextpnr-nexus refuses.
NEXUS = Family(
    name="nexus", nextpnr="nextpnr-nexus", freq=150,
    yosys=("synth_nexus -family lifcl -top harness -run begin:map_cells",
           "techmap -map nexus_carry.v",
           "synth_nexus -family lifcl -top harness -run map_cells: -json {netlist}"),
    lut={"LUT4": 1, "WIDEFN9": 2, "INV": 1, "CCU2": 2, "DPR16X4": 6}, ff=("FD1P3",),
    dsp={"MULT9X9": 0.5, "MULT18X18": 1, "MULT18X36": 2, "MULT36X36": 4},
    bram={"DP16K": 1, "PDP16K": 1, "PDPSC16K": 1, "SP16K": 1}, files=(HERE / "nexus_carry.v",))

# The core is a part of a design: no pads, no clock buffer.  A RAMB36E1 counts as two RAMB18E1.
XC7 = Family(
    name="xc7", nextpnr="", freq=0,
    yosys=("synth_xilinx -family xc7 -flatten -noiopad -noclkbuf -top harness -json {netlist}",),
    lut={"INV": 1, "LUT1": 1, "LUT2": 1, "LUT3": 1, "LUT4": 1, "LUT5": 1, "LUT6": 1, "SRL16E": 1,
         "SRLC16E": 1, "SRLC32E": 1, "RAM32M": 4, "RAM64M": 4, "RAM32X1D": 2, "RAM64X1D": 2,
         "RAM128X1D": 4, "RAM32X1S": 1, "RAM64X1S": 1, "RAM128X1S": 2},
    ff=("FDRE", "FDSE", "FDCE", "FDPE"), dsp={"DSP48E1": 1}, bram={"RAMB18E1": 1, "RAMB36E1": 2},
    lut_name="LUT6")


@dataclasses.dataclass(frozen=True)
class Tools:
    """Placing and routing of a device."""

    family: Family
    flags: tuple  # of nextpnr, with {speed} grade and {pins} file
    speeds: tuple = ()  # grades; the first is the default.  Empty: there is one
    pins: pathlib.Path = None
    remark: str = ""


def ecp5(size):
    return Tools(ECP5, (f"--{size}", "--package", "CABGA381", "--speed", "{speed}",
                        "--lpf-allow-unconstrained"), (6, 7, 8))


TOOLS = {
    "ecp5-25": ecp5("25k"),
    "ecp5-45": ecp5("45k"),
    "ecp5-85": ecp5("85k"),
    "up5k": Tools(UP5K, ("--up5k", "--package", "sg48")),
    "hx8k": Tools(ICE40, ("--hx8k", "--package", "ct256")),
    "gw2a-18": Tools(GOWIN, ("--device", "GW2A-LV18PG256C8/I7", "--vopt", "family=GW2A-18",
                             "--vopt", "cst={pins}"), pins=PINS / "gw2a-18.cst",
                     remark="nextpnr does not time multipliers, nor segment wires once routed"),
    # router2 finds no way from the clock pin to its buffer, except in the smallest designs
    "lifcl-40": Tools(NEXUS, ("--device", "LIFCL-40-{speed}BG400C", "--pdc", "{pins}",
                              "--router", "router1"), (7, 8, 9), PINS / "lifcl-40.pdc"),
    **dict.fromkeys(("xc7a35t", "xc7a100t"), Tools(XC7, ())),
}


@dataclasses.dataclass(frozen=True)
class Device(Tools):
    """A row of the table, with its tools."""

    cost_family: str = ""
    form: int = 0  # parameter MultiplierForm of the cores, Form of rtl/multiplier/multiplier.sv
    available: dict = None
    dsp_limit: float = None  # MHz: nextpnr does not time the inside of a DSP block


def device(cells):
    name, cost_family, form, lut4, ff, dsp, bram, mhz = cells
    tools = {field.name: getattr(TOOLS[name], field.name) for field in dataclasses.fields(Tools)}
    available = {"lut4": int(lut4), "ff": int(ff), "dsp": int(dsp), "bram": int(bram)}
    return name, Device(**tools, cost_family=cost_family, form=int(form), available=available,
                        dsp_limit=float(mhz) or None)


DEVICES = dict(map(device, rows("sysc/cost/devices.def", "DEVICE")))


def device_named(name):
    if name not in DEVICES:
        raise Refused(f"unknown device '{name}': one of {', '.join(DEVICES)}")
    return DEVICES[name]


def speed_of(name, text):
    """The speed grade that `text` names; of an empty text, the device's default."""
    speeds = device_named(name).speeds
    if text in (None, ""):
        return speeds[0] if speeds else None
    if not speeds:
        raise Refused(f"{name} has one speed grade here: leave the speed out")
    if str(text) not in map(str, speeds):
        raise Refused(f"speed '{text}' of {name} must be one of {', '.join(map(str, speeds))}")
    return int(text)


def counts(family, cells):
    """LUTs, flip-flops, DSP and RAM blocks of a number of each type of cell."""
    return {
        "lut4": sum(family.lut.get(cell, 0) * n for cell, n in cells.items()),
        "ff": sum(n for cell, n in cells.items() if cell.startswith(family.ff)),
        "dsp": round(sum(family.dsp.get(cell, 0) * n for cell, n in cells.items()) + 0.25),
        "bram": sum(blocks * n for name, blocks in family.bram.items()
                    for cell, n in cells.items() if cell.startswith(name)),
    }


def check_fit(name, cells):
    """`cells`: all of the design, the harness' too.  nextpnr needs these at least."""
    device = device_named(name)
    needed = counts(device.family, cells)
    words = {"lut4": device.family.lut_name, "ff": "flip-flops", "dsp": "DSP blocks",
             "bram": "RAM blocks"}
    over = [f"{needed[kind]} {words[kind]} of {device.available[kind]}"
            for kind in words if needed[kind] > device.available[kind]]
    if over:
        raise TooLarge(f"does not fit {name}: {', '.join(over)}")
