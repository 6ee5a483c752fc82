// Draw: lines that sections are laid across, single sections, and the profile under each.

import {Problem, send} from '../api';
import {fill, h, later} from '../dom';
import type {Drawn, DrawKind, MapView} from '../map/map_view';
import {point_along} from '../drawing/axes';
import {profile_svg} from '../drawing/profile_svg';
import {on, settle, state, tell} from '../state';
import type {Json, JsonObject, LaidSection, XY} from '../types';
import {t} from '../words';
import {typed_number} from '../form/schema';
import {mark_faults} from '../form/faults';
import {Report, button, field, warnings} from './parts';

function is_along(section: JsonObject): boolean {
  return 'along' in section;
}

export function line_of(section: JsonObject): XY[] {
  return ((is_along(section) ? section.along : section.line) ?? []) as unknown as XY[];
}

export function drawn_of(sections: readonly JsonObject[]): Drawn[] {
  return sections.map((section, i): Drawn => ({
    id: `section-${i}`,
    kind: is_along(section) ? 'along' : 'section',
    name: String(section.name ?? ''),
    points: line_of(section),
  })).filter((drawn) => drawn.points.length > 1);
}

/** AA', BB', CC', ...: the first that is not taken. */
export function next_name(sections: readonly JsonObject[]): string {
  const taken = new Set(sections.map((section) => section.name));
  for (let i = 0; ; ++i) {
    const letter = String.fromCharCode(65 + (i % 26)).repeat(2 + Math.floor(i / 26));
    if (!taken.has(`${letter}'`)) return `${letter}'`;
  }
}

/** Points to the millimetre, as one writes and reads them. */
export function points_text(points: readonly XY[]): string {
  return points.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join('\n');
}

export function points_from(text: string): XY[] | null {
  const rows = text.trim().split('\n').map((row) => row.trim().split(/[\s;,]+/).map(Number));
  return rows.every((row) => row.length === 2 && row.every(Number.isFinite)) ? (rows as XY[]) : null;
}

const rounded = (points: XY[]): XY[] => points.map(([x, y]) => [Math.round(x * 100) / 100, Math.round(y * 100) / 100]);

export function draw_step(map: MapView): HTMLElement {
  const report = new Report();
  const hint = h('p', {class: 'note', role: 'status'});
  const list = h('div', {'data-pointer': '/inputs/sections'});
  const preview = h('div');

  const changed = () => tell('sections');
  const stop = () => {
    map.stop_drawing();
    hint.textContent = '';
    stop_button.hidden = true;
  };
  const stop_button = button('draw_stop', stop);
  stop_button.hidden = true;

  const start = (kind: DrawKind) => {
    if (!state.raster) return report.say(t('need_dem'), true);
    report.say('');
    hint.textContent = t(kind === 'along' ? 'draw_hint_along' : 'draw_hint_section');
    stop_button.hidden = false;
    map.draw(kind, (points) => {
      stop();
      const line = rounded(points) as Json;
      const name = next_name(state.draft.sections);
      state.draft.sections.push(kind === 'along'
        ? {along: line, spacing_m: 50, upslope_m: 200, downslope_m: 80} : {name, line});
      if (kind === 'section') state.looked_at = name;
      changed();
      rebuild();
    });
  };

  const rebuild = () => fill(list, state.draft.sections.length === 0 ? h('p', {class: 'quiet'}, t('draw_none'))
    : state.draft.sections.map((section, i) => item(section, i)));

  const item = (section: JsonObject, i: number): HTMLElement => {
    const along = is_along(section);
    const pointer = `/inputs/sections/${i}`;
    const number = (key: 'spacing_m' | 'upslope_m' | 'downslope_m') => {
      const input = h('input', {type: 'text', inputmode: 'decimal', value: section[key] ?? '', oninput: () => {
        section[key] = typed_number(input.value);
        changed();
      }});
      return field(t(key), input, `${pointer}/${key}`);
    };
    const name = h('input', {type: 'text', maxlength: 100, value: section.name ?? '', autocomplete: 'off',
      oninput: () => {
      if (state.looked_at === section.name) state.looked_at = name.value;
      section.name = name.value;
      changed();
    }});
    const points = h('textarea', {rows: 3, value: points_text(line_of(section)), spellcheck: 'false', oninput: () => {
      const typed = points_from(points.value);
      points.classList.toggle('odd', !typed);
      if (!typed) return;
      section[along ? 'along' : 'line'] = typed as Json;
      changed();
    }});
    const remove = h('button', {type: 'button', class: 'small', 'aria-label': `${t('remove')} ${i + 1}`,
      onclick: () => {
      state.draft.sections.splice(i, 1);
      changed();
      rebuild();
    }}, '×');
    return h('div', {class: 'card', 'data-pointer': pointer},
      h('div', {class: 'row'}, h('strong', {}, along ? t('line_along') : t('section'), ` ${i + 1}`), remove),
      along ? h('div', {class: 'columns'}, number('spacing_m'), number('upslope_m'), number('downslope_m'))
        : field(t('name'), name, `${pointer}/name`),
      h('details', {'data-pointer': `${pointer}/${along ? 'along' : 'line'}`}, h('summary', {}, t('points')), points));
  };

  map.on_drawn_change = ({id, kind, points}) => {
    if (kind === 'region') return;
    const section = state.draft.sections[Number(id.replace('section-', ''))];
    if (!section) return;
    section[is_along(section) ? 'along' : 'line'] = rounded(points) as Json;
    changed();
    rebuild();
  };

  const lay_out = later(250, async () => {
    const {sections} = state.draft;
    if (!state.raster || sections.length === 0) {
      state.laid = [];
      tell('laid');
      return;
    }
    try {
      const asked = JSON.stringify(sections);
      const body = {inputs: {sections}};
      const {sections: laid} = await send<{sections: LaidSection[]}>('POST', `rasters/${state.raster.id}/layout`, body);
      if (JSON.stringify(state.draft.sections) !== asked) return;
      state.laid = laid;
      mark_faults(list, []);
      report.say('');
    } catch (error) {
      state.laid = [];
      if (error instanceof Problem && error.faults.length > 0) {
        mark_faults(list, error.faults);
        report.say('');
      } else {
        report.problem(error);
      }
    }
    tell('laid');
  });

  on('sections', () => {
    settle('/inputs/sections');
    map.show_drawn(drawn_of(state.draft.sections));
    lay_out();
  });
  on('raster', lay_out);
  on('laid', () => show_preview(preview, map));
  on('draft', rebuild);
  rebuild();
  document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') stop();
  });
  return h('section', {}, h('h2', {}, t('step_draw')), h('p', {}, t('draw_intro')),
    h('div', {class: 'row'}, button('draw_along', () => start('along'), 'primary'), button('draw_section',
      () => start('section'), 'primary'), stop_button),
    hint, report.element, list, h('p', {class: 'quiet'}, t('draw_edit')), preview);
}

