// The frame of the page: steps, the map with its legend, what the pointer is over.

import {go, lies_on_map} from './actions';
import {forget_token, get} from './api';
import {type ColourBy, colour_sections, probability_colour} from './colours';
import {fill, h, later} from './dom';
import {percent} from './ensemble/numbers';
import type {LayerName, MapView} from './map/map_view';
import {swatch} from './section/animation';
import {type Step, on, state, step_of, steps} from './state';
import type {JobMap, XY} from './types';
import {type Word, show, speak, spoken, t} from './words';

export function step_word(step: Step): string {
  return t(`step_${step}` as Word);
}

/** The steps in their order; a number says how many faults stand in one. */
export function step_list(): HTMLElement {
  const buttons = steps.map((step, i) => h('button', {type: 'button', 'data-step': step, onclick: () => go(step)},
    h('span', {class: 'count', 'aria-hidden': 'true'}, i + 1), ' ', step_word(step), h('span', {class: 'faults'})));
  const show_now = () => buttons.forEach((button, i) => {
    const here = steps[i] === state.step;
    button.setAttribute('aria-current', here ? 'step' : 'false');
    const faults = state.faults.filter(({pointer}) => step_of(pointer) === steps[i]).length;
    button.querySelector('.faults')!.textContent = faults > 0 ? ` ${faults}` : '';
  });
  on(['step', 'faults'], show_now);
  show_now();
  return h('nav', {'aria-label': t('menu')}, buttons);
}

export function language_button(): HTMLElement {
  const other = spoken() === 'en' ? 'fr' : 'en';
  return h('button', {type: 'button', lang: other, onclick: () => {
    speak(other);
    location.reload();
  }}, t('language'));
}

export function token_button(): HTMLElement {
  return h('button', {type: 'button', id: 'forget-token', hidden: sessionStorage.getItem('leda-token') === null,
    onclick: () => {
    forget_token();
    location.reload();
  }}, t('forget_token'));
}

/** Probabilities of which a job has zones of a kind, rising. */
function exceedances_of(job: JobMap, kind: 'release' | 'runout'): number[] {
  const all = job.probability_zones.filter((zone) => zone.kind === kind).map(({exceedance}) => exceedance);
  return [...new Set(all)].sort((a, b) => a - b);
}

function probability_key(job: JobMap, kind: 'release' | 'runout'): HTMLElement {
  return h('ul', {class: 'probabilities'}, exceedances_of(job, kind).map((exceedance) =>
    h('li', {}, swatch(probability_colour(kind, exceedance)), t('goes_beyond', {percent: percent(exceedance)}))));
}

/** Switches of the layers, and what the colours of the sections mean. */
export function legend(map: MapView, colour: {by: ColourBy}): {element: HTMLElement; draw: () => void} {
  const layer_names: readonly (readonly [LayerName, Word, string | null])[] = [
    ['sections', 'layer_sections', null], ['release', 'layer_release', '#e9ad85'],
    ['runout', 'layer_runout', '#99c6e0'], ['release_probability', 'layer_release_probability', null],
    ['runout_probability', 'layer_runout_probability', null], ['hillshade', 'layer_hillshade', null],
  ];
  const outlines: Partial<Record<LayerName, string>> = {release: '#a84300', runout: '#005a8e'};
  const off = new Set<LayerName>();
  const body = h('div');
  const element = h('details', {class: 'legend', open: true}, h('summary', {}, t('legend')), body);
  const draw = () => {
    const {job, step} = state;
    const shows_job = job !== null && lies_on_map(job) && ['look', 'compare', 'take'].includes(step);
    const has: Record<LayerName, boolean> = {
      hillshade: state.raster !== null, sections: shows_job, release: shows_job && job.release_zones.length > 0,
      runout: shows_job && job.runout_zones.length > 0,
      release_probability: shows_job && exceedances_of(job, 'release').length > 0,
      runout_probability: shows_job && exceedances_of(job, 'runout').length > 0,
    };
    const coloured = shows_job && job.sections.name.length > 0 ? colour_sections(job, colour.by) : null;
    element.hidden = !Object.values(has).some(Boolean);
    fill(body,
      layer_names.filter(([name]) => has[name]).map(([name, word, tint]) => {
        const box = h('input', {type: 'checkbox', onchange: () => {
          if (box.checked) off.delete(name);
          else off.add(name);
          map.set_visible(name, box.checked);
        }});
        box.checked = !off.has(name);
        const outlined = tint !== null && job !== null && job.probability_zones.length > 0;
        const layer = h('label', {class: 'layer'}, box,
          tint ? swatch(outlined ? outlines[name]! : tint, outlined) : null, t(word), outlined ? ` (${t('as_given')})` : null);
        return job && (name === 'release_probability' || name === 'runout_probability')
          ? h('div', {}, layer, probability_key(job, name === 'release_probability' ? 'release' : 'runout')) : layer;
      }),
      has.release_probability || has.runout_probability ? h('p', {class: 'condition'}, t('condition')) : null,
      coloured ? h('div', {class: 'colours'}, h('strong', {}, coloured.title),
        coloured.entries.map(({colour: tint, label, dashed}) => h('div', {}, swatch(tint, dashed), label))) : null);
  };
  on(['step', 'raster', 'job'], draw);
  draw();
  return {element, draw};
}

