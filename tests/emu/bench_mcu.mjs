// bench_mcu.mjs - what boards take for surfaces, counted from outside the firmware, beside gnuplot on this PC.
//
//     node bench_mcu.mjs BUILDDIR        (make bench-mcu; SIZES="20 60" RANDOM="20 60" CUBES="2 5" choose)
//     node bench_mcu.mjs BUILDDIR large  (make bench-mcu-large: the Pico's large scenes, drawn to the end; half an hour)
//
// The Pico runs in rp2040js, which counts cycles; bench_probe.mjs says in which stage. The others run in QEMU, which counts
// instructions. gnuplot's figure is the CPU time of its process less that of an empty plot.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const build = process.argv[2];
const tmp = mkdtempSync(join(tmpdir(), 'bench-mcu-'));
const sizes = (name, usual) => (process.env[name] ?? usual).split(' ').filter(Boolean).map(Number);
const SMOOTH = sizes('SIZES', '20 60 100'), RANDOM = sizes('RANDOM', '20 60 100');
const FUNCTION = { smooth: 'exp(-x**2-y**2)', random: 'rand(0)' };
const PICO_HZ = 133e6;

// Long drawings are made small and quick: the computing is the same.
const QUICK = 'set paper 40,30 margin 2; set machine speed 200 travel 200 accel 5000 lift 0.01 lower 0.01';
function stimulus(shape, n, machine, more = '') {
  const file = join(tmp, 'scene.stim');
  writeFileSync(file, [
    `20000 type set isosamples ${n}; set view from 6,8,3\\r`,
    '200000 type set xrange [-2:2]; set yrange [-2:2]\\r',
    `400000 type ${machine.split(';')[0].trim() || 'print 0'}\\r`,
    `600000 type ${machine.split(';')[1]?.trim() || 'print 0'}\\r`,
    `2000000 type splot ${FUNCTION[shape]}\\r`, more].join('\n') + '\n');
  return file;
}

// k x k unit cubes, pitch 1.5, typed as the rows of an OBJ file.
function cubes(k, hidden) {
  const file = join(tmp, 'cubes.stim'), lines = [`20000 type set view 65,30; set hidden3d ${hidden}\\r`, "150000 type splot '-' solid\\r"];
  let at = 300000;
  for (let n = 0; n < k * k; n++, at += 60000) {
    const v = [...Array(8).keys()].map((c) => `v ${1.5 * (n % k) + (c & 1)} ${1.5 * Math.floor(n / k) + ((c >> 1) & 1)} ${c >> 2}\\r`);
    const f = ['-8 -6 -5 -7', '-4 -3 -1 -2', '-8 -7 -3 -4', '-6 -2 -1 -5', '-8 -4 -2 -6', '-7 -5 -1 -3'].map((c) => `f ${c}\\r`);
    lines.push(`${at} type ${v.join('')}`, `${at + 30000} type ${f.join('')}`);
  }
  writeFileSync(file, [...lines, `${at} type e\\r`].join('\n') + '\n');
  return file;
}

function pico(shape, n, until, machine, more) {
  const stim = FUNCTION[shape] ? stimulus(shape, n, machine, more) : cubes(n, shape);
  const out = join(tmp, 'pico.json'), text = join(tmp, 'pico.txt');
  const run = spawnSync('node', ['tests/emu/rp2040.mjs', `${build}/firmware/rp2040.bin`, stim,
    '/dev/null', text, '99', join(process.cwd(), 'tests/emu/bench_probe.mjs'), `${build}/firmware/rp2040.elf`, until, out],
    { env: { ...process.env, EMU_MODULES: `${build}/emu` }, encoding: 'utf8', timeout: 1800e3 });
  if (run.status !== 0) throw new Error(`pico ${shape} ${n}: ${run.stderr}`);
  return { ...JSON.parse(readFileSync(out)), text: readFileSync(text, 'latin1') };
}

const gnuplotThere = spawnSync('gnuplot', ['--version']).status === 0;
function cpuMs(script, repeat) {
  const file = join(tmp, 'g.gp');
  writeFileSync(file, script);
  return 1e3 * Number(execFileSync(`${build}/bench/cpu_time`, [String(repeat), 'gnuplot', file],
    { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }));
}
function gnuplotMs(shape, n) {
  if (!gnuplotThere || (shape === 'random' && n > 200)) return undefined;
  const head = 'set term dumb\nset hidden3d\nset xrange [-2:2]\nset yrange [-2:2]\n';
  const empty = cpuMs(`${head}set isosamples 2\nset samples 2\nsplot 0 with lines\n`, 5);
  return Math.max(0, cpuMs(`${head}set isosamples ${n}\nset samples ${n}\nsplot ${FUNCTION[shape]} with lines\n`, n > 60 ? 1 : 5) - empty);
}

