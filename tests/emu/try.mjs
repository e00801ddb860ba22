// try.mjs - a Pico without a Pico: the image in its emulator, its console in this terminal, what its pins draw in a picture.
//
//     node try.mjs IMAGE.bin PICTURE.svg STORE       (make try-pico)
//
// While the machine stands, time passes as fast as outside; while it draws, as fast as can be. STORE is the board's flash:
// what is saved is there the next time. Ctrl-] and a letter is what one does to a board beside typing. From a pipe, lines
// are typed as the board asks for them (XON/XOFF), and the run ends when the last one has been answered.
import { writeFileSync } from 'node:fs';
import { mcu, clock, problems, BYTE_NS, watchPins, at, setInput, powerOn, keep, step, pass } from './pico.mjs';

const [image, picture, store] = process.argv.slice(2);
const STEPS_PER_MM = 80, ASKED_NS = 20e6; // how often the terminal is looked at
const HELP = `
Ctrl-] then  b: press the start button   x, y: close or open a limit switch   e: emergency stop, on or off
             q: switch off and quit
`;
const say = (s) => process.stdout.write(s.replaceAll('\n', '\r\n'));

// ---- the plotter: where the pen has been, in steps
let strokes = [], place = [0, 0], on = false, down = false, begun = 0;
const dir = [0, 0], STEP = [0, 2], DIR = [1, 3], ENABLE = 5, PEN_GPIO = 6;
// What its pin is told, whatever a servo or solenoid makes of it.
const isDown = () => ((mcu.pio[0].pinValues >> PEN_GPIO) & 1) === 1;
watchPins((signal, active) => {
  const motor = STEP.indexOf(signal);
  if (motor >= 0 && active) {
    if (isDown() && !down) strokes.push([[...place]]);
    down = isDown();
    place[motor] += dir[motor] ? 1 : -1;
    if (down) strokes.at(-1).push([...place]);
  } else if (DIR.includes(signal)) dir[DIR.indexOf(signal)] = active;
  else if (signal === ENABLE) {
    on = active === 1;
    if (on) begun = clock.nanos;
    else draw();
    down = false;
    if (!on) place = [0, 0]; // motors off: wherever it is, the board takes it to be at home
  }
});
function draw() {
  if (strokes.length) {
    const all = strokes.flat();
    const lo = [0, 1].map((k) => all.reduce((m, p) => Math.min(m, p[k]), Infinity));
    const hi = [0, 1].map((k) => all.reduce((m, p) => Math.max(m, p[k]), -Infinity));
    const edge = 2 * STEPS_PER_MM, size = [0, 1].map((k) => hi[k] - lo[k] + 2 * edge);
    // Points a tenth of a millimetre apart: a step shows as little as that of a pen.
    const thin = (s) => s.filter((p, i) => i % (STEPS_PER_MM / 8) === 0 || i === s.length - 1);
    const path = strokes.map((s) => 'M' + thin(s).map((p) => `${p[0] - lo[0] + edge},${hi[1] - p[1] + edge}`).join(' ')).join('\n');
    writeFileSync(picture, `<svg xmlns="http://www.w3.org/2000/svg" width="${size[0] / STEPS_PER_MM}mm" height="${size[1] / STEPS_PER_MM}mm" ` +
      `viewBox="0 0 ${size[0]} ${size[1]}"><rect width="100%" height="100%" fill="#fff"/>` +
      `<path fill="none" stroke="#000" stroke-width="${0.3 * STEPS_PER_MM}" stroke-linecap="round" stroke-linejoin="round" d="${path}"/></svg>\n`);
    note(`${strokes.length} strokes in ${((clock.nanos - begun) / 1e9).toFixed(1)} s of the machine's time: ${picture}`);
  }
  strokes = [];
}

// ---- the terminal
const typed = []; // bytes that have not gone to the board yet
let stopped = false, sending = false, ended = false, heard = 0, last = '', quit = false, escape = false, fresh = true;
const note = (s) => {
  say(`${fresh ? '' : '\n'}[${s}]\n`);
  fresh = true;
};
mcu.uart[0].onByte = (byte) => {
  heard = clock.nanos;
  if (byte === 0x13 || byte === 0x11) stopped = byte === 0x13;
  else {
    last = (last + String.fromCharCode(byte)).slice(-3);
    process.stdout.write(Buffer.from([byte]));
    fresh = byte === 10;
  }
};
// Realtime characters go past XOFF, as a person's do.
function send() {
  const i = stopped ? typed.findIndex((c) => c === 0x18 || (!piped && (c === 0x21 || c === 0x3f || c === 0x7e))) : 0;
  if (i < 0 || !typed.length) {
    sending = false;
    return;
  }
  heard = clock.nanos;
  mcu.uart[0].feedByte(typed.splice(i, 1)[0]);
  at(clock.nanos + BYTE_NS, send);
}
const closed = {};
function toggle(name, what) {
  closed[name] = !closed[name];
  setInput(name, closed[name]);
  note(`${what} ${closed[name] ? 'closed' : 'open'}`);
}
const COMMAND = {
  b() {
    note('start button');
    setInput('button', true);
    at(clock.nanos + 100e6, () => setInput('button', false));
  },
  x: () => toggle('limit_x', 'limit switch x'),
  y: () => toggle('limit_y', 'limit switch y'),
  e: () => toggle('estop', 'emergency stop'),
  q: () => (quit = true),
};
const piped = !process.stdin.isTTY;
process.stdin.on('data', (data) => {
  for (const byte of data) {
    if (escape) (COMMAND[String.fromCharCode(byte)] ?? (() => say(HELP)))();
    else if (byte !== 0x1d) typed.push(piped && byte === 10 ? 13 : byte);
    escape = !escape && byte === 0x1d;
  }
});
process.stdin.on('end', () => (ended = true));
if (!piped) {
  process.stdin.setRawMode(true);
  say(`A Pico in an emulator. What it draws goes to ${picture}; its flash is ${store}.${HELP}`);
}

powerOn(image, store);
let ahead = process.hrtime.bigint(), real = 0; // ns of real time
while (!quit && !problems.length) {
  const until = clock.nanos + ASKED_NS;
  while (clock.nanos < until && !problems.length) pass(step());
  if (typed.length && !sending) {
    sending = true;
    send();
  }
  const now = process.hrtime.bigint();
  real += Number(now - ahead);
  ahead = now;
  if (on || piped || clock.nanos < real) real = clock.nanos; // as fast as can be, or slower than outside: not to be made good
  const wait = (clock.nanos - real) / 1e6;
  await new Promise((go) => (wait > 1 ? setTimeout(go, wait) : setImmediate(go)));
  if (piped && ended && !typed.length && !on && last.endsWith('> ') && clock.nanos > heard + 1e9) quit = true;
}
draw();
keep(store);
if (!piped) process.stdin.setRawMode(false);
note('switched off');
for (const p of problems) console.error(`rp2040js: ${p}`);
process.exit(problems.length ? 1 : 0);
