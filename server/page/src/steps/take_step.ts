// What a job made, as files.

import {request} from '../api';
import {fill, h, save} from '../dom';
import {has_ensemble} from '../ensemble/numbers';
import type {MapView} from '../map/map_view';
import {make_report} from '../report';
import {on, state} from '../state';
import type {JobMap} from '../types';
import {type Word, t} from '../words';
import {Report, button} from './parts';

const formats: readonly (readonly [string, Word])[] = [
  ['gpkg', 'take_gpkg'], ['geojson', 'take_geojson'], ['shp', 'take_shp'], ['fgb', 'take_fgb'],
];

const rasters: readonly (readonly [string, Word])[] = [
  ['release_probability', 'take_release_probability'], ['runout_probability', 'take_runout_probability'],
];

/** ".gpkg", as the server names the file. */
function ending_of(answer: Response): string {
  return /filename="[^"]*(\.[a-z]+)"/.exec(answer.headers.get('Content-Disposition') ?? '')?.[1] ?? '';
}

/** Rasters of probability lie over the map of a finished region; members are there from the first on. */
function ensemble_files(job: JobMap, keep: (path: string, name: string) => Promise<void>): HTMLElement {
  const has_rasters = job.status === 'successful' && job.processID === 'map-region';
  return h('div', {class: 'stack'}, h('h4', {}, t('ensemble')), h('p', {class: 'condition'}, t('condition')),
    has_rasters ? rasters.map(([file, word]) => h('div', {class: 'row'},
      button(word, () => void keep(`jobs/${job.job}/rasters/${file}.tif`, file)),
      button('take_style', () => void keep(`jobs/${job.job}/rasters/${file}.qml`, file), 'small'))) : null,
    button('take_members', () => void keep(`jobs/${job.job}/members?f=csv`, `${job.job}-members.csv`)));
}

export function take_step(map: MapView): HTMLElement {
  const report = new Report();
  const box = h('div');
  const keep = async (path: string, name: string) => {
    try {
      report.say(t('loading'));
      const answer = await request(path, {headers: {Accept: '*/*'}});
      save(await answer.blob(), name + ending_of(answer));
      report.say('');
    } catch (error) {
      report.problem(error);
    }
  };
  const report_file = async () => {
    const job = state.job!;
    try {
      const html = await make_report(job, state.raster, map.picture(), (done, all) => report.say(t('take_report_making',
        {done, all})));
      save(new Blob([html], {type: 'text/html'}), `${job.name || job.job}-report.html`);
      report.say('');
    } catch (error) {
      report.problem(error);
    }
  };
  const show = () => {
    const {job, raster} = state;
    if (!job) return fill(box, h('p', {class: 'quiet'}, t('take_need')));
    const finished = job.status === 'successful';
    const name = job.name || job.job;
    fill(box, h('h3', {}, name), finished ? h('div', {class: 'stack'},
      h('button', {type: 'button', class: 'primary', onclick: () => void report_file()}, t('take_report')),
      formats.map(([f, word]) => button(word, () => void keep(`jobs/${job.job}/export?f=${f}`, name))))
      : h('p', {class: 'quiet'}, t('take_need')),
      has_ensemble(job) ? ensemble_files(job, keep) : null,
      h('div', {class: 'stack'},
        button('take_request', () => save(new Blob([JSON.stringify(job.request, null, 2)], {type: 'application/json'}),
          `${name}-request.json`)),
        raster ? button('take_hillshade', () => void keep(`rasters/${raster.id}/hillshade.png`,
          `${raster.name}-hillshade.png`)) : null));
  };
  on('job', show);
  show();
  return h('section', {}, h('h2', {}, t('step_take')), h('p', {}, t('take_intro')), report.element, box);
}
