// node validate.mjs LEVEL.glb: the Khronos validator's verdict on a level. Needs the npm package gltf-validator
// beside this file or on NODE_PATH. Exit 0 without errors, 1 with, 2 if it cannot be run.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const file = process.argv[2];
if (!file) {
  console.error('usage: node validate.mjs LEVEL.glb');
  process.exit(2);
}
let validator;
try {
  validator = createRequire(import.meta.url)('gltf-validator');
} catch {
  console.error('validate.mjs: the npm package gltf-validator is not installed (npm install gltf-validator)');
  process.exit(2);
}
const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), { maxIssues: 200 });
const { numErrors, numWarnings, numInfos, messages } = report.issues;
const seen = new Map();
for (const m of messages.filter((m) => m.severity <= 1)) {
  const entry = seen.get(m.code) ?? { count: 0, message: m.message, pointer: m.pointer, severity: m.severity };
  entry.count += 1;
  seen.set(m.code, entry);
}
for (const [code, e] of seen) console.log(`${e.severity === 0 ? 'error' : 'warning'} ${code} x${e.count}: ${e.message} at ${e.pointer}`);
const size = report.info ? `; ${report.info.totalTriangleCount} triangles, ${report.info.materialCount} materials` : '';
console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} notes${size}`);
process.exit(numErrors === 0 ? 0 : 1);