/** Coordinates and ground under the pointer. */
export function readout(map: MapView): HTMLElement {
  const place = h('span');
  const ground = h('span');
  const box = h('div', {class: 'readout', hidden: true}, place, ground);
  const ask = later(120, async (at: XY) => {
    const {raster} = state;
    if (!raster) return;
    const [west, south, east, north] = raster.bbox;
    if (at[0] < west || at[0] > east || at[1] < south || at[1] > north) {
      ground.textContent = t('outside');
      return;
    }
    const answer = await get<{elevation_m: number | null}>(`rasters/${raster.id}/elevation?at=${at[0]},${at[1]}`).catch(
      () => null);
    ground.textContent = !answer ? '' : answer.elevation_m === null ? t('no_data_here')
      : `${t('elevation')} ${show(answer.elevation_m, 2)} m`;
  });
  map.on_pointer = (at, degrees) => {
    box.hidden = at === null;
    if (!at) return;
    const geographic = degrees ? ` (${degrees[1]!.toFixed(5)}°, ${degrees[0]!.toFixed(5)}°)` : '';
    place.textContent = `${at[0].toFixed(1)} ${at[1].toFixed(1)}${geographic}`;
    ask(at);
  };
  return box;
}

/** Asks for a token, above everything else. */
export function ask_for_token(refused: boolean): Promise<string> {
  return new Promise((done) => {
    const input = h('input', {type: 'password', id: 'token', autocomplete: 'off', required: true,
      'aria-describedby': 'token-why'});
    const dialog = h('dialog', {class: 'token', 'aria-labelledby': 'token-title',
      oncancel: (event: Event) => event.preventDefault()},
      h('form', {onsubmit: (event: Event) => {
        event.preventDefault();
        if (!input.value.trim()) return;
        dialog.close();
        dialog.remove();
        document.getElementById('forget-token')?.removeAttribute('hidden');
        done(input.value.trim());
      }},
      h('h2', {id: 'token-title'}, t('token_title')), h('p', {id: 'token-why'}, t('token_why')),
      refused ? h('p', {class: 'fault', role: 'alert'}, t('token_refused')) : null,
      h('div', {class: 'field'}, h('label', {for: 'token'}, t('token')), h('span', {class: 'input'}, input)),
      h('button', {type: 'submit', class: 'primary'}, t('enter'))));
    document.body.append(dialog);
    dialog.showModal();
    input.focus();
  });
}

/** Says that the server is away, and looks for it until it is back. */
export function connection_banner(back: () => void): {element: HTMLElement; tell: (there: boolean) => void} {
  const element = h('div', {class: 'banner', role: 'alert', hidden: true});
  let there = true;
  const look = () => setTimeout(() => {
    fetch(new URL('healthz', document.baseURI)).then((answer) => (answer.ok ? tell(true) : look()), look);
  }, 2000);
  const tell = (now: boolean) => {
    if (now === there) return;
    there = now;
    element.hidden = now;
    element.textContent = now ? '' : t('no_answer');
    if (now) back();
    else look();
  };
  return {element, tell};
}
