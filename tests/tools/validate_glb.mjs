// Validates every GLB file of a folder: any error or warning fails.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

const skipped = 77;

let validator;
try {
  validator = (await import("gltf-validator")).default;
} catch {
  console.log("skipped: run `npm ci` in tests/tools to install the glTF validator");
  process.exit(skipped);
}

const folder = process.argv[2];
const names = readdirSync(folder).filter((name) => name.endsWith(".glb")).sort();
let faults = names.length === 0 ? 1 : 0;
for (const name of names) {
  const bytes = new Uint8Array(readFileSync(join(folder, name)));
  const { issues } = await validator.validateBytes(bytes, { uri: name });
  console.log(`${name}: ${issues.numErrors} errors, ${issues.numWarnings} warnings, ${issues.numInfos} infos`);
  for (const message of issues.messages) console.log(`  ${message.code} ${message.pointer}: ${message.message}`);
  faults += issues.numErrors + issues.numWarnings;
}
process.exit(faults === 0 ? 0 : 1);
