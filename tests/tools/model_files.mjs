// Reads model files by itself, sharing nothing with the program, and says what is wrong with them.
// Usage: node model_files.mjs [--closed] FILE|FOLDER...   --closed: every edge has two faces
import { readFileSync, readdirSync, statSync } from "node:fs";
import { extname, join } from "node:path";
import { inflateRawSync } from "node:zlib";

const componentCount = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
const componentArray = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };

/** A mesh: flat coordinates, flat triangles, flat normals or none. */
const mesh = (positions, triangles, normals) => ({ positions, triangles, normals });

function readGlb(bytes) {
  const length = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.toString("utf8", 20, 20 + length));
  const binary = bytes.subarray(20 + length + 8);
  const accessor = (index) => {
    const { bufferView, byteOffset = 0, componentType, type, count } = json.accessors[index];
    const view = json.bufferViews[bufferView];
    const from = (view.byteOffset ?? 0) + byteOffset;
    const Kind = componentArray[componentType];
    const size = count * componentCount[type] * Kind.BYTES_PER_ELEMENT;
    return new Kind(Uint8Array.from(binary.subarray(from, from + size)).buffer);
  };
  return json.meshes.flatMap(({ primitives }) =>
    primitives.map(({ attributes, indices }) =>
      mesh(accessor(attributes.POSITION), accessor(indices), "NORMAL" in attributes ? accessor(attributes.NORMAL) : undefined)));
}

/** Vertices are shared by all objects, which may touch each other: each is a mesh of its own. */
function readObj(bytes) {
  const positions = [], normals = [], objects = [];
  for (const line of bytes.toString("utf8").split("\n")) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === "v") positions.push(rest.map(Number));
    if (word === "vn") normals.push(...rest.map(Number));
    if (word === "o") objects.push({ number: new Map(), corners: [] });
    if (word !== "f") continue;
    if (rest.length !== 3) throw new Error(`a face of ${rest.length} corners`);
    const { number, corners } = objects.at(-1);
    for (const corner of rest) {
      const [v, , n] = corner.split("/").map((text) => Number(text) - 1);
      if (!(n >= 0 && 3 * n < normals.length)) throw new Error("a normal that is not there");
      if (!number.has(v)) number.set(v, number.size);
      corners.push(number.get(v));
    }
  }
  const used = new Set(objects.flatMap(({ number }) => [...number.keys()]));
  if (used.size !== positions.length || [...used].some((v) => !(v in positions)))
    throw new Error("vertices that are in no face, or faces with vertices that are not there");
  return objects.map(({ number, corners }) =>
    mesh([...number.keys()].flatMap((v) => positions[v]), corners, normals));
}

function readPly(bytes) {
  const end = bytes.indexOf("end_header\n") + "end_header\n".length;
  const header = bytes.toString("latin1", 0, end);
  const vertices = Number(/element vertex (\d+)/.exec(header)[1]);
  const faces = Number(/element face (\d+)/.exec(header)[1]);
  const stride = 4 * header.match(/property float /g).length + (header.match(/property uchar /g) ?? []).length;
  const positions = [], normals = [], triangles = [];
  for (let v = 0, at = end; v < vertices; ++v, at += stride)
    for (let k = 0; k < 3; ++k) {
      positions.push(bytes.readFloatLE(at + 4 * k));
      normals.push(bytes.readFloatLE(at + 12 + 4 * k));
    }
  for (let f = 0, at = end + vertices * stride; f < faces; ++f, at += 13) {
    if (bytes[at] !== 3) throw new Error(`face ${f} has ${bytes[at]} corners`);
    for (let k = 0; k < 3; ++k) triangles.push(bytes.readUInt32LE(at + 1 + 4 * k));
  }
  return [mesh(positions, triangles, normals)];
}

/** STL has no indices: corners at one place are one vertex. */
function readStl(bytes) {
  const faces = bytes.readUInt32LE(80);
  if (bytes.length !== 84 + 50 * faces) throw new Error(`${bytes.length} bytes for ${faces} faces`);
  const number = new Map(), positions = [], triangles = [], normals = [];
  for (let f = 0; f < faces; ++f) {
    const at = 84 + 50 * f;
    for (let k = 0; k < 3; ++k) normals.push(bytes.readFloatLE(at + 4 * k));
    for (let corner = 1; corner <= 3; ++corner) {
      const point = [0, 1, 2].map((k) => bytes.readFloatLE(at + 12 * corner + 4 * k));
      const key = point.join();
      if (!number.has(key)) {
        number.set(key, positions.length / 3);
        positions.push(...point);
      }
      triangles.push(number.get(key));
    }
  }
  return [mesh(positions, triangles, normals)];
}

