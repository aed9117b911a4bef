import { crc32, deflateSync } from 'node:zlib';

type Rgba = readonly [number, number, number, number];

function chunk(name: string, content: Buffer): Buffer {
  const body = Buffer.concat([Buffer.from(name, 'latin1'), content]);
  const frame = Buffer.alloc(8);
  frame.writeUInt32BE(content.length, 0);
  frame.writeUInt32BE(crc32(body), 4);
  return Buffer.concat([frame.subarray(0, 4), body, frame.subarray(4)]);
}

/** A PNG file with transparency, painted pixel by pixel. */
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

/** A disc on a transparent ground. */
export function disc(size: number, radius: number, color: readonly [number, number, number]): Uint8Array<ArrayBuffer> {
  return pngOf(size, size, (x, y) => {
    const inside = radius - Math.hypot(x + 0.5 - size / 2, y + 0.5 - size / 2) + 0.5;
    return [...color, Math.round(255 * Math.min(1, Math.max(0, inside)))];
  });
}

export const openRingSize = [400, 320] as const;

/** Ink on white: a body, and beside it a smaller ring that has a gap to the right. */
export function openRing(): Uint8Array<ArrayBuffer> {
  const ink = (x: number, y: number): boolean => {
    const body = Math.abs(Math.hypot(x - 140, y - 160) - 110) < 3;
    return body || (Math.abs(Math.hypot(x - 310, y - 160) - 60) < 3 && !(x > 310 && Math.abs(y - 160) < 11));
  };
  return pngOf(...openRingSize, (x, y) => (ink(x + 0.5, y + 0.5) ? [0, 0, 0, 255] : [255, 255, 255, 255]));
}
