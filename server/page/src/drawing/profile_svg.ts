// A section from the side: ground before and after, layers, and the points that its numbers are between.

import {s} from '../dom';
import {kinds} from '../colours';
import type {XY} from '../types';
import {show, t} from '../words';
import {height_at, scale, ticks} from './axes';

export interface Layer {
  name: string;
  /** from left to right */
  bottom: XY[];
}

export interface Side {
  before: XY[];
  after?: XY[] | null;
  crest?: XY | null;
  toe?: XY | null;
  backscarp?: XY | null;
  front?: XY | null;
  layers?: Layer[];
}

export interface Frame {
  width: number;
  height: number;
  /** what of the section to show; absent: all of it */
  x?: [number, number];
  z?: [number, number];
}

/** Called with the distance to which crest or toe was brought. */
export type Drag = (which: 'crest' | 'toe', x: number, done: boolean) => void;

const margin = {left: 48, right: 14, top: 22, bottom: 34};

/** Distances and elevations that hold all sides. */
export function extent_of(sides: readonly Side[]): {x: [number, number]; z: [number, number]} {
  const points = sides.flatMap((side) => [...side.before, ...(side.after ?? [])]);
  const bottoms = sides.flatMap((side) => side.layers?.flatMap((layer) => layer.bottom) ?? []);
  const xs = points.map((p) => p[0]);
  const zs = [...points, ...bottoms].map((p) => p[1]);
  const room = Math.max((Math.max(...zs) - Math.min(...zs)) * 0.08, 0.5);
  return {x: [Math.min(...xs), Math.max(...xs)], z: [Math.min(...zs) - room, Math.max(...zs) + room]};
}

export function profile_svg(side: Side, frame: Frame, drag?: Drag): SVGSVGElement {
  const extent = extent_of([side]);
  const [x0, x1] = frame.x ?? extent.x;
  const [z0, z1] = frame.z ?? extent.z;
  const {width, height} = frame;
  const x = scale(x0, x1, margin.left, width - margin.right);
  const z = scale(z0, z1, height - margin.bottom, margin.top);
  const path = (line: readonly XY[]) =>
    line.map(([px, pz], i) => `${i ? 'L' : 'M'}${x(px).toFixed(1)} ${z(pz).toFixed(1)}`).join('');
  const down = (line: readonly XY[]) =>
    line.length ? `${path(line)}L${x(line[line.length - 1]![0]).toFixed(1)} ${z(z0)}L${x(line[0]![0]).toFixed(1)} ${z(z0)}Z` : '';

  const svg = s('svg', {
    class: 'profile', viewBox: `0 0 ${width} ${height}`, width, height, role: drag ? 'group' : 'img',
      'aria-label': t('profile'),
    'font-family': 'system-ui, sans-serif', 'font-size': 11,
  });
  grid(svg, frame, {x, z});
  svg.append(...layers_of(side, path, down, {x, z, z0}));
  if (side.after) {
    svg.append(s('path', {d: down(side.after), fill: '#d8a45c', 'fill-opacity': 0.35}));
    svg.append(s('path', {d: path(side.after), fill: 'none', stroke: '#b4511b', 'stroke-width': 2.2}));
  }
  svg.append(s('path', {
    d: path(side.before), fill: 'none', stroke: '#22363d', 'stroke-width': 1.8,
    'stroke-dasharray': side.after ? '6 4' : 'none',
  }));
  marks(svg, side, {x, z}, drag);
  const per_z = (height - margin.top - margin.bottom) / (z1 - z0);
  const stretched = per_z / ((width - margin.left - margin.right) / (x1 - x0));
  svg.append(s('text', {x: width - margin.right, y: 13, 'text-anchor': 'end', fill: '#4a5a60'},
    t('stretched', {factor: show(stretched, stretched < 10 ? 1 : 0)})));
  if (side.after) key(svg);
  return svg;
}

type Scales = {x: ReturnType<typeof scale>; z: ReturnType<typeof scale>};

function grid(svg: SVGSVGElement, {width, height}: Frame, {x, z}: Scales): void {
  const grey = {stroke: '#d5dde0', 'stroke-width': 1};
  for (const value of ticks(z.from, z.to, height / 45)) {
    svg.append(s('line', {x1: margin.left, x2: width - margin.right, y1: z(value), y2: z(value), ...grey}),
      s('text', {x: margin.left - 6, y: z(value) + 4, 'text-anchor': 'end', fill: '#33444a'}, show(value)));
  }
  for (const value of ticks(x.from, x.to, width / 90)) {
    svg.append(s('line', {x1: x(value), x2: x(value), y1: margin.top, y2: height - margin.bottom, ...grey}),
      s('text', {x: x(value), y: height - margin.bottom + 14, 'text-anchor': 'middle', fill: '#33444a'}, show(value)));
  }
  svg.append(
    s('text', {x: 4, y: 13, fill: '#4a5a60'}, t('elevation_axis')),
    s('text', {x: width - margin.right, y: height - 5, 'text-anchor': 'end', fill: '#4a5a60'}, t('distance_axis')));
}