// Without the way from home: the drawing was begun and stopped while the pen was being lowered, in 10 ms, and is begun again.
function there(shape, n, penMs) {
  const at = (ms) => Math.round(1e3 * (penMs + ms));
  const { ms } = pico(shape, n, 'again', QUICK, `${at(2)} type \\x18\n${at(1000)} type splot ${FUNCTION[shape]}\\r`);
  return ms.pen - ms.line;
}

function table() {
  console.log('RP2040 at 133 MHz: cycles per facet for evaluating, projecting and hiding; the whole surface, beside gnuplot on this PC\n');
  console.log('| surface | n | evaluate | project | hide | together | ms | gnuplot hidden3d, CPU ms | gnuplot / board | line to first step, ms | line to pen down, ms | the same from where the drawing begins, ms |');
  console.log('|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|');
  for (const [shape, list] of [['smooth', SMOOTH], ['random', RANDOM]]) {
    for (const n of list) {
      const r = pico(shape, n, 'hidden', QUICK), c = r.cycles, facets = (n - 1) ** 2;
      const sum = c.measure + c.view + c.hide + c.evaluate, ms = (1e3 * sum) / PICO_HZ, g = gnuplotMs(shape, n);
      const first = r.ms.pen !== undefined ? r : pico(shape, n, 'pen', QUICK);
      const cell = (v) => Math.round(v / facets).toLocaleString('en');
      console.log(`| ${shape} | ${n} | ${cell(c.measure + c.evaluate)} | ${cell(c.view)} | ${cell(c.hide)} | ${cell(sum)} | ${ms.toFixed(1)} | ` +
        `${g?.toFixed(0) ?? '-'} | ${g ? (g / ms).toFixed(2) : '-'} | ${(first.ms.step - first.ms.line).toFixed(1)} | ${(first.ms.pen - first.ms.line).toFixed(1)} | ${there(shape, n, first.ms.pen).toFixed(1)} |`);
    }
  }
}

// What evaluating takes, of n^2 points; then the first of it is drawn.
function expressions(n) {
  console.log(`\nRP2040: other expressions, ${n}x${n}\n\n| expression | evaluate, cycles a point | line to first step, ms |\n|---|--:|--:|`);
  for (const f of ['x*y', 'x**2-y**2', 'sin(x*y)', 'sqrt(x**2+y**2)', 'sin(5*sqrt(x**2+y**2))/sqrt(x**2+y**2)',
    '3*(1-x)**2*exp(-x**2-(y+1)**2)-10*(x/5-x**3-y**5)*exp(-x**2-y**2)-1./3*exp(-(x+1)**2-y**2)']) {
    FUNCTION.other = f;
    const { cycles, ms } = pico('other', n, 'step', QUICK);
    console.log(`| \`${f}\` | ${Math.round(cycles.measure / n ** 2).toLocaleString('en')} | ${(ms.step - ms.line).toFixed(1)} |`);
  }
}

// Twelve edges a cube.
function solids() {
  console.log('\nRP2040: k x k cubes, cycles per edge; hide: the convex kernel, or CUT and DRAW of haloed lines.\nWhere it is not sure that all fits, all of it was done once before, to try.\n');
  console.log('| hidden3d | k | edges | build | project | once | hide | together, ms |\n|---|--:|--:|--:|--:|--:|--:|--:|');
  for (const hidden of ['convex', 'halo'])
    for (const k of sizes('CUBES', '2 5')) {
      const c = pico(hidden, k, 'hidden').cycles, edges = 12 * k * k, sum = c.build + c.view + c.once + c.hide;
      const cell = (v) => Math.round(v / edges).toLocaleString('en');
      console.log(`| ${hidden} | ${k} | ${edges} | ${cell(c.build)} | ${cell(c.view)} | ${cell(c.once)} | ${cell(c.hide)} | ` +
        `${((1e3 * sum) / PICO_HZ).toFixed(1)} |`);
    }
}

