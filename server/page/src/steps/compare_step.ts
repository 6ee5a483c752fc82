// Two sections side by side, at one scale, with their differences; their curves in one drawing where both have an
// ensemble.

import {ensemble_of, section_address} from '../actions';
import {blob, get} from '../api';
import {fill, h, save} from '../dom';
import {exceedance_figure} from '../drawing/exceedance_plot';
import {extent_of, profile_svg} from '../drawing/profile_svg';
import {condition_words, distance_words, distances, has_ensemble, percent, quantile_difference} from '../ensemble/numbers';
import {bounded, difference_words} from '../section/bounds';
import {side_of} from '../section/panel';
import {on, state} from '../state';
import type {Ensemble, Job, JobMap, SectionDetail} from '../types';
import {show, t} from '../words';
import {Report, button} from './parts';

interface Chosen {
  job: string;
  section: SectionDetail;
  ensemble: Ensemble | null;
}

interface Choice {
  element: HTMLElement;
  chosen: () => Promise<Chosen | null>;
  offer: () => Promise<void>;
}

function chooser(label: string, at: number, changed: () => void): Choice {
  const jobs = h('select', {'aria-label': `${label}: ${t('job')}`, onchange: () => void load()});
  const sections = h('select', {'aria-label': `${label}: ${t('section')}`, onchange: () => changed()});
  let has_curves = false;
  const load = async () => {
    const kept = sections.value;
    const map = !jobs.value ? null : jobs.value === state.job?.job ? state.job
      : await get<JobMap>(`jobs/${jobs.value}/map`);
    const names = map?.sections.name ?? [];
    has_curves = has_ensemble(map);
    fill(sections, names.map((name) => h('option', {value: name}, name)));
    sections.value = names.includes(kept) ? kept : (names[Math.min(at, names.length - 1)] ?? '');
    changed();
  };
  const offer = async () => {
    const kept = jobs.value;
    const list = state.jobs.filter((job: Job) => job.processID !== 'resolution-study');
    fill(jobs, list.map((job) => h('option', {value: job.jobID},
      `${job.name || job.processID}, ${new Date(job.created).toLocaleString()}`)));
    jobs.value = list.some(({jobID}) => jobID === kept) ? kept : (state.job?.job ?? list[0]?.jobID ?? '');
    await load();
  };
  const chosen = async (): Promise<Chosen | null> => {
    const [job, name] = [jobs.value, sections.value];
    if (!job || !name) return null;
    const [section, ensemble] = await Promise.all([get<SectionDetail>(section_address(job, name)),
      has_curves ? ensemble_of(job, name) : null]);
    return {job, section, ensemble};
  };
  return {element: h('fieldset', {}, h('legend', {}, label), h('div', {class: 'columns two'}, jobs, sections)), chosen,
    offer};
}

function difference_table(a: SectionDetail, b: SectionDetail): HTMLElement {
  const row = (name: string, of: (one: SectionDetail) => number | null, is: (one: SectionDetail) => string | null,
    unit: string) => {
    const [x, y] = [of(a), of(b)];
    return h('tr', {}, h('th', {scope: 'row'}, name), h('td', {class: 'number'}, bounded(x, is(a), unit)),
      h('td', {class: 'number'}, bounded(y, is(b), unit)),
      h('td', {class: 'number'}, difference_words({value: x, is: is(a)}, {value: y, is: is(b)}, unit)));
  };
  const measured = () => null;
  return h('table', {}, h('thead', {}, h('tr', {}, h('td', {}), [a.name, b.name, t('difference')].map((name) => h('th',
    {scope: 'col'}, name)))),
    h('tbody', {},
      row(t('retrogression'), (one) => one.crest_to_crest_retrogression_m, (one) => one.retrogression_is, 'm'),
      row(t('runout'), (one) => one.runout_m, (one) => one.runout_is, 'm'),
      row(t('from_crest'), (one) => one.runout_from_crest_m, (one) => one.runout_is, 'm'),
      row(t('slides'), (one) => one.slides, measured, ''),
      row(t('simulated'), (one) => one.simulated_s, measured, 's'),
      row(t('run_time'), (one) => one.run_time_s, measured, 's')));
}