/** From the deepest up, each over what lies below it; names at the left edge where there is room. */
function layers_of(side: Side, path: (line: readonly XY[]) => string, down: (line: readonly XY[]) => string,
                   {x, z, z0}: Scales & {z0: number}): SVGElement[] {
  const ground = side.before;
  if (!side.layers?.length) {
    return [s('path', {d: down(ground), fill: '#c9bfae', 'fill-opacity': side.after ? 0.35 : 0.7})];
  }
  const drawn: SVGElement[] = [];
  const tops = [ground, ...side.layers.map((layer) => layer.bottom)];
  side.layers.forEach((layer, i) => {
    drawn.push(s('path', {d: down(tops[i]!), fill: kinds[i % kinds.length]!, 'fill-opacity': 0.55}));
    if (i > 0) drawn.push(s('path', {d: path(tops[i]!), fill: 'none', stroke: '#5b5b5b', 'stroke-width': 0.8}));
    const at = x.from + (x.to - x.from) * 0.04;
    const top = height_at(tops[i]!, at) ?? z0;
    const bottom = Math.max(height_at(layer.bottom, at) ?? z0, z0);
    if (z(bottom) - z(top) > 12) {
      drawn.push(s('text', {x: x(at), y: (z(top) + z(bottom)) / 2 + 4, fill: '#1b1b1b'}, layer.name));
    }
  });
  return drawn;
}

function marks(svg: SVGSVGElement, side: Side, {x, z}: Scales, drag: Drag | undefined): void {
  const mark = (point: XY | null | undefined, word: 'crest' | 'toe' | 'backscarp' | 'front', colour: string,
    below: boolean) => {
    if (!point) return;
    const cx = x(point[0]);
    const cy = z(point[1]);
    const handle = s('circle', {cx, cy, r: 5, fill: colour, stroke: '#ffffff', 'stroke-width': 1.5});
    const named = s('text', {
      x: cx, y: cy + (below ? 18 : -10), 'text-anchor': 'middle', fill: '#111111', stroke: '#ffffff',
      'stroke-width': 3, 'paint-order': 'stroke',
    }, t(word));
    svg.append(handle, named);
    if (drag && (word === 'crest' || word === 'toe')) draggable(svg, handle, named, side.before, {x, z}, word, drag);
  };
  mark(side.backscarp, 'backscarp', '#a43a00', false);
  mark(side.front, 'front', '#005a8e', true);
  mark(side.crest, 'crest', '#22363d', false);
  mark(side.toe, 'toe', '#22363d', true);
}

function draggable(svg: SVGSVGElement, handle: SVGCircleElement, named: SVGTextElement, ground: readonly XY[],
                   {x, z}: Scales, which: 'crest' | 'toe', drag: Drag): void {
  let at = 0;
  const put = (value: number, done: boolean) => {
    at = Math.min(Math.max(value, x.from), x.to);
    const height = height_at(ground, at);
    if (height !== null) {
      handle.setAttribute('cx', String(x(at)));
      handle.setAttribute('cy', String(z(height)));
      named.setAttribute('x', String(x(at)));
    }
    drag(which, at, done);
  };
  const value_at = (event: PointerEvent) => {
    const box = svg.getBoundingClientRect();
    const px = ((event.clientX - box.left) / box.width) * svg.viewBox.baseVal.width;
    return x.from + ((px - margin.left) / (svg.viewBox.baseVal.width - margin.left - margin.right)) * (x.to - x.from);
  };
  handle.setAttribute('class', 'handle');
  handle.setAttribute('r', '8');
  handle.setAttribute('tabindex', '0');
  handle.setAttribute('role', 'slider');
  handle.setAttribute('aria-label', t(which));
  const share = (Number(handle.getAttribute('cx')) - x(x.from)) / (x(x.to) - x(x.from));
  at = x.from + share * (x.to - x.from);
  handle.setAttribute('aria-valuenow', at.toFixed(1));
  handle.addEventListener('pointerdown', (event) => {
    handle.setPointerCapture(event.pointerId);
    const move = (e: PointerEvent) => put(value_at(e), false);
    handle.addEventListener('pointermove', move);
    handle.addEventListener('pointerup', () => {
      handle.removeEventListener('pointermove', move);
      drag(which, at, true);
    }, {once: true});
  });
  handle.addEventListener('keydown', (event) => {
    const step = event.shiftKey ? 10 : 1;
    if (event.key === 'ArrowLeft') put(at - step, true);
    else if (event.key === 'ArrowRight') put(at + step, true);
    else return;
    event.preventDefault();
  });
}

function key(svg: SVGSVGElement): void {
  const from = margin.left + 70;
  svg.append(
    s('line', {x1: from, x2: from + 22, y1: 9, y2: 9, stroke: '#22363d', 'stroke-width': 1.8,
      'stroke-dasharray': '6 4'}),
    s('text', {x: from + 27, y: 13, fill: '#33444a'}, t('before')),
    s('line', {x1: from + 75, x2: from + 97, y1: 9, y2: 9, stroke: '#b4511b', 'stroke-width': 2.2}),
    s('text', {x: from + 102, y: 13, fill: '#33444a'}, t('after')));
}
