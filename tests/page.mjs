// What the page of examples/wasm/play.html says of itself in Chromium, in windows of several widths: the route that it took.
// Chromium is spoken to over its DevTools pipe: commands on descriptor 3, answers on 4, each a line of JSON that ends in 0.
// usage: node page.mjs URL FOLDER WIDTH...      prints WIDTH ROUTE WIDTH_OF_THE_PAGE, a line a window
import { spawn } from 'node:child_process';
import { setTimeout } from 'node:timers/promises';

const [url, folder, ...widths] = process.argv.slice(2);
const SECONDS = 90; // for a browser that starts while other tests run
const chromium = spawn('chromium', ['--headless', '--no-sandbox', '--disable-gpu', `--user-data-dir=${folder}`, '--remote-debugging-pipe'],
  { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
const stop = (status) => { chromium.kill('SIGKILL'); process.exit(status); };
setTimeout(1000 * SECONDS).then(() => { console.log(`no answer in ${SECONDS} s`); stop(1); });

const answers = new Map();
let calls = 0, unread = '';
chromium.stdio[4].on('data', (bytes) => {
  const parts = (unread + bytes).split('\0');
  unread = parts.pop();
  for (const part of parts) {
    const { id, result, error } = JSON.parse(part);
    if (error) console.log(error.message);
    answers.get(id)?.(result);
  }
});
const call = (method, params, sessionId) => new Promise((answer) => {
  answers.set(++calls, answer);
  chromium.stdio[3].write(JSON.stringify({ id: calls, method, params, sessionId }) + '\0');
});

const { targetId } = await call('Target.createTarget', { url: 'about:blank' });
const { sessionId } = await call('Target.attachToTarget', { targetId, flatten: true });
for (const width of widths) {
  await call('Emulation.setDeviceMetricsOverride', { width: Number(width), height: 1900, deviceScaleFactor: 1, mobile: false }, sessionId);
  await call('Page.navigate', { url }, sessionId);
  const expression = `document.documentElement?.dataset.ready + ' ' + document.documentElement?.scrollWidth`;
  let said;
  do {
    await setTimeout(100);
    ({ result: { value: said } } = await call('Runtime.evaluate', { expression }, sessionId));
  } while (said.startsWith('undefined'));
  console.log(width, said);
}
stop(0);