// Drawn to the end; what the board itself says of its memory.
function memory(board, said) {
  console.log(`\n${board}\n`);
  const text = said.replace(/[\x11\x13\r]/g, ''), at = text.lastIndexOf('memory\nconsole');
  if (at < 0) throw new Error(`${board}: no answer\n${text}`);
  console.log(text.slice(at + 7).split('\n').filter((l) => l && !l.startsWith('>')).map((l) => `    ${l}`).join('\n'));
}

// Polygons: two lights, shadows, a translucent pane; the area sort takes what memory there is.
function polygons() {
  const file = join(tmp, 'glass.stim'), text = join(tmp, 'glass.txt');
  writeFileSync(file, readFileSync('tests/emu/scenes/glass.stim', 'utf8') + '+60000000 type memory\\r\n+60500000 quit\n');
  const run = spawnSync('node', ['tests/emu/rp2040.mjs', `${build}/firmware/rp2040.bin`, file, '/dev/null', text, '99'],
    { env: { ...process.env, EMU_MODULES: `${build}/emu` }, encoding: 'utf8', timeout: 900e3 });
  if (run.status !== 0) throw new Error(`pico glass: ${run.stderr}`);
  memory('Pico, a box under glass in two lights, drawn to the end', readFileSync(text, 'latin1'));
}

function qemu(board, shape, n, seconds) {
  const stim = stimulus(shape, n, QUICK.replaceAll('200', '60').replace('5000', '3000'), `+${seconds}000000 type memory\\r\n+${seconds + 2}000000 quit`);
  return execFileSync('sh', ['tests/emu/bench_qemu.sh', build, board, stim], { encoding: 'latin1', timeout: 900e3 });
}

// Instructions a facet: interrupts and all, but no ink and no motion.
function counted() {
  console.log('\nQEMU: instructions per facet for evaluating, projecting and hiding (as often as the board does so at a time)\n');
  console.log('| board | surface | n | instructions a facet |\n|---|---|--:|--:|');
  for (const [board, shape, n] of [['nrf51', 'smooth', 60], ['nrf51', 'random', 32], ['nrf51', 'random', 60]]) {
    const said = execFileSync('sh', ['tests/emu/bench_count.sh', build, board, stimulus(shape, n, '')], { encoding: 'utf8', timeout: 300e3 });
    console.log(`| ${board} | ${shape} | ${n} | ${Math.round(Number(said) / (n - 1) ** 2).toLocaleString('en')} |`);
  }
}

// Large scenes, computed and drawn to the end on the Pico. What is typed ahead is answered after the drawing.
function large(shape, n) {
  const text = join(tmp, 'pico.txt'), begun = Date.now();
  const stim = stimulus(shape, n, QUICK, '+2000000 type memory\\r');
  const run = spawnSync('node', ['tests/emu/rp2040.mjs', `${build}/firmware/rp2040.bin`, stim, join(tmp, 'large.vcd'), text, '1'],
    { env: { ...process.env, EMU_MODULES: `${build}/emu`, QUIET_MS: '300', STILL_S: '600' }, encoding: 'utf8', timeout: 4200e3 });
  if (run.status !== 0) throw new Error(`pico ${shape} ${n}: ${run.stderr}`);
  memory(`Pico, ${shape} ${n}x${n}, small paper, drawn to the end (${Math.round((Date.now() - begun) / 1000)} s of emulation)`,
    readFileSync(text, 'latin1'));
  console.log(spawnSync(`${build}/host/ridgeline`, ['trace', join(tmp, 'large.vcd')], { encoding: 'utf8' }).stdout
    .split('\n').filter((l) => /^ *(time|length|speed)/.test(l)).map((l) => `    ${l}`).join('\n'));
}

if (process.argv[3] === 'large') {
  for (const [shape, n] of (process.env.LARGE ?? 'smooth 1000,random 400').split(',').map((s) => s.split(' '))) large(shape, n);
  memory('Pico, random 60x60, A4, 100 mm/s, drawn to the end',
    pico('random', 60, 'quit', '', '+900000000 type memory\\r\n+900300000 quit').text);
  process.exit(0);
}

table();
expressions(60);
solids();
counted();
const r = pico('smooth', 60, 'quit', '', '+230000000 type memory\\r\n+230300000 quit');
memory('Pico, smooth 60x60, A4, 100 mm/s, drawn to the end', r.text);
polygons();
for (const [shape, n, seconds] of [['smooth', 60, 120], ['random', 32, 200], ['random', 60, 400]])
  memory(`micro:bit, ${shape} ${n}x${n}, drawn to the end on small paper`, qemu('nrf51', shape, n, seconds));
