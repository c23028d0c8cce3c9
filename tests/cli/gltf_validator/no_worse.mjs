// SPDX-License-Identifier: MIT
// node no_worse.mjs [BEFORE AFTER]...
// Compares the Khronos validator's errors and warnings of scenes before and after `lichen apply`.
// Prints one line a pair; exit status 1 when an AFTER has more of either, or none was compared.
import fs from 'node:fs';
import path from 'node:path';
import { createRequire } from 'node:module';

const validator = createRequire(import.meta.url)('gltf-validator');

async function issuesOf(file) {
  const { issues } = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
    uri: path.basename(file),
    externalResourceFunction: async (uri) =>
      new Uint8Array(fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(uri)))),
  });
  return issues;
}

const files = process.argv.slice(2);
let failures = files.length === 0 ? 1 : 0;
for (let i = 0; i < files.length; i += 2) {
  const [before, after] = [await issuesOf(files[i]), await issuesOf(files[i + 1])];
  const ok = after.numErrors <= before.numErrors && after.numWarnings <= before.numWarnings;
  if (!ok) {
    failures += 1;
    console.log(after.messages);
  }
  console.log(`${ok ? 'ok  ' : 'FAIL'} ${path.basename(files[i + 1])}: ${before.numErrors} errors, `
    + `${before.numWarnings} warnings before; ${after.numErrors}, ${after.numWarnings} after`);
}
process.exit(failures === 0 ? 0 : 1);
