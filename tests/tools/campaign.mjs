// Tries to break the program. Ends with 1 where it did; prints a table of what happened.
// Usage: node campaign.mjs outputs PROGRAM DRAWING...    all kinds of models of drawings, read by our own readers
//        node campaign.mjs kills PROGRAM DRAWING [N]     N kills and interrupts at random times (200)
//        node campaign.mjs memory PROGRAM DRAWING [N]    N limits of memory from 40 MB to 2 GB (40)
//        node campaign.mjs mutations PROGRAM DRAWING [N] N damaged models through `render` (200)
import { spawn } from "node:child_process";
import { copyFileSync, existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, extname, join, resolve } from "node:path";
import { modelDefect } from "./model_files.mjs";

const [campaign, programName, ...words] = process.argv.slice(2);
const program = resolve(programName ?? "");
const folder = mkdtempSync(join(tmpdir(), "relievo-campaign-"));
const table = new Map();
let faults = 0;

const count = (row) => table.set(row, (table.get(row) ?? 0) + 1);

function fault(what) {
  ++faults;
  console.log(`FAULT ${what}`);
}

/** Numbers in [0, 1) that are the same in every run (mulberry32). */
function randomNumbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let x = Math.imul(state ^ (state >>> 15), state | 1);
    x ^= x + Math.imul(x ^ (x >>> 7), x | 61);
    return ((x ^ (x >>> 14)) >>> 0) / 4294967296;
  };
}

/** Runs the program; `after` may send it a signal. Resolves to its exit, its words and how long it took. */
function run(args, { limitKb = 0, signal = "", after = 0, seconds = 120 } = {}) {
  const begun = performance.now();
  const child = limitKb > 0
    ? spawn("/bin/sh", ["-c", `ulimit -v ${limitKb}; exec "$@"`, "sh", program, ...args], { cwd: folder })
    : spawn(program, args, { cwd: folder });
  let text = "", sent = 0;
  child.stderr.on("data", (data) => (text += data));
  child.stdout.resume();
  const shot = signal === "" ? undefined : setTimeout(() => ((sent = performance.now()), child.kill(signal)), after);
  const hang = setTimeout(() => child.kill("SIGABRT"), 1000 * seconds);
  return new Promise((done) =>
    child.on("close", (code, by) => {
      clearTimeout(shot);
      clearTimeout(hang);
      const now = performance.now();
      done({ code, by, text, took: now - begun, answered: sent > 0 ? now - sent : 0 });
    }));
}

const bytesOf = (name) => readFileSync(join(folder, name), "latin1");
const lastLine = (text) => text.trim().split("\n").pop();

/** Whether the exit is one that is promised: not a defect, not a crash. */
function sound({ code, by, text }, what, codes = [0, 3, 4, 5]) {
  if (by === null && codes.includes(code)) return true;
  fault(`${what}: ${by ?? `exit ${code}`}: ${lastLine(text)}`);
  return false;
}

const kinds = [
  ["relief", [], ["glb", "obj", "ply", "stl"], []],
  ["nonlinear", ["--method", "nonlinear"], ["glb", "obj", "ply", "stl"], []],
  ["visible relief", ["--visible", "relief"], ["glb", "obj", "ply", "stl"], []],
  ["visible all", ["--visible", "all"], ["glb", "obj", "ply"], []],
  ["solid", ["--profile", "solid"], ["glb"], ["stl", "3mf"]],
  ["figure", ["--profile", "figure"], ["glb"], ["stl", "3mf"]],
];

async function outputs(drawings) {
  for (const drawing of drawings)
    for (const [kind, options, open, closed] of kinds) {
      const names = [...open, ...closed].map((ending) => `m.${ending}`);
      const result = await run(["build", resolve(drawing), "-q", "--vertices", "4000", ...options, ...names.flatMap((name) => ["-o", name])]);
      const what = `${basename(drawing)} ${kind}`;
      if (!sound(result, what)) continue;
      count(`${kind}: exit ${result.code}`);
      for (const name of result.code === 0 ? names : []) {
        const defect = modelDefect(join(folder, name), closed.includes(extname(name).slice(1)));
        if (defect !== "") fault(`${what}: ${name}: ${defect}`);
        count(`${kind}: ${name}${defect === "" ? "" : " unsound"}`);
        rmSync(join(folder, name));
      }
    }
}

/** Commands that write, and what they write. */
const writers = (drawing) => [
  [["build", drawing, "-q", "-o", "a.glb", "-o", "a.stl", "--depth-map", "a.png", "--vertices", "20000"], ["a.glb", "a.stl", "a.png"]],
  [["segment", "flat.png", "-q", "-o", "b.relievo"], ["b.relievo"]],
  [["check", drawing, "-q", "-o", "c.json", "--overlay", "c-overlay.png"], ["c.json", "c-overlay.png"]],
  [["render", drawing, "-q", "-o", "d.png", "--size", "300", "--vertices", "20000"], ["d.png"]],
];

async function prepare(drawing) {
  const local = `drawing${extname(drawing)}`;
  copyFileSync(drawing, join(folder, local));
  const made = await run(["render", local, "-q", "-o", "flat.png", "--size", "400", "--vertices", "4000"]);
  if (made.code !== 0) throw new Error(made.text);
  return local;
}

