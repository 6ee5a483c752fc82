// A resolution study in the list of jobs: its picture, what it says, and its settings.

import {blob, get, text} from '../api';
import {fill, h, save} from '../dom';
import {on, state} from '../state';
import type {JobMap, Study, StudySetting} from '../types';
import {show, t} from '../words';
import {type Report, button, warnings} from './parts';

/** How a setting did: what it may be chosen for, or why it is none to choose. */
export function judged(setting: StudySetting, study: Study): string {
  if (setting.is_reference) return t('study_reference');
  if (setting.not_a_choice) return setting.not_a_choice;
  const fastest = study.fastest_within_wanted_error.both?.by_mean;
  const is_fastest = fastest?.cell_m === setting.cell_m && fastest.particles_per_cell === setting.particles_per_cell &&
    fastest.time_step_factor === setting.time_step_factor;
  return is_fastest ? t('study_fastest') : setting.error.both.mean_within ? t('study_within') : '';
}

export function setting_row(setting: StudySetting, study: Study): string[] {
  const error = setting.error.both.of_runs;
  const percent = (share: number | null | undefined) => (share === null || share === undefined ? '–'
    : `${show(100 * share)} %`);
  return [show(setting.cell_m, 3), show(setting.particles_per_cell), show(setting.time_step_factor, 2),
    show(setting.crest_to_crest_retrogression_m?.mean), show(setting.runout_m?.mean), percent(error?.mean),
    show(setting.cost_s), judged(setting, study)];
}

function setting_table(study: Study): HTMLElement {
  const head = [`${t('cell')}, m`, t('study_particles'), t('field_time_step_factor'), `${t('retrogression')}, m`,
    `${t('runout')}, m`, t('study_error'), `${t('run_time')}, s`, ''];
  return h('div', {class: 'wide', tabindex: 0, role: 'group', 'aria-label': t('study_settings')},
    h('table', {class: 'sections'}, h('caption', {}, t('study_settings')),
      h('thead', {}, h('tr', {}, head.map((word) => (word ? h('th', {scope: 'col'}, word) : h('td', {}))))),
      h('tbody', {}, study.settings.map((setting) => h('tr', {}, setting_row(setting, study).map((cell, i) =>
        h('td', {class: i < 7 ? 'number' : ''}, cell)))))));
}

let picture_url = '';

async function load(stage: HTMLElement, words: HTMLElement, job: JobMap, report: Report): Promise<void> {
  const address = `jobs/${job.job}/results`;
  const [picture, study] = await Promise.all([blob(`${address}?f=svg`), get<Study>(address)]);
  if (state.job?.job !== job.job) return;
  URL.revokeObjectURL(picture_url);
  picture_url = URL.createObjectURL(picture);
  const keep = (f: string) => void text(`${address}?f=${f}`).then((content) => save(new Blob([content]),
    `${job.name || job.job}.${f}`), (error) => report.problem(error));
  fill(stage, h('figure', {}, h('img', {src: picture_url, alt: t('study_picture')}),
    h('figcaption', {}, t('study_picture'))), setting_table(study));
  fill(words, h('div', {class: 'row'}, button('study_svg', () => keep('svg')), button('study_csv', () => keep('csv'))),
    h('ul', {class: 'outcome'}, study.outcome.map((one) => h('li', {}, one))),
    study.warnings.length > 0 ? warnings(study.warnings) : null);
}

/** Shows the study that is chosen; nothing of another job.
 *  @param stage over the map, on which a study has nothing
 *  @return what is said beside it */
export function study_box(stage: HTMLElement, report: Report): HTMLElement {
  const element = h('div');
  let shown = '';
  const draw = () => {
    const {job} = state;
    const wanted = job?.processID === 'resolution-study' && job.status === 'successful' ? job.job : '';
    stage.hidden = state.step !== 'look' || !wanted || state.section !== null;
    if (wanted === shown) return;
    shown = wanted;
    fill(element);
    fill(stage);
    if (job && wanted) void load(stage, element, job, report).catch((error) => report.problem(error));
  };
  on(['job', 'step', 'section'], draw);
  return element;
}
