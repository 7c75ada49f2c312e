// SPDX-License-Identifier: Apache-2.0
// The worker behind the page: draws one program after the other. It stands behind emcc's file.
"use strict";

let made = null;

/// What a program gives: data to draw, or {refused, reason}.
async function draw({ name, text, options }) {
  if (!made) made = curvecoreModule();
  const module = await made;
  module.FS.writeFile(name, text);
  const answer = module.cwrap("curvecore_draw", "string", ["string"])(`${name} ${options}`);
  const data = JSON.parse(answer);
  if (data.refused) return { data };
  return { data, report: module.cwrap("curvecore_report", "string", [])(),
           samples: module.FS.readFile("samples.csv") };
}

if (typeof onmessage !== "undefined" || typeof importScripts === "function") {
  onmessage = async ({ data: asked }) => {
    let answer;
    try {
      answer = await draw(asked);
    } catch (error) {  // memory that cannot grow ends the module
      const memory = /memory|alloc|abort/i.test(String(error));
      answer = { data: { refused: memory ? "memory" : "page",
                         reason: memory ? "there is not enough memory in the page for this part"
                                        : String(error) } };
      made = null;
    }
    postMessage({ ...answer, turn: asked.turn });
  };
}
