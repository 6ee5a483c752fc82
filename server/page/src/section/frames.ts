// Frames of a run as the server packs them: a head as JSON, then 16 bits a number.

export interface Head {
  field: string;
  unit: string;
  first: number;
  times_s: number[];
  materials: string[];
  particles: number[];
  x_m: [number, number];
  z_m: [number, number];
  value: [number, number];
}

/** One frame; numbers are `least + (most - least) * packed / 65535` of the head's ranges. */
export interface Frame {
  head: Head;
  x: Uint16Array;
  z: Uint16Array;
  value: Uint16Array;
}

/** @throws Error where the bytes end too early */
export function unpack_frames(bytes: ArrayBuffer): {head: Head; frames: Frame[]} {
  const view = new DataView(bytes);
  const head_bytes = view.getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, head_bytes))) as Head;
  let at = 4 + head_bytes;
  const column = (count: number) => {
    if (at + 2 * count > bytes.byteLength) throw new Error('the frames end too early');
    const values = new Uint16Array(bytes, at, count);
    at += 2 * count;
    return values;
  };
  const frames = head.particles.map((count) => ({head, x: column(count), z: column(count), value: column(count)}));
  return {head, frames};
}

/** The number that stands packed in a frame. */
export function unpacked(packed: number, [least, most]: readonly [number, number]): number {
  return least + ((most - least) * packed) / 65535;
}

/** Distance between neighbours: particles stand in the order of their seeding. */
export function spacing_of(frame: Frame): number {
  const steps: number[] = [];
  for (let i = 1; i < Math.min(frame.x.length, 2000); ++i) {
    const dx = Math.abs(unpacked(frame.x[i]!, frame.head.x_m) - unpacked(frame.x[i - 1]!, frame.head.x_m));
    const dz = Math.abs(unpacked(frame.z[i]!, frame.head.z_m) - unpacked(frame.z[i - 1]!, frame.head.z_m));
    const step = Math.hypot(dx, dz);
    if (step > 0) steps.push(step);
  }
  steps.sort((a, b) => a - b);
  return steps[Math.floor(steps.length / 4)] ?? 1;
}
