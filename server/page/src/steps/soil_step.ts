// Soil: a form from the published schema, presets, the layers on a profile, the curve as it is typed.

import {get} from '../api';
import {draft_of, model_pointer, preset, preset_names, request_of} from '../draft';
import {fill, h, later, save} from '../dom';
import {plot} from '../drawing/curve_plot';
import {profile_svg} from '../drawing/profile_svg';
import {layers_on} from '../drawing/soil_layers';
import {paths_to_numbers} from '../form/paths';
import {SchemaForm} from '../form/schema_form';
import {type Schema, Schemas} from '../form/schema';
import {mark_faults} from '../form/faults';
import type {Drawn, MapView} from '../map/map_view';
import {last_strain, softening_curve, strength} from '../softening';
import {on, state, tell} from '../state';
import type {Json, JsonObject, XY} from '../types';
import {show, t} from '../words';
import {Report, button, field} from './parts';

/** Members of the request that other steps hold. */
const elsewhere = ['name', 'dem', 'sections', 'soil', 'dryRun'];

interface Process {
  inputs: Record<string, {schema: Schema; minOccurs: number}>;
  definitions: Record<string, Schema>;
}

let schema: Promise<Schema> | null = null;

function region_schema(): Promise<Schema> {
  schema ??= get<Process>('processes/map-region').then(schema_of);
  schema.catch(() => (schema = null));
  return schema;
}

/** The inputs of a process as one schema, with the definitions that they refer to. */
export function schema_of(process: Process): Schema {
  const inputs = Object.entries(process.inputs);
  return {
    type: 'object',
    properties: Object.fromEntries(inputs.map(([name, input]) => [name, input.schema])),
    required: inputs.filter(([, input]) => input.minOccurs > 0).map(([name]) => name),
    definitions: process.definitions,
  };
}

export function regions_of(): Drawn[] {
  return state.draft.models.flatMap((model, m) => model.where.map((points, i): Drawn =>
    ({id: `region-${m}-${i}`, kind: 'region', name: model.name, points})));
}

export function soil_step(map: MapView): HTMLElement {
  const report = new Report();
  const form_box = h('div');
  const pictures = h('div', {class: 'pictures'});
  const hint = h('p', {class: 'note', role: 'status'});

  const draw_pictures = later(150, () => show_pictures(pictures));
  const changed = () => {
    tell('draft');
    draw_pictures();
  };

  const choice = h('select', {'aria-label': t('preset')}, preset_names.map((name, i) => h('option', {value: i}, name)));
  const take_preset = () => {
    const {soil, trigger} = preset(Number(choice.value));
    const model = state.draft.models[0]!;
    model.soil = soil;
    model.name = preset_names[Number(choice.value)]!;
    state.draft.settings.trigger = trigger;
    changed();
    void rebuild();
  };

  const rebuild = async () => {
    let published: Schema;
    try {
      published = await region_schema();
    } catch (error) {
      return report.problem(error);
    }
    const schemas = new Schemas(published);
    fill(form_box,
      ...state.draft.models.map((_, i) => model_form(schemas, i)),
      button('model_add', () => {
        const first = state.draft.models[0]!;
        state.draft.models.unshift({name: `${t('soil_model')} ${state.draft.models.length + 1}`, where: [],
          soil: JSON.parse(JSON.stringify(first.soil)) as JsonObject});
        changed();
        void rebuild();
      }),
      h('h3', {}, t('settings')), settings_form(schemas),
      h('h3', {}, t('ensemble')), h('p', {}, t('ensemble_intro')), ensemble_form(schemas));
    mark_faults(form_box, state.faults);
    draw_pictures();
  };

  const settings_form = (schemas: Schemas) => {
    const names = Object.keys(schemas.resolve(schemas.whole).properties ?? {}).filter((name) => name !== 'ensemble' &&
      !elsewhere.includes(name));
    const form = new SchemaForm(schemas, changed);
    return form.members(schemas.whole, state.draft.settings, '/inputs', names);
  };

  /** Which numbers are uncertain; paths lead into the request as it stands. */
  const ensemble_form = (schemas: Schemas) => {
    const form = new SchemaForm(schemas, changed, undefined, (member) =>
      (member === 'path' ? paths_to_numbers(request_of(state.draft).inputs) : []));
    const box = form.members(schemas.whole, state.draft.settings, '/inputs', ['ensemble']);
    // Faults of other settings are not said here.
    box.dataset.pointer = '/inputs/ensemble';
    return box;
  };

  const model_form = (schemas: Schemas, i: number): HTMLElement => {
    const model = state.draft.models[i]!;
    const pointer = model_pointer(state.draft, i);
    const form = new SchemaForm(schemas, changed, (member) =>
      (member === 'material' ? Object.keys((model.soil.materials ?? {}) as JsonObject) : null));
    const body = form.members({$ref: '#/definitions/soil_model'}, model.soil, pointer);
    // A material that is renamed or added is to be chosen in the layers.
    body.addEventListener('change', (event) => {
      if ((event.target as Element).closest('.material > .field')) void rebuild();
    });
    const name = h('input', {type: 'text', value: model.name, maxlength: 100, oninput: () => {
      model.name = name.value;
      changed();
    }});
    const many = state.draft.models.length > 1;
    return h('fieldset', {class: 'model'}, h('legend', {}, `${t('soil_model')}${many ? ` ${i + 1}` : ''}`),
      many || model.where.length > 0 ? field(t('name'), name, `${pointer}/name`) : null,
      h('div', {class: 'row', 'data-pointer': `${pointer}/where`},
        h('span', {class: 'quiet'}, model.where.length > 0 ? t('region_count', {count: model.where.length}) : many
          ? t('everywhere') : ''),
        many ? button('region_draw', () => draw_region(i)) : null,
        model.where.length > 0 ? button('region_clear', () => {
          model.where = [];
          changed();
          void rebuild();
        }) : null,
        many ? h('button', {type: 'button', class: 'small', 'aria-label': `${t('remove')} ${i + 1}`, onclick: () => {
          state.draft.models.splice(i, 1);
          changed();
          void rebuild();
        }}, '×') : null),
      body);
  };

  const draw_region = (i: number) => {
    if (!state.raster) return report.say(t('need_dem'), true);
    hint.textContent = t('draw_hint_region');
    map.draw('region', (points) => {
      hint.textContent = '';
      state.draft.models[i]!.where.push(points.map(([x, y]): XY => [Math.round(x * 100) / 100,
        Math.round(y * 100) / 100]));
      changed();
      void rebuild();
    });
  };

  const open = h('input', {type: 'file', accept: '.json,application/json', class: 'file', onchange: async () => {
    const file = open.files?.[0];
    open.value = '';
    if (!file) return;
    try {
      state.draft = draft_of(JSON.parse(await file.text()) as Json);
      report.say('');
    } catch (error) {
      return report.say(t('import_bad', {why: (error as Error).message}), true);
    }
    state.faults = [];
    tell('faults');
    tell('sections');
    tell('draft');
    void rebuild();
  }});
  const export_it = () => save(new Blob([JSON.stringify(request_of(state.draft), null, 2)], {type: 'application/json'}),
    `${state.draft.name || 'region'}.json`);

  on('faults', () => mark_faults(form_box, state.faults));
  on('laid', draw_pictures);
  on('step', () => {
    if (state.step === 'soil' && form_box.childElementCount === 0) void rebuild();
  });
  on('back', () => {
    if (form_box.childElementCount === 0) void rebuild();
  });
  return h('section', {}, h('h2', {}, t('step_soil')), h('p', {}, t('soil_intro')),
    h('div', {class: 'row'}, h('label', {}, t('preset'), ' ', choice), button('preset_apply', take_preset)),
    h('p', {class: 'quiet'}, t('preset_asked')),
    h('div', {class: 'row'}, h('label', {class: 'button'}, t('import'), open), button('export', export_it)),
    report.element, hint, pictures, form_box);
}