/** What each probability exceeds in the two, and how much farther the second one goes. */
function curve_table(a: Ensemble, b: Ensemble): HTMLElement {
  const rows = distances.flatMap((of) => a[of].quantiles.map((from) => {
    const to = b[of].quantiles.find(({exceedance}) => exceedance === from.exceedance);
    const more = quantile_difference(from, to);
    return h('tr', {}, h('th', {scope: 'row'}, `${t(of)}, ${percent(from.exceedance)}`),
      h('td', {class: 'number'}, distance_words(from)), h('td', {class: 'number'}, to ? distance_words(to) : '–'),
      h('td', {class: 'number'}, more === null ? '–' : `${more > 0 ? '+' : ''}${show(more)} m`));
  }));
  const [p, q] = [a.probability_of_sliding.value, b.probability_of_sliding.value];
  return h('table', {class: 'curve-numbers'}, h('caption', {}, t('exceeded')), h('thead', {}, h('tr', {}, h('td', {}),
    [a.section, b.section, t('difference')].map((name) => h('th', {scope: 'col'}, name)))),
    h('tbody', {}, h('tr', {}, h('th', {scope: 'row'}, t('sliding')), h('td', {class: 'number'}, percent(p)),
      h('td', {class: 'number'}, percent(q)), h('td', {class: 'number'}, `${q > p ? '+' : ''}${percent(q - p)}`)), rows));
}

/** The server draws the curves of sections of one job. */
function curves_file([a, b]: readonly [Chosen, Chosen], report: Report): HTMLElement | null {
  if (a.job !== b.job || a.section.name === b.section.name) return null;
  const names = [a, b].map(({section}) => encodeURIComponent(section.name)).join(',');
  return button('download_curves', () => void blob(`jobs/${a.job}/compare?sections=${names}&f=svg&of=curves`).then(
    (file) => save(file, `${a.section.name}-${b.section.name}-curves.svg`), (error) => report.problem(error)));
}

/** @param stage where the two profiles are drawn, over the map */
export function compare_step(stage: HTMLElement): HTMLElement {
  const report = new Report();
  const table = h('div');
  let shown: [Chosen, Chosen] | null = null;

  const draw = () => {
    if (!shown || stage.hidden) return;
    const sides = shown.map(({section}) => side_of(section));
    const {x, z} = extent_of(sides);
    const narrow = stage.clientWidth < 700;
    const width = Math.max(narrow ? stage.clientWidth - 24 : stage.clientWidth / 2 - 24, 260);
    const height = Math.max(narrow ? stage.clientHeight / 2 - 60 : Math.min(stage.clientHeight - 60, width * 0.75),
      180);
    fill(stage, shown.map(({section}, i) => h('figure', {}, h('figcaption', {}, h('strong', {}, section.name)),
      profile_svg(sides[i]!, {width, height, x, z}) as unknown as HTMLElement)), curves());
  };
  const curves = () => {
    const ensembles = shown!.flatMap(({ensemble}) => ensemble ?? []);
    if (ensembles.length < 2) return null;
    return h('div', {class: 'curves-of-two'}, h('p', {class: 'condition'}, condition_words(ensembles[0]!.condition)),
      h('div', {class: 'distances'}, distances.map((of) => exceedance_figure(ensembles, of))));
  };
  const changed = async () => {
    try {
      const [a, b] = await Promise.all([first.chosen(), second.chosen()]);
      if (!a || !b) {
        report.say(t('compare_need'));
        return;
      }
      report.say('');
      shown = [a, b];
      fill(table, difference_table(a.section, b.section),
        a.ensemble && b.ensemble ? curve_table(a.ensemble, b.ensemble) : null,
        a.ensemble && b.ensemble ? curves_file(shown, report) : null);
      draw();
    } catch (error) {
      report.problem(error);
    }
  };
  const first = chooser(t('first'), 0, () => void changed());
  const second = chooser(t('second'), 1, () => void changed());
  new ResizeObserver(draw).observe(stage);
  on('step', () => {
    stage.hidden = state.step !== 'compare';
    if (!stage.hidden) void Promise.all([first.offer(), second.offer()]).catch((error) => report.problem(error));
  });
  return h('section', {}, h('h2', {}, t('step_compare')), h('p', {}, t('compare_intro')), first.element, second.element,
    report.element, table);
}
