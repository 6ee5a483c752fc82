// A run as an animation: frames are fetched in pieces while it plays.

import {request} from '../api';
import {kinds, steps_of_numbers} from '../colours';
import {h} from '../dom';
import {show, t} from '../words';
import {type Frame, unpack_frames} from './frames';
import {ParticlePainter, type Window} from './particle_painter';

const frames_a_second = 20;
/** of particles, in one request: some 6 MB */
const particles_a_piece = 1_000_000;

type Field = 'plastic_strain' | 'speed' | 'material';

/** What the last colour stands for: strain beyond 2 looks no different, speed as fast as it was. */
function most_of(field: Field, frames: Map<number, Frame>): number {
  if (field === 'plastic_strain') return 2;
  let most = 0;
  for (const frame of frames.values()) most = Math.max(most, frame.head.value[1]);
  return most || 1;
}

/** Fetches frames, a piece ahead of what is shown. */
class Reel {
  readonly frames = new Map<number, Frame>();
  times_s: number[] = [];
  materials: string[] = [];
  private count = 4;
  private readonly asked = new Map<number, Promise<void>>();

  constructor(private readonly address: string, readonly field: Field) {}

  /** The frame, once it is there. @throws Problem */
  async frame(i: number): Promise<Frame | undefined> {
    if (!this.frames.has(i)) {
      if (!this.asked.has(i)) this.asked.set(i, this.fetch(i));
      await this.asked.get(i)!.finally(() => this.asked.delete(i));
    }
    return this.frames.get(i);
  }

  ahead(i: number): void {
    const next = i + this.count;
    for (let at = i; at < Math.min(next, this.times_s.length); ++at) {
      if (!this.frames.has(at) && this.asked.size === 0) {
        void this.frame(at).catch(() => undefined);
        return;
      }
    }
  }

  private async fetch(first: number): Promise<void> {
    const path = `${this.address}/frames?field=${this.field}&first=${first}&count=${this.count}`;
    const answer = await request(path, {headers: {Accept: 'application/octet-stream'}});
    const {head, frames} = unpack_frames(await answer.arrayBuffer());
    this.times_s = head.times_s;
    this.materials = head.materials;
    frames.forEach((frame, i) => this.frames.set(first + i, frame));
    const particles = Math.max(head.particles[0] ?? 1, 1);
    this.count = Math.min(Math.max(Math.floor(particles_a_piece / particles), 1), 60);
  }
}

function colour_key(reel: Reel, most: number): HTMLElement {
  if (reel.field === 'material') {
    return h('ul', {class: 'key'}, reel.materials.map((name, i) =>
      h('li', {}, swatch(kinds[i % kinds.length]!), name)));
  }
  const colours = ['#e8e2d0', ...steps_of_numbers.slice(1)];
  return h('ul', {class: 'key'}, colours.map((colour, i) =>
    h('li', {}, swatch(colour), show((most * i) / (colours.length - 1), 2) + (i === colours.length - 1 ? ' +' : ''))));
}

export function swatch(colour: string, dashed = false): HTMLElement {
  const box = h('span', {class: dashed ? 'swatch dashed' : 'swatch', 'aria-hidden': 'true'});
  box.style.backgroundColor = dashed ? 'transparent' : colour;
  box.style.borderColor = colour;
  return box;
}

/** The player of one section. @param address of the section, "jobs/ID/sections/NAME" */
export function animation(address: string, window_of_section: Window): HTMLElement {
  let reel = new Reel(address, 'plastic_strain');
  let at = 0;
  let playing = false;
  let painter: ParticlePainter | null = null;

  const canvas = h('canvas', {class: 'particles', role: 'img', 'aria-label': t('animation')});
  const slider = h('input', {type: 'range', min: 0, max: 0, value: 0, 'aria-label': t('frame'),
    oninput: () => void go(Number(slider.value))});
  const clock = h('output', {class: 'clock'});
  const button = h('button', {type: 'button', onclick: () => (playing ? stop() : play())}, t('play'));
  const note = h('p', {class: 'note', hidden: true});
  const key = h('div');
  const field = h('select', {onchange: () => change(field.value as Field)},
    (['plastic_strain', 'speed', 'material'] as const).map((name) => h('option', {value: name}, t(name))));

  const start_painting = () => {
    if (painter || canvas.clientWidth === 0) return;
    canvas.width = Math.round(canvas.clientWidth * Math.min(devicePixelRatio, 2));
    canvas.height = Math.round(canvas.clientHeight * Math.min(devicePixelRatio, 2));
    painter = new ParticlePainter(canvas, window_of_section);
  };
  const go = async (i: number): Promise<boolean> => {
    try {
      const frame = await reel.frame(i);
      start_painting();
      if (!frame || !painter) return false;
      at = i;
      const most = most_of(reel.field, reel.frames);
      painter.paint(frame, most);
      slider.max = String(reel.times_s.length - 1);
      slider.value = String(at);
      clock.textContent = t('time', {time: show(reel.times_s[at])});
      canvas.dataset.frame = String(at);
      key.replaceChildren(colour_key(reel, most));
      note.hidden = reel.times_s.length > 2;
      note.textContent = t('anim_two');
      reel.ahead(at + 1);
      return true;
    } catch {
      note.hidden = false;
      note.textContent = t('anim_none');
      return false;
    }
  };
  const stop = () => {
    playing = false;
    button.textContent = t('play');
  };
  const play = async () => {
    playing = true;
    button.textContent = t('pause');
    if (at >= reel.times_s.length - 1) at = -1;
    while (playing && canvas.isConnected) {
      const due = performance.now() + 1000 / frames_a_second;
      if (at + 1 >= reel.times_s.length || !(await go(at + 1))) break;
      await new Promise((done) => setTimeout(done, Math.max(due - performance.now(), 0)));
    }
    stop();
  };
  const change = (wanted: Field) => {
    reel = new Reel(address, wanted);
    void go(Math.max(at, 0));
  };

  const whole = h('div', {class: 'animation'},
    h('div', {class: 'row'}, button, slider, clock, h('label', {}, t('anim_field'), ' ', field)), canvas, key, note);
  // The canvas gets its size when it is laid out.
  new ResizeObserver((_, observer) => {
    if (canvas.clientWidth === 0) return;
    observer.disconnect();
    void go(0);
  }).observe(canvas);
  return whole;
}
