// How sure a section's distances are: curves, quantiles, and what decides.

import {section_address} from '../actions';
import {Problem, blob, get} from '../api';
import {fill, h, s, save} from '../dom';
import {exceedance_figure} from '../drawing/exceedance_plot';
import {check_rows, condition_words, decider_words, deciders, distances, quantile_rows,
  summary_rows} from '../ensemble/numbers';
import {Report, button, facts, warnings} from '../steps/parts';
import type {DistanceSummary, Ensemble} from '../types';
import {type Word, t} from '../words';

const bar = {width: 120, height: 12};

/** A share as a bar, its standard error as a line. */
function share_bar(share: number, error: number | null): SVGElement {
  const x = (value: number) => bar.width * Math.min(Math.max(value, 0), 1);
  return s('svg', {width: bar.width, height: bar.height, viewBox: `0 0 ${bar.width} ${bar.height}`, 'aria-hidden': 'true'},
    s('rect', {width: bar.width, height: bar.height, fill: '#eef2f3'}),
    s('rect', {width: x(share), height: bar.height, fill: '#7d93a3'}),
    error === null ? null : s('line', {x1: x(share - error), x2: x(share + error), y1: bar.height / 2, y2: bar.height / 2,
      stroke: '#14242a', 'stroke-width': 1.5}));
}

function quantile_table(summary: DistanceSummary): HTMLElement {
  return h('table', {}, h('thead', {}, h('tr', {}, (['exceeded_by', 'distance', 'by_ranks'] as Word[]).map((word) =>
    h('th', {scope: 'col'}, t(word))))),
    h('tbody', {}, quantile_rows(summary).map(([exceedance, distance, range]) => h('tr', {}, h('th', {scope: 'row'},
      exceedance), h('td', {class: 'number'}, distance), h('td', {class: 'number'}, range)))));
}

function decider_table(summary: DistanceSummary): HTMLElement {
  const shares = deciders(summary);
  return h('div', {}, h('h3', {}, t('decides')),
    shares.length === 0 ? h('p', {class: 'quiet'}, t('few_members')) : h('table', {class: 'deciders'},
      h('caption', {}, t('share_of_variance')),
      h('tbody', {}, shares.map((one) => h('tr', {}, h('th', {scope: 'row'}, one.name),
        h('td', {}, share_bar(one.share, one.error)), h('td', {class: 'number'}, decider_words(one)))))),
    facts(check_rows(summary)));
}

function whole(ensemble: Ensemble, job: string, report: Report): HTMLElement {
  const keep = async (path: string, name: string) => {
    try {
      save(await blob(path), name);
    } catch (error) {
      report.problem(error);
    }
  };
  const address = section_address(job, ensemble.section);
  return h('div', {},
    h('p', {class: 'condition'}, condition_words(ensemble.condition)),
    h('div', {class: 'row'}, summary_rows(ensemble).map(([name, value]) => h('span', {class: 'badge'},
      `${name}: ${value}`)),
      button('download_curves', () => void keep(`${address}/ensemble?f=svg`, `${ensemble.section}-ensemble.svg`), 'small'),
      button('take_members', () => void keep(`jobs/${job}/members?f=csv`, `${job}-members.csv`), 'small')), report.element,
    ensemble.warnings.length > 0 ? warnings(ensemble.warnings) : null,
    h('div', {class: 'distances'}, distances.map((of) => h('section', {'aria-label': t(of)},
      exceedance_figure([ensemble], of), quantile_table(ensemble[of]), decider_table(ensemble[of])))));
}

/** The ensemble of a section, once it is there; why there is none, where it is not. */
export function ensemble_tab(job: string, section: string): HTMLElement {
  const report = new Report();
  const box = h('div', {class: 'ensemble-tab'}, h('p', {class: 'quiet'}, t('loading')));
  get<Ensemble>(`${section_address(job, section)}/ensemble`).then(
    (ensemble) => fill(box, whole(ensemble, job, report)),
    (error) => {
      fill(box, report.element);
      if (error instanceof Problem && error.status === 404) report.say(t('not_yet_sure', {why: error.message}));
      else report.problem(error);
    });
  return box;
}
