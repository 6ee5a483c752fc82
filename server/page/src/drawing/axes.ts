// Scales and ticks of a drawing.

export interface Scale {
  (value: number): number;
  from: number;
  to: number;
}

export function scale(from: number, to: number, start: number, end: number): Scale {
  const span = to - from || 1;
  return Object.assign((value: number) => start + ((value - from) / span) * (end - start), {from, to});
}

/** Round numbers between two values, about `count` of them. */
export function ticks(from: number, to: number, count: number): number[] {
  const raw = (to - from) / Math.max(count, 1);
  if (!(raw > 0) || !Number.isFinite(raw)) return [];
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((n) => n * power).find((n) => n >= raw)!;
  const list: number[] = [];
  for (let i = Math.ceil(from / step); i * step <= to + step * 1e-9; ++i) list.push(i * step + 0);
  return list;
}

/** The elevation of a polyline at x; null outside. */
export function height_at(line: readonly (readonly [number, number])[], x: number): number | null {
  for (let i = 1; i < line.length; ++i) {
    const [x0, z0] = line[i - 1]!;
    const [x1, z1] = line[i]!;
    if (x >= x0 && x <= x1) return x1 === x0 ? z1 : z0 + ((z1 - z0) * (x - x0)) / (x1 - x0);
  }
  return null;
}

/** The point of a map line at a share of its length. */
export function point_along(line: readonly (readonly [number, number])[], share: number): [number, number] {
  const lengths = line.slice(1).map(([x, y], i) => Math.hypot(x - line[i]![0], y - line[i]![1]));
  let left = Math.min(Math.max(share, 0), 1) * lengths.reduce((a, b) => a + b, 0);
  for (let i = 0; i < lengths.length; ++i) {
    if (left <= lengths[i]! || i === lengths.length - 1) {
      const part = lengths[i] ? left / lengths[i]! : 0;
      const [x0, y0] = line[i]!;
      const [x1, y1] = line[i + 1]!;
      return [x0 + (x1 - x0) * part, y0 + (y1 - y0) * part];
    }
    left -= lengths[i]!;
  }
  return [line[0]![0], line[0]![1]];
}
