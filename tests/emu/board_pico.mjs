// board_pico.mjs - a Pico in this process, for try.mjs.
//
// What every board gives: title; now(), its time in ns; watch(change(signal, active)), pins as in pico.mjs; hear(byte), its console;
// source: asked for the next byte to type, or -1, as fast as the line is; setInput(name, active); run(ns), to that time; problems;
// off(), which keeps its flash.
import { mcu, clock, problems, BYTE_NS, watchPins, at, setInput, powerOn, keep, step, pass } from './pico.mjs';

const PEN = 4, PEN_GPIO = 6;

export async function open([image, store]) {
  let sending = false;
  function send() {
    const byte = board.source();
    sending = byte >= 0;
    if (!sending) return;
    mcu.uart[0].feedByte(byte);
    at(clock.nanos + BYTE_NS, send);
  }
  const board = {
    title: 'A Pico', problems, setInput, store,
    now: () => clock.nanos,
    watch: (change) => watchPins((signal, active) => signal !== PEN && change(signal, active)),
    // What its pin is told, whatever a servo or solenoid makes of it.
    penIsDown: () => ((mcu.pio[0].pinValues >> PEN_GPIO) & 1) === 1,
    hear: (heard) => (mcu.uart[0].onByte = heard),
    async run(until) {
      if (!sending) send();
      while (clock.nanos < until && !problems.length) pass(step());
    },
    async off() { keep(store); },
  };
  powerOn(image, store);
  return board;
}
