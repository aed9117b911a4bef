import { crc32, deflateSync } from 'node:zlib';

type Rgba = readonly [number, number, number, number];

function chunk(name: string, content: Buffer): Buffer {
  const body = Buffer.concat([Buffer.from(name, 'latin1'), content]);
  const frame = Buffer.alloc(8);
  frame.writeUInt32BE(content.length, 0);
  frame.writeUInt32BE(crc32(body), 4);
  return Buffer.concat([frame.subarray(0, 4), body, frame.subarray(4)]);
}

/** Returns a PNG file with transparency, painted pixel by pixel. */
export function pngOf(width: number, height: number, paint: (x: number, y: number) => Rgba): Uint8Array<ArrayBuffer> {
  const rows = Array.from({ length: height }, (_, y) =>
    Buffer.from([0, ...Array.from({ length: width }, (_, x) => paint(x, y)).flat()]),
  );
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 6, 0, 0, 0], 8);
  return new Uint8Array(Buffer.concat([
    Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'),
    chunk('IHDR', head),
    chunk('IDAT', deflateSync(Buffer.concat(rows))),
    chunk('IEND', Buffer.alloc(0)),
  ]));
}

interface PhotoshopLayer {
  name: string;
  left: number;
  top: number;
  size: number;
  paint: (x: number, y: number) => Rgba;
}

function u32(...values: number[]): Buffer {
  const bytes = Buffer.alloc(4 * values.length);
  values.forEach((value, i) => bytes.writeInt32BE(value, 4 * i));
  return bytes;
}

function u16(...values: number[]): Buffer {
  const bytes = Buffer.alloc(2 * values.length);
  values.forEach((value, i) => bytes.writeInt16BE(value, 2 * i));
  return bytes;
}

/** Returns a Photoshop document of square layers, back to front, uncompressed. */
export function photoshopOf(width: number, height: number, layers: readonly PhotoshopLayer[]): Uint8Array<ArrayBuffer> {
  const channels = [-1, 0, 1, 2];
  const records = layers.map(({ name, left, top, size }) => {
    const text = Buffer.from(name, 'latin1');
    const pascal = Buffer.concat([Buffer.from([text.length]), text, Buffer.alloc((4 - ((text.length + 1) % 4)) % 4)]);
    const lengths = channels.map((id) => Buffer.concat([u16(id), u32(2 + size * size)]));
    return Buffer.concat([
      u32(top, left, top + size, left + size), u16(channels.length), ...lengths,
      Buffer.from('8BIMnorm', 'latin1'), Buffer.from([255, 0, 0, 0]), u32(8 + pascal.length, 0, 0), pascal,
    ]);
  });
  const pixels = layers.flatMap(({ size, paint }) =>
    channels.map((id) => {
      const plane = Array.from({ length: size * size }, (_, i) => paint(i % size, Math.floor(i / size))[id < 0 ? 3 : id] ?? 0);
      return Buffer.concat([u16(0), Buffer.from(plane)]);
    }),
  );
  const info = Buffer.concat([u16(layers.length), ...records, ...pixels]);
  const even = Buffer.concat([info, Buffer.alloc(info.length % 2)]);
  return new Uint8Array(Buffer.concat([
    Buffer.from('8BPS', 'latin1'), u16(1, 0, 0, 0, 3), u32(height, width), u16(8, 3), u32(0, 0),
    u32(even.length + 8, even.length), even, u32(0), u16(0), Buffer.alloc(3 * width * height, 255),
  ]));
}

/** Returns a picture of a disc on a transparent background. */
export function disc(size: number, radius: number, color: readonly [number, number, number]): Uint8Array<ArrayBuffer> {
  return pngOf(size, size, (x, y) => {
    const inside = radius - Math.hypot(x + 0.5 - size / 2, y + 0.5 - size / 2) + 0.5;
    return [...color, Math.round(255 * Math.min(1, Math.max(0, inside)))];
  });
}

export const openRingSize = [400, 320] as const;

/** Returns an ink drawing on white: a body, and beside it a smaller ring with a gap on the right. */
export function openRing(): Uint8Array<ArrayBuffer> {
  const ink = (x: number, y: number): boolean => {
    const body = Math.abs(Math.hypot(x - 140, y - 160) - 110) < 3;
    return body || (Math.abs(Math.hypot(x - 310, y - 160) - 60) < 3 && !(x > 310 && Math.abs(y - 160) < 11));
  };
  return pngOf(...openRingSize, (x, y) => (ink(x + 0.5, y + 0.5) ? [0, 0, 0, 255] : [255, 255, 255, 255]));
}
