// pico.mjs - a Pico in rp2040js, looked at from outside: its flash, its pins, its console, its switches, virtual time.
//
// The package's own run loop is not used: time is advanced instruction by instruction, and what was pending before WFI ends it.
// The boot ROM is stood in for: the boot loader's checksum is checked, it is copied to RAM and entered, as the ROM does; and
// flash routines are found where the ROM has them. $EMU_MODULES: where the package's folder node_modules is.
import { readFileSync, writeFileSync, existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';
const require = createRequire(pathToFileURL(process.env.EMU_MODULES + '/'));
const { RP2040, GPIOPinState } = require('rp2040js');

export const SIGNAL = ['x_step', 'x_dir', 'y_step', 'y_dir', 'pen', 'enable'];
const PIN = { 2: [0, 0], 3: [1, 0], 4: [2, 0], 5: [3, 0], 6: [4, 0], 7: [5, 1] }; // GPIO: signal, active low
export const INPUT = { limit_x: 10, limit_y: 11, button: 12, estop: 13 };
export const BYTE_NS = 1e10 / 115200;

export const mcu = new RP2040();
export const { core, clock } = mcu;
// What the emulator says is wrong with the program.
export const problems = [];
export const complain = (from, text) => {
  if (problems.length < 20) problems.push(`${from}: ${text}`);
};
mcu.logger = { debug() {}, info() {}, warn: complain, error: complain };
mcu.onBreak = (code) => romCall(code);

// ---- what the boot ROM offers
const rom = new Uint16Array(mcu.bootrom.buffer);
const ROM_NAMES = ['IF', 'EX', 'RE', 'RP', 'FC', 'CX'];
const ROM_LOOKUP = 0x7f, ROM_FIRST = 0x40;
rom[0x14 / 2] = 0x300;
rom[0x18 / 2] = 0x201;
rom[0x200 / 2] = 0xbe00 | ROM_LOOKUP; // bkpt; bx lr
rom[0x202 / 2] = 0x4770;
ROM_NAMES.forEach((_, i) => {
  rom[(0x100 + 4 * i) / 2] = 0xbe00 | (ROM_FIRST + i);
  rom[(0x102 + 4 * i) / 2] = 0x4770;
});
export const power = { off: false }; // it may fail while the flash is busy: half of that is done then
function half(from, bytes, old, ns) {
  clock.tick(ns);
  if (power.off) mcu.flash.set(old.subarray(bytes / 2), from + bytes / 2);
}
let writable = false;
function romCall(code) {
  const r = core.registers;
  if (code === ROM_LOOKUP) {
    const i = ROM_NAMES.findIndex((s) => (s.charCodeAt(0) | (s.charCodeAt(1) << 8)) === r[1]);
    r[0] = i < 0 ? 0 : (0x100 + 4 * i) | 1;
    return;
  }
  const name = ROM_NAMES[code - ROM_FIRST];
  if (name === 'EX') writable = true;
  else if (name === 'CX') writable = false;
  else if (name === 'RE') {
    if (!writable || r[0] & 4095 || r[1] & 4095) complain('flash', 'erase');
    const old = mcu.flash.slice(r[0], r[0] + r[1]);
    mcu.flash.fill(0xff, r[0], r[0] + r[1]);
    half(r[0], r[1], old, 45e6);
  } else if (name === 'RP') {
    if (!writable || r[0] & 255 || r[2] & 255) complain('flash', 'program');
    const old = mcu.flash.slice(r[0], r[0] + r[2]);
    for (let i = 0; i < r[2]; i++) mcu.flash[r[0] + i] &= mcu.readUint8(r[1] + i);
    half(r[0], r[2], old, (0.7e6 * r[2]) / 256);
  } else if (name === undefined) {
    complain('core', `breakpoint ${code}`);
  }
}

// ---- PIO by virtual time. The package runs it by a timer of the host, without its clock divider; its queues cannot be joined.
for (const pio of mcu.pio) {
  pio.run = () => {};
  for (const sm of pio.machines) {
    const { checkWait, writeUint32 } = sm;
    const periodNs = () => ((sm.clockDivInt || 65536) + sm.clockDivFrac / 256) * (1e9 / mcu.clkSys);
    let on = false;
    const alarm = clock.createAlarm(() => {
      sm.step();
      pio.checkChangedPins();
      if (sm.waiting) return;
      let n = 1;
      if (pio.instructions[sm.pc] === (0x40 | sm.pc)) { // a loop that only counts x down
        n += sm.x;
        sm.x = 0;
      }
      alarm.schedule(n * periodNs());
    });
    sm.clkDivRestart = () => {};
    sm.checkWait = () => {
      const was = sm.waiting;
      checkWait.call(sm);
      if (was && !sm.waiting && on) alarm.schedule(periodNs());
    };
    sm.writeUint32 = (offset, value) => {
      if (offset === 8 && (sm.shiftCtrl ^ value) & 0xc0000000) {
        sm.txFIFO = new sm.txFIFO.constructor(value & 0x40000000 ? 8 : 4);
        sm.updateDMATx();
      }
      writeUint32.call(sm, offset, value);
    };
    sm.enabledChanged = () => {
      if (sm.enabled === on) return;
      on = sm.enabled;
      if (on && !sm.waiting) alarm.schedule(periodNs());
      else alarm.cancel();
    };
  }
  const { writeUint32 } = pio;
  pio.writeUint32 = (offset, value) => {
    writeUint32.call(pio, offset, value);
    for (const sm of pio.machines) sm.enabledChanged();
    pio.checkChangedPins();
  };
}

// ---- pins, console, switches
// change(signal, active) when a pin of the machine changes; turned: names of signals whose level is turned round.
export function watchPins(change, turned = []) {
  const level = [0, 0, 0, 0, 0, 0];
  for (const gpio of Object.keys(PIN)) {
    const [signal, usual] = PIN[gpio], low = usual ^ turned.includes(SIGNAL[signal]);
    mcu.gpio[gpio].addListener((state) => {
      const driven = state === GPIOPinState.High || state === GPIOPinState.Low; // else the resistor's: at rest
      const active = driven ? (state === GPIOPinState.High ? 1 : 0) ^ low : 0;
      if (active === level[signal]) return;
      level[signal] = active;
      change(signal, active);
    });
  }
}
const { writeUint32: writeUart } = mcu.uart[0];
mcu.uart[0].writeUint32 = (offset, value) => {
  if (offset !== 4) writeUart.call(mcu.uart[0], offset, value); // RSR, which the package lacks: clears errors
};
export const at = (ns, what) => clock.createAlarm(what).schedule(Math.max(0, ns - clock.nanos));
export const setInput = (name, active) => {
  if (mcu.gpio[INPUT[name]].rawInputValue === active) mcu.gpio[INPUT[name]].setInputValue(!active);
};
for (const pin of Object.values(INPUT)) mcu.gpio[pin].setInputValue(true);

// ---- power on: what the boot ROM does. The last 16 KB of flash are what a board keeps
const STORE_AT = 0x200000 - 16384;
let boot;
export function powerOn(image, store) {
  mcu.flash.fill(0xff);
  mcu.flash.set(readFileSync(image), 0);
  if (store && existsSync(store)) mcu.flash.set(readFileSync(store), STORE_AT);
  boot = mcu.flash.slice(0, 256);
  let crc = 0xffffffff;
  for (let i = 0; i < 252; i++) {
    crc ^= boot[i] << 24;
    for (let k = 0; k < 8; k++) crc = crc & 0x80000000 ? (crc << 1) ^ 0x04c11db7 : crc << 1;
  }
  if (crc >>> 0 !== new DataView(boot.buffer).getUint32(252, true)) complain('boot2', 'checksum');
  enterBoot();
}
function enterBoot() {
  mcu.sram.set(boot, 0x41f00);
  core.SP = 0x20041f00;
  core.PC = 0x20041f00;
}
export const keep = (store) => writeFileSync(store, mcu.flash.slice(STORE_AT, STORE_AT + 16384));

// ---- what the watchdog resets, as the firmware asks it to: everything but the oscillators
const timer = mcu.peripherals[0x40054], watchdog = mcu.peripherals[0x40058];
watchdog.onWatchdogTrigger = () => {
  for (const alarm of timer.alarms) timer.disarmAlarm(alarm);
  timer.intRaw = timer.intEnable = timer.intForce = 0;
  for (const channel of mcu.pwm.channels) channel.reset();
  mcu.sio.gpioValue = mcu.sio.gpioOutputEnable = 0;
  for (const pin of mcu.gpio) {
    pin.ctrl = 0x1f;
    pin.checkForUpdates();
  }
  watchdog.enable = watchdog.timer.enable = watchdog.alarm.enable = false;
  core.pendingInterrupts = core.enabledInterrupts = 0;
  core.pendingPendSV = core.pendingSystick = core.waiting = core.PM = false;
  core.IPSR = 0;
  enterBoot();
};

// One instruction, or up to the next alarm where the processor waits (stuck: where it goes round in one instruction). Its cycles.
export function step(stuck = false) {
  let cycles;
  if (core.waiting || stuck) {
    cycles = Math.max(1, Math.ceil((clock.nanosToNextAlarm * mcu.clkSys) / 1e9 - 1e-6));
    core.cycles += cycles;
  } else {
    const before = core.cycles;
    core.executeInstruction();
    cycles = core.cycles - before;
  }
  return cycles;
}
export function pass(cycles) {
  clock.tick((cycles * 1e9) / mcu.clkSys);
  if (core.waiting && core.checkForInterrupts()) core.waiting = false;
}
