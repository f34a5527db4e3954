// node leaking.mjs leaking.wasm: the numbers that leaking.c prints
import { readFile } from 'node:fs/promises';
const { instance } = await WebAssembly.instantiate(await readFile(process.argv[2]), {});
const { buffer, motion, memory } = instance.exports;
const n = motion(3, -0.01, 0, 60, 7), points = new Float64Array(memory.buffer, buffer(), 2 * n);
const e = (x) => x.toExponential(16);
for (let i = 0; i < n; i++)
    console.log(`t = ${String(10 * i).padStart(2)}  x = ${e(points[2 * i])}  amplitude ${e(points[2 * i + 1])}`);
