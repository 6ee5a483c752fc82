// Two sections side by side, at one scale, with their differences.

import {section_address} from '../actions';
import {get} from '../api';
import {fill, h} from '../dom';
import {extent_of, profile_svg} from '../drawing/profile_svg';
import {bounded, side_of} from '../section/panel';
import {on, state} from '../state';
import type {Job, JobMap, SectionDetail} from '../types';
import {show, t} from '../words';
import {Report} from './parts';

interface Choice {
  element: HTMLElement;
  section: () => Promise<SectionDetail | null>;
  offer: () => Promise<void>;
}

function chooser(label: string, at: number, changed: () => void): Choice {
  const jobs = h('select', {'aria-label': `${label}: ${t('job')}`, onchange: () => void load()});
  const sections = h('select', {'aria-label': `${label}: ${t('section')}`, onchange: () => changed()});
  const load = async () => {
    const kept = sections.value;
    const map = !jobs.value ? null : jobs.value === state.job?.job ? state.job
      : await get<JobMap>(`jobs/${jobs.value}/map`);
    const names = map?.sections.name ?? [];
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
  const section = () => (jobs.value && sections.value
    ? get<SectionDetail>(section_address(jobs.value, sections.value)) : Promise.resolve(null));
  return {element: h('fieldset', {}, h('legend', {}, label), h('div', {class: 'columns two'}, jobs, sections)), section,
    offer};
}

function difference_table(a: SectionDetail, b: SectionDetail): HTMLElement {
  const row = (name: string, of: (one: SectionDetail) => number | null, is: (one: SectionDetail) => string | null,
    unit: string) => {
    const [x, y] = [of(a), of(b)];
    return h('tr', {}, h('th', {scope: 'row'}, name), h('td', {class: 'number'}, bounded(x, is(a), unit)),
      h('td', {class: 'number'}, bounded(y, is(b), unit)),
      h('td', {class: 'number'}, x === null || y === null ? '–' : `${y > x ? '+' : ''}${show(y - x)} ${unit}`));
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

/** @param stage where the two profiles are drawn, over the map */
export function compare_step(stage: HTMLElement): HTMLElement {
  const report = new Report();
  const table = h('div');
  let shown: [SectionDetail, SectionDetail] | null = null;

  const draw = () => {
    if (!shown || stage.hidden) return;
    const sides = shown.map(side_of);
    const {x, z} = extent_of(sides);
    const narrow = stage.clientWidth < 700;
    const width = Math.max(narrow ? stage.clientWidth - 24 : stage.clientWidth / 2 - 24, 260);
    const height = Math.max(narrow ? stage.clientHeight / 2 - 60 : Math.min(stage.clientHeight - 60, width * 0.75),
      180);
    fill(stage, shown.map((section, i) => h('figure', {}, h('figcaption', {}, h('strong', {}, section.name)),
      profile_svg(sides[i]!, {width, height, x, z}) as unknown as HTMLElement)));
  };
  const changed = async () => {
    try {
      const [a, b] = await Promise.all([first.section(), second.section()]);
      if (!a || !b) {
        report.say(t('compare_need'));
        return;
      }
      report.say('');
      shown = [a, b];
      fill(table, difference_table(a, b));
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
