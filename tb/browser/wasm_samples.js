// SPDX-License-Identifier: Apache-2.0
// Draws a part by the site's WebAssembly in Node, and writes its samples.csv, or prints why not:
//
//   node wasm_samples.js curvecore.js PART OPTIONS SAMPLES
"use strict";

const fs = require("fs");
const path = require("path");

async function main([module, part, options, samples]) {
  const made = await require(path.resolve(module))();
  const name = path.basename(part);
  made.FS.writeFile(name, fs.readFileSync(part));
  const draw = made.cwrap("curvecore_draw", "string", ["string"]);
  const answer = JSON.parse(draw(`${name} ${options}`));
  if (answer.refused) console.log(`${answer.refused}: ${answer.reason}`);
  else fs.writeFileSync(samples, made.FS.readFile("samples.csv"));
}

main(process.argv.slice(2));