function named_section(name: string): JsonObject | undefined {
  return state.draft.sections.find((section) => !is_along(section) && section.name === name);
}

/** Marks on the map what is looked at here, and nothing while another step has the map. */
function mark(map: MapView, ...what: Parameters<MapView['choose']>): void {
  if (state.step === 'draw' || state.step === 'soil') map.choose(...what);
}

function show_preview(target: HTMLElement, map: MapView): void {
  const {laid} = state;
  map.show_laid(laid.filter(({name}) => !named_section(name)));
  if (laid.length === 0) {
    mark(map, null);
    return fill(target);
  }
  const out = laid.filter((section) => section.reason).length;
  const now = laid.find(({name}) => name === state.looked_at) ?? laid[0]!;
  state.looked_at = now.name;
  const pick = h('select', {value: now.name, 'aria-label': t('pick_section'), onchange: () => {
    state.looked_at = pick.value;
    tell('laid');
  }}, laid.map(({name}) => h('option', {value: name}, name)));
  fill(target,
    h('p', {}, h('strong', {}, t('laid', {count: laid.length})), out > 0 ? `, ${t('laid_left_out', {count: out})}`
      : ''),
    h('div', {class: 'row'}, h('label', {}, t('pick_section'), ' ', pick)), profile_of(now, map));
}

function profile_of(section: LaidSection, map: MapView): HTMLElement {
  const {profile, crest_m, toe_m} = section;
  if (!profile || !crest_m || !toe_m) {
    mark(map, section.trace);
    return h('p', {class: 'fault'}, section.reason ?? '');
  }
  const length = profile[profile.length - 1]![0];
  const on_map = (x: number) => point_along(section.trace, x / length);
  mark(map, section.trace, [{at: on_map(crest_m[0]), colour: '#22363d'}, {at: on_map(toe_m[0]), colour: '#0072b2'}]);
  const own = named_section(section.name);
  const set = own && ((which: 'crest' | 'toe', x: number, done: boolean) => {
    if (!done) return;
    own[which] = on_map(x).map((value) => Math.round(value * 1000) / 1000);
    tell('sections');
  });
  const corrected = own && (own.crest || own.toe);
  const reset = corrected ? button('reset_bank', () => {
    delete own.crest;
    delete own.toe;
    tell('sections');
  }) : null;
  const svg = profile_svg({before: profile, crest: crest_m, toe: toe_m}, {width: 360, height: 200}, set);
  return h('figure', {}, svg as unknown as HTMLElement, h('figcaption', {}, t('profile_of', {name: section.name}), '. ',
    own ? t('drag_hint') : t('drag_not')),
    reset, section.warnings?.length ? warnings(section.warnings) : null);
}
