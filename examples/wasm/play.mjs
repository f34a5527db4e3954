// node play.mjs play.wasm: the numbers that play.c prints
import { readFile } from 'node:fs/promises';
const { instance } = await WebAssembly.instantiate(await readFile(process.argv[2]), {});
const { numbers, oscillator, motion, motion_at, tumble, tumble_at, memory } = instance.exports;
const results = new Float64Array(memory.buffer, numbers(), 3000);
// as C prints it: at least two digits of the exponent
const e = (x) => Number.isFinite(x) ? x.toExponential(16).replace(/e([+-])(\d)$/, 'e$10$2') : Number.isNaN(x) ? 'nan' : x < 0 ? '-inf' : 'inf';
oscillator(1.5, 1, -0.01, 0.002, 0);
for (let route = -1; route <= 9; route++) {
    if (motion_at(route, 30, 1e-9) < 0) continue;
    console.log(`${String(route).padStart(2)} ${e(results[0])} ${e(results[1])} ${e(results[2])} ${results[3]} ${results[4]}`);
}
let n = 2 * motion(1e-6, 60, 4);
for (let i = 0; i < n; i++) console.log(e(results[i]));
console.log(e(tumble(1, 2, 5)));
n = 7 * tumble_at(9);
for (let i = 0; i < n; i++) console.log(e(results[i]));