/** The entry of a zip archive whose name ends so. */
function unzipped(bytes, ending) {
  let at = bytes.readUInt32LE(bytes.lastIndexOf("PK\x05\x06", undefined, "latin1") + 16);
  while (bytes.readUInt32LE(at) === 0x02014b50) {
    const [nameLength, extraLength, noteLength] = [28, 30, 32].map((k) => bytes.readUInt16LE(at + k));
    if (bytes.toString("utf8", at + 46, at + 46 + nameLength).endsWith(ending)) {
      const local = bytes.readUInt32LE(at + 42);
      const from = local + 30 + bytes.readUInt16LE(local + 26) + bytes.readUInt16LE(local + 28);
      const packed = bytes.subarray(from, from + bytes.readUInt32LE(at + 20));
      return bytes.readUInt16LE(at + 10) === 0 ? packed : inflateRawSync(packed);
    }
    at += 46 + nameLength + extraLength + noteLength;
  }
  throw new Error(`no entry ${ending}`);
}

function readThreemf(bytes) {
  const numbers = (text, pattern) => [...text.matchAll(pattern)].flatMap((found) => found.slice(1, 4).map(Number));
  const text = unzipped(bytes, ".model").toString("utf8");
  return [...text.matchAll(/<mesh>.*?<\/mesh>/gs)].map(([one]) =>
    mesh(numbers(one, /<vertex x="([^"]*)" y="([^"]*)" z="([^"]*)"/g),
      numbers(one, /<triangle v1="(\d+)" v2="(\d+)" v3="(\d+)"/g)));
}

const readers = { ".glb": readGlb, ".obj": readObj, ".ply": readPly, ".stl": readStl, ".3mf": readThreemf };

/** How often each edge is run along, by "lower,higher": [forwards, backwards]. */
function edgesOf(triangles) {
  const edges = new Map();
  for (let f = 0; f < triangles.length; f += 3)
    for (let k = 0; k < 3; ++k) {
      const a = triangles[f + k], b = triangles[f + ((k + 1) % 3)];
      const key = a < b ? `${a},${b}` : `${b},${a}`;
      if (!edges.has(key)) edges.set(key, [0, 0]);
      ++edges.get(key)[a < b ? 0 : 1];
    }
  return edges;
}

/** What is wrong with a mesh, in words; "" where nothing is. */
function meshDefect({ positions, triangles, normals }, closed) {
  const count = positions.length / 3;
  if (triangles.length === 0) return "no triangles";
  if (!positions.every(Number.isFinite)) return "a coordinate that is no number";
  const used = new Uint8Array(count);
  const faces = new Set();
  for (let f = 0; f < triangles.length; f += 3) {
    const corners = [triangles[f], triangles[f + 1], triangles[f + 2]];
    if (corners.some((v) => !(v >= 0 && v < count))) return `face ${f / 3}: a vertex that is not there`;
    if (new Set(corners).size < 3) return `face ${f / 3}: a vertex twice`;
    for (const v of corners) used[v] = 1;
    const key = [...corners].sort((a, b) => a - b).join();
    if (faces.has(key)) return `face ${f / 3}: twice`;
    faces.add(key);
  }
  if (used.includes(0)) return `vertex ${used.indexOf(0)}: in no face`;
  for (let n = 0; normals && n < normals.length; n += 3)
    if (!(Math.abs(Math.hypot(normals[n], normals[n + 1], normals[n + 2]) - 1) < 1e-3))
      return `normal ${n / 3}: not of length 1`;
  for (const [edge, [forwards, backwards]] of edgesOf(triangles)) {
    if (forwards > 1 || backwards > 1) return `edge ${edge}: run along ${forwards} and ${backwards} times`;
    if (closed && forwards + backwards !== 2) return `edge ${edge}: only one face`;
  }
  return "";
}

/** What is wrong with a model file; "" where nothing is. */
export function modelDefect(file, closed = false) {
  const read = readers[extname(file)];
  if (!read) return "not a kind that is known here";
  try {
    const meshes = read(readFileSync(file));
    if (meshes.length === 0) return "no meshes";
    return meshes.map((one) => meshDefect(one, closed)).find((defect) => defect !== "") ?? "";
  } catch (error) {
    return `cannot be read: ${error.message}`;
  }
}

const filesIn = (path) =>
  statSync(path).isDirectory() ? readdirSync(path).map((name) => join(path, name)).filter((file) => extname(file) in readers) : [path];

if (process.argv[1]?.endsWith("/model_files.mjs")) {
  const words = process.argv.slice(2);
  const closed = words[0] === "--closed";
  const files = words.slice(closed ? 1 : 0).flatMap(filesIn);
  let faults = files.length === 0 ? 1 : 0;
  for (const file of files) {
    const defect = modelDefect(file, closed);
    if (defect === "") continue;
    console.log(`${file}: ${defect}`);
    ++faults;
  }
  console.log(`${files.length} models, ${faults} with defects`);
  process.exit(faults === 0 ? 0 : 1);
}