function show_pictures(target: HTMLElement): void {
  target.replaceChildren();
  const model = state.draft.models[0]!;
  const laid = state.laid.find(({name}) => name === state.looked_at) ?? state.laid[0];
  if (laid?.profile && laid.toe_m) {
    const svg = profile_svg({before: laid.profile, crest: laid.crest_m, toe: laid.toe_m,
      layers: layers_on(laid.profile, laid.toe_m[1], model.soil)}, {width: 360, height: 200});
    target.append(h('figure', {}, svg as unknown as HTMLElement, h('figcaption', {}, t('layers_on_profile',
      {name: laid.name}))));
  }
  const cell = (state.draft.settings.resolution as JsonObject | undefined)?.cell_m;
  for (const [name, material] of Object.entries((model.soil.materials ?? {}) as Record<string, JsonObject>)) {
    if (material.softening) target.append(curve_of(name, material, typeof cell === 'number' ? cell : undefined));
  }
}

/** Materials whose curve is unfolded: it stays so while numbers are typed. */
const open_curves = new Set<string>();

function curve_of(name: string, material: JsonObject, cell_m: number | undefined): HTMLElement {
  const law = material.softening as JsonObject;
  const peak = typeof material.peak_strength_kPa === 'number' ? material.peak_strength_kPa
    : first_row(material.peak_strength_kPa);
  const measured = softening_curve(law, peak);
  const box = h('div', {class: 'curve'});
  const figure = h('details', {open: open_curves.has(name)}, h('summary', {onclick: () => {
    if (figure.open) open_curves.delete(name);
    else open_curves.add(name);
  }}, t('curve', {material: name})), box);
  if (!measured) {
    box.append(h('p', {class: 'quiet'}, t('curve_missing')));
    return figure;
  }
  const scaled = cell_m === undefined ? null : softening_curve(law, peak, cell_m);
  figure.addEventListener('toggle', () => {
    if (!figure.open) return;
    const last = last_strain(measured);
    // Close together at the start, where the strength falls.
    const x = Array.from({length: 200}, (_, i) => last * (i / 199) ** 3);
    plot(box, x, t('curve_x'), t('curve_y'), [
      {label: t('curve_measured'), colour: '#d55e00', values: x.map((strain) => strength(measured, strain))},
      ...(scaled ? [{label: t('curve_cell', {cell: show(cell_m, 2)}), colour: '#0072b2', dash: [6, 4],
        values: x.map((strain) => strength(scaled, strain))}] : []),
    ]);
  });
  return figure;
}

/** Strength at the first row of a table over depth or elevation. */
function first_row(value: Json | undefined): number {
  const table = Object.values((value ?? {}) as Record<string, [number, number][]>)[0];
  return table?.[0]?.[1] ?? NaN;
}
