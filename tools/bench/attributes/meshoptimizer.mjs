// node meshoptimizer.mjs PACKAGE MESH.ply FACES WEIGHT OUT.ply: simplifyWithAttributes of the npm package meshoptimizer
// in that folder, on a PLY as spheres.py writes it. Colours go from 0 to 1, and count with the weight.
import { readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';

const [folder, file, faces, weight, out] = process.argv.slice(2);
const { MeshoptSimplifier } = await import(`${resolve(folder)}/meshopt_simplifier.js`);
await MeshoptSimplifier.ready;

const [head, body] = readFileSync(file, 'utf8').split('end_header\n');
const count = Number(/element vertex (\d+)/.exec(head)[1]);
const lines = body.trimEnd().split('\n');
const positions = new Float32Array(3 * count);
const colours = new Float32Array(3 * count);
lines.slice(0, count).forEach((line, v) => {
  const numbers = line.split(' ').map(Number);
  positions.set(numbers.slice(0, 3), 3 * v);
  colours.set(numbers.slice(3, 6).map((x) => x / 255), 3 * v);
});
const indices = Uint32Array.from(lines.slice(count).flatMap((line) => line.split(' ').slice(1).map(Number)));

const weights = [1, 1, 1].map(() => Number(weight));
const [kept] = MeshoptSimplifier.simplifyWithAttributes(indices, positions, 3, colours, 3, weights, null, 3 * Number(faces), 1e9);

const number = new Map();
for (const v of kept) if (!number.has(v)) number.set(v, number.size);
let text = head.replace(/element vertex \d+/, `element vertex ${number.size}`)
  .replace(/element face \d+/, `element face ${kept.length / 3}`) + 'end_header\n';
for (const v of number.keys()) text += lines[v] + '\n';
for (let i = 0; i < kept.length; i += 3) text += `3 ${number.get(kept[i])} ${number.get(kept[i + 1])} ${number.get(kept[i + 2])}\n`;
writeFileSync(out, text);
