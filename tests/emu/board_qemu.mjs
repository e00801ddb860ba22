// board_qemu.mjs - a board in QEMU, watched by scope_live.c, for try.mjs; what it gives is told in board_pico.mjs. The command that
// starts QEMU is qemu.sh's; $QEMU_SAYS matches what QEMU says of every program.
import { spawn } from 'node:child_process';

const INPUT = ['limit_x', 'limit_y', 'button', 'estop'];
const PEN = 4, PULSES_NS = 2e6; // a solenoid is held by pulses: up is what has been up so long
const BYTE_NS = 1e10 / 115200, AT_ONCE = 16; // the queue of a PC's UART: so many still come after an XOFF
const TITLE = { lm3s6965evb: 'A Cortex-M3 (LM3S6965)', microbit: 'A micro:bit' };

export async function open(command) {
  let now = 0, stopped = null, change = () => {}, heard = () => {}, pen = 0, lifted = 0, record = null, gone = false;
  const problems = [];
  // Through a pipe: a socket, as Node.js makes them, is full after some 280 bytes that come one by one, and QEMU's model of the nRF51 then
  // forgets the interrupt for what it sends later.
  const qemu = spawn('sh', ['-c', '"$@" | cat', 'sh', ...command], { stdio: ['ignore', 'pipe', 'pipe', 'pipe'], detached: true });
  qemu.on('error', (error) => problems.push(error.message));
  qemu.on('close', () => {
    gone = true;
    stopped?.();
  });
  qemu.stdio[3].on('error', () => {});
  let said = '';
  const usual = new RegExp(process.env.QEMU_SAYS);
  qemu.stderr.on('data', (text) => {
    const lines = (said + text).split('\n');
    said = lines.pop();
    problems.push(...lines.filter((line) => !usual.test(line)));
  });
  function obey(line) {
    const [kind, ns, pin, level] = line.split(' ');
    now = Number(ns);
    if (kind === 't') stopped?.();
    else if (Number(pin) !== PEN) change(Number(pin), Number(level));
    else {
      pen = Number(level);
      if (!pen) lifted = now;
    }
  }
  qemu.stdout.on('data', (data) => {
    for (const byte of data) {
      if (record === null) {
        if (byte === 0) record = '';
        else heard(byte);
      } else if (byte !== 10) record += String.fromCharCode(byte);
      else {
        const line = record;
        record = null;
        obey(line);
      }
    }
  });
  const stands = () => new Promise((resolve) => (gone ? resolve() : (stopped = resolve)));
  await stands();
  const orders = [];
  return {
    title: TITLE[command[command.indexOf('-M') + 1]] ?? 'A board',
    store: /store=([^,]*)/.exec(command.join(' '))[1],
    problems,
    now: () => now,
    watch: (f) => (change = f),
    penIsDown: () => pen === 1 || now - lifted < PULSES_NS,
    hear: (f) => (heard = f),
    setInput: (name, active) => orders.push(`input ${INPUT.indexOf(name)} ${active ? 1 : 0}\n`),
    async run(until) {
      while (now < until && !gone && !problems.length) {
        let hex = '', bytes = 0;
        for (let byte; bytes < AT_ONCE && (byte = this.source()) >= 0; bytes++) hex += byte.toString(16).padStart(2, '0');
        if (bytes) orders.push(`type ${hex}\n`);
        orders.push(`go ${Math.ceil(bytes ? now + bytes * BYTE_NS : until)}\n`);
        const stop = stands();
        qemu.stdio[3].write(orders.splice(0).join(''));
        await stop;
      }
      if (gone && !problems.length) problems.push('QEMU has ended');
    },
    async off() {
      const ended = stands();
      qemu.stdio[3].end();
      while (!gone) await ended;
    },
  };
}