async function kills([drawing, times = "200"]) {
  const random = randomNumbers(1);
  const jobs = [];
  for (const [args, files] of writers(await prepare(drawing))) {
    const { code, text, took } = await run(args);
    if (code !== 0) throw new Error(text);
    jobs.push({ args, files, took, fresh: files.map(bytesOf) });
  }
  const names = readdirSync(folder).sort().join();
  let longest = 0;
  const answers = [];
  for (let k = 0; k < Number(times); ++k) {
    const { args, files, took, fresh } = jobs[k % jobs.length];
    const signal = ["SIGKILL", "SIGINT", "SIGTERM"][Math.floor(3 * random())];
    for (const name of files) writeFileSync(join(folder, name), "earlier");
    const result = await run(args, { signal, after: took * 1.1 * random() });
    const what = `${args[0]} ${signal} ${k}`;
    const state = files.map((name, i) => (bytesOf(name) === fresh[i] ? "new" : bytesOf(name) === "earlier" ? "earlier" : "broken"));
    if (state.includes("broken")) fault(`${what}: a file is half-written`);
    const ended = result.by ?? `exit ${result.code}`;
    count(`${args[0]} ${signal}: ${ended}`);
    if (signal === "SIGKILL") {
      for (const name of readdirSync(folder)) if (!names.split(",").includes(name)) rmSync(join(folder, name), { recursive: true });
      continue;
    }
    if (readdirSync(folder).sort().join() !== names) fault(`${what}: left ${readdirSync(folder)}`);
    // Until it has said what a signal means, the system ends it.
    if (result.by === null && ![0, 130].includes(result.code)) fault(`${what}: ${ended}: ${lastLine(result.text)}`);
    if (state.some((one) => one !== (result.code === 0 ? "new" : "earlier"))) fault(`${what}: ${ended} but files are ${state}`);
    if (result.code === 130) answers.push(result.answered);
    if (result.code === 130) longest = Math.max(longest, result.answered);
  }
  const slow = answers.filter((ms) => ms > 100).length;
  console.log(`${answers.length} interrupts answered, ${slow} after more than 100 ms, the longest after ${longest.toFixed(0)} ms`);
}

async function memory([drawing, steps = "40"]) {
  const jobs = writers(await prepare(drawing));
  for (let k = 0; k < Number(steps); ++k) {
    const megabytes = Math.round(40 * (2048 / 40) ** (k / Math.max(1, Number(steps) - 1)));
    for (const [args, files] of jobs) {
      for (const name of files) rmSync(join(folder, name), { force: true });
      const names = readdirSync(folder).sort().join();
      const result = await run(args, { limitKb: 1024 * megabytes });
      // 127: the loader found no room for the shared libraries.
      if (!sound(result, `${args[0]} in ${megabytes} MB`, [0, 5, 127])) continue;
      count(`${args[0]}: exit ${result.code}`);
      if (result.code !== 0 && readdirSync(folder).sort().join() !== names) fault(`${args[0]} in ${megabytes} MB left files`);
      if (result.code === 0 && !files.every((name) => existsSync(join(folder, name)))) fault(`${args[0]} in ${megabytes} MB wrote not all`);
    }
  }
}

/** Bytes, with some of them changed, taken out, or numbers of its JSON replaced by hostile ones. */
function mutated(bytes, random) {
  const pick = (n) => Math.floor(n * random());
  const way = pick(4);
  const copy = Buffer.from(bytes);
  if (way === 0) for (let k = pick(20) + 1; k > 0; --k) copy[pick(copy.length)] = pick(256);
  if (way === 1) return copy.subarray(0, pick(copy.length));
  if (way === 2) for (let k = pick(8) + 1; k > 0; --k) copy.writeFloatLE([1e19, -1e30, NaN, Infinity, 1e-40][pick(5)], pick((copy.length - 4) / 4) * 4);
  if (way === 3) {
    const length = copy.readUInt32LE(12);
    const hostile = ["-1", "4294967295", "99999999", "1e9", "null", "0"];
    const numbers = [...copy.toString("latin1", 20, 20 + length).matchAll(/\d+/g)];
    const { index, 0: text } = numbers[pick(numbers.length)];
    copy.write(hostile[pick(hostile.length)].slice(0, text.length).padEnd(text.length), 20 + index, "latin1");
  }
  return copy;
}

async function mutations([drawing, times = "200"]) {
  const made = await run(["build", resolve(drawing), "-q", "-o", "sound.glb", "--vertices", "1000"]);
  if (made.code !== 0) throw new Error(made.text);
  const bytes = readFileSync(join(folder, "sound.glb"));
  const random = randomNumbers(2);
  for (let k = 0; k < Number(times); ++k) {
    writeFileSync(join(folder, "m.glb"), mutated(bytes, random));
    const result = await run(["render", "m.glb", "-q", "-o", "m.png", "--size", "48"], { seconds: 20 });
    if (!sound(result, `mutation ${k}`, [0, 3, 5])) copyFileSync(join(folder, "m.glb"), join(tmpdir(), `relievo-mutation-${k}.glb`));
    count(`render: exit ${result.code}`);
  }
}

const campaigns = { outputs, kills, memory, mutations };
if (!(campaign in campaigns) || words.length === 0) {
  console.error("usage: node campaign.mjs outputs|kills|memory|mutations PROGRAM DRAWING... [N]");
  process.exit(2);
}
try {
  await campaigns[campaign](words);
} finally {
  rmSync(folder, { recursive: true, force: true });
}
for (const [row, times] of [...table].sort()) console.log(`${String(times).padStart(6)}  ${row}`);
console.log(`${faults} faults`);
process.exit(faults === 0 ? 0 : 1);
