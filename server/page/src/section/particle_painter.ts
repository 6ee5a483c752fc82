// Particles onto a canvas: pixels are set one by one, which a hundred thousand of them need.

import {kinds, steps_of_numbers} from '../colours';
import {type Frame, spacing_of} from './frames';

const opaque = 0xff000000;

/** "#rrggbb" as a pixel of ImageData read as little-endian 32 bits. */
function pixel(colour: string): number {
  const rgb = parseInt(colour.slice(1), 16);
  return (opaque | ((rgb & 0xff) << 16) | (rgb & 0xff00) | (rgb >> 16)) >>> 0;
}

/** 256 colours from the first to the last, straight between. */
function ramp(colours: readonly string[]): Uint32Array {
  const list = new Uint32Array(256);
  for (let i = 0; i < 256; ++i) {
    const at = (i / 255) * (colours.length - 1);
    const low = Math.min(Math.floor(at), colours.length - 2);
    const a = parseInt(colours[low]!.slice(1), 16);
    const b = parseInt(colours[low + 1]!.slice(1), 16);
    const mix = (shift: number) => {
      const from = (a >> shift) & 0xff;
      return Math.round(from + (((b >> shift) & 0xff) - from) * (at - low));
    };
    list[i] = (opaque | (mix(0) << 16) | (mix(8) << 8) | mix(16)) >>> 0;
  }
  return list;
}

const of_numbers = ramp(['#e8e2d0', ...steps_of_numbers.slice(1)]);
const of_kinds = Uint32Array.from(kinds, pixel);

export interface Window {
  x: [number, number];
  z: [number, number];
}

export class ParticlePainter {
  private image: ImageData;
  private pixels: Uint32Array;

  constructor(private readonly canvas: HTMLCanvasElement, private readonly window: Window) {
    this.image = new ImageData(canvas.width, canvas.height);
    this.pixels = new Uint32Array(this.image.data.buffer);
  }

  /** @param most the value of the last colour; for materials the colours are counted */
  paint(frame: Frame, most: number): void {
    const {width, height} = this.canvas;
    const {x, z} = this.window;
    this.pixels.fill(0);
    const per_x = width / (x[1] - x[0]);
    const per_z = height / (z[1] - z[0]);
    const {x_m, z_m, value} = frame.head;
    const sx = ((x_m[1] - x_m[0]) / 65535) * per_x;
    const ox = (x_m[0] - x[0]) * per_x;
    const sz = ((z_m[1] - z_m[0]) / 65535) * per_z;
    const oz = (z_m[0] - z[0]) * per_z;
    const spacing = spacing_of(frame);
    const wide = Math.max(1, Math.ceil(spacing * per_x));
    const high = Math.max(1, Math.ceil(spacing * per_z));
    const counted = frame.head.field === 'material';
    const colours = counted ? of_kinds : of_numbers;
    const sv = (value[1] - value[0]) / 65535;
    for (let i = 0; i < frame.x.length; ++i) {
      const number = value[0] + frame.value[i]! * sv;
      const colour = counted
        ? colours[Math.round(number) % colours.length]!
        : colours[Math.min(255, Math.max(0, Math.round((number / most) * 255)))]!;
      const left = Math.round(frame.x[i]! * sx + ox - wide / 2);
      const top = Math.round(height - (frame.z[i]! * sz + oz) - high / 2);
      for (let row = Math.max(top, 0); row < Math.min(top + high, height); ++row) {
        for (let at = Math.max(left, 0); at < Math.min(left + wide,
          width); ++at) this.pixels[row * width + at] = colour;
      }
    }
    this.canvas.getContext('2d')!.putImageData(this.image, 0, 0);
  }
}
