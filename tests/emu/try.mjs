// try.mjs - a board without a board: the image in its emulator, its console in this terminal, what its pins draw in a picture.
//
//     node try.mjs PICTURE.svg pico IMAGE.bin STORE       (make try-pico; try.sh)
//     node try.mjs PICTURE.svg qemu COMMAND...            (make try-m3, try-microbit)
//
// While the machine stands, time passes as fast as outside; while it draws, as fast as can be. The board's flash is a file:
// what is saved is there the next time. Ctrl-] and a letter is what one does to a board beside typing. From a pipe, lines
// are typed as the board asks for them (XON/XOFF), and the run ends when the last one has been answered.
import { writeFileSync } from 'node:fs';

const [picture, kind, ...how] = process.argv.slice(2);
const board = await (await import(`./board_${kind}.mjs`)).open(how);
const STEPS_PER_MM = 80, ASKED_NS = 20e6; // how often the terminal is looked at
const HELP = `
Ctrl-] then  b: press the start button   x, y: close or open a limit switch   e: emergency stop, on or off
             q: switch off and quit
`;
const say = (s) => process.stdout.write(s.replaceAll('\n', '\r\n'));

// ---- the plotter: where the pen has been, in steps
let strokes = [], place = [0, 0], on = false, down = false, begun = 0;
const dir = [0, 0], STEP = [0, 2], DIR = [1, 3], ENABLE = 5;
board.watch((signal, active) => {
  const motor = STEP.indexOf(signal);
  if (motor >= 0 && active) {
    const lowered = board.penIsDown();
    if (lowered && !down) strokes.push([[...place]]);
    down = lowered;
    place[motor] += dir[motor] ? 1 : -1;
    if (down) strokes.at(-1).push([...place]);
  } else if (DIR.includes(signal)) dir[DIR.indexOf(signal)] = active;
  else if (signal === ENABLE) {
    on = active === 1;
    if (on) begun = board.now();
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
    note(`${strokes.length} strokes in ${((board.now() - begun) / 1e9).toFixed(1)} s of the machine's time: ${picture}`);
  }
  strokes = [];
}

// ---- the terminal
const typed = []; // bytes that have not gone to the board yet
let stopped = false, ended = false, heard = 0, last = '', quit = false, escape = false, fresh = true;
const note = (s) => {
  say(`${fresh ? '' : '\n'}[${s}]\n`);
  fresh = true;
};
board.hear((byte) => {
  heard = board.now();
  if (byte === 0x13 || byte === 0x11) stopped = byte === 0x13;
  else {
    last = (last + String.fromCharCode(byte)).slice(-3);
    process.stdout.write(Buffer.from([byte]));
    fresh = byte === 10;
  }
});
// Realtime characters go past XOFF, as a person's do.
board.source = () => {
  const i = stopped ? typed.findIndex((c) => c === 0x18 || (!piped && (c === 0x21 || c === 0x3f || c === 0x7e))) : 0;
  if (i < 0 || !typed.length) return -1;
  heard = board.now();
  return typed.splice(i, 1)[0];
};
const closed = {};
let release = Infinity; // of the start button
function toggle(name, what) {
  closed[name] = !closed[name];
  board.setInput(name, closed[name]);
  note(`${what} ${closed[name] ? 'closed' : 'open'}`);
}
const COMMAND = {
  b() {
    note('start button');
    board.setInput('button', true);
    release = board.now() + 100e6;
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
  say(`${board.title} in an emulator. What it draws goes to ${picture}; its flash is ${board.store}.${HELP}`);
}

let ahead = process.hrtime.bigint(), real = 0; // ns of real time
while (!quit && !board.problems.length) {
  await board.run(board.now() + ASKED_NS);
  if (board.now() > release) {
    board.setInput('button', false);
    release = Infinity;
  }
  const now = process.hrtime.bigint();
  real += Number(now - ahead);
  ahead = now;
  if (on || piped || board.now() < real) real = board.now(); // as fast as can be, or slower than outside: not to be made good
  const wait = (board.now() - real) / 1e6;
  await new Promise((go) => (wait > 1 ? setTimeout(go, wait) : setImmediate(go)));
  if (piped && ended && !typed.length && !on && last.endsWith('> ') && board.now() > heard + 1e9) quit = true;
}
draw();
await board.off();
if (!piped) process.stdin.setRawMode(false);
note('switched off');
for (const p of board.problems) console.error(`emulator: ${p}`);
process.exit(board.problems.length ? 1 : 0);
