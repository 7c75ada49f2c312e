// SPDX-License-Identifier: Apache-2.0
// The interpreter's cycles: steps of canned_cycles and thread_cycles become moves.
#include "ref/gcode/cycles/thread_cycles.hpp"
#include "ref/gcode/interpreter/interpreter.hpp"

namespace curvecore::ref {

void Interpreter::cycle(bool again, Block& block, const Place& place) {
    const Modes before = modes_;
    const CarryOut step = [this, &place](const CycleStep& asked) { carry_out(asked, place); };
    if (is_thread(motion_)) {
        carry_out_thread(motion_, block, coordinates_, before, place, step);
    } else {
        canned_cycles_.carry_out(motion_, again, block, coordinates_, before, place, step);
    }
    modes_.exact_stop = before.exact_stop;
    modes_.path_tolerance = before.path_tolerance;
}

void Interpreter::carry_out(const CycleStep& step, const Place& place) {
    switch (step.kind) {
        case CycleStep::Kind::kRapid:
        case CycleStep::Kind::kFeed:
        case CycleStep::Kind::kThread: {
            const Point target = coordinates_.on_machine(step.to, place);
            if (target == coordinates_.position()) return;
            Move move = move_to(target, place);
            move.rapid = step.kind == CycleStep::Kind::kRapid;
            if (step.kind == CycleStep::Kind::kThread) {
                move.feed = feed_of(step.value * modes_.speed, place);
            }
            add(move, target, place);
            return;
        }
        case CycleStep::Kind::kDwell:
            if (step.value > 0) moves_.dwell(step.value, place);
            return;
        case CycleStep::Kind::kSwitch:
            moves_.stop();
            if (!step.code.empty()) moves_.leave_out(step.code, place);
            return;
        case CycleStep::Kind::kExactPath:
            modes_.exact_stop = false;
            modes_.path_tolerance = 0;
    }
}

}  // namespace curvecore::ref
