// How probable it is that a distance is exceeded: a curve a section, with its interval as a band.

import {h} from '../dom';
import {curve_lines} from '../ensemble/curves';
import {swatch} from '../section/animation';
import type {Ensemble} from '../types';
import {show, t} from '../words';
import {type Line, plot} from './curve_plot';

/** Okabe and Ito (2008): line, and the same thin as a band */
const colours = [
  {line: '#d55e00', band: 'rgba(213,94,0,0.2)'}, {line: '#0072b2', band: 'rgba(0,114,178,0.2)'},
];

/** A figure that draws itself as wide as it is. */
export function exceedance_figure(ensembles: readonly Ensemble[], of: 'retrogression' | 'runout'): HTMLElement {
  const name = t(of === 'retrogression' ? 'beyond_retrogression' : 'beyond_runout');
  const box = h('div', {class: 'exceedance', role: 'img', 'aria-label': name});
  const {distances_m, lines} = curve_lines(ensembles.map((one) => one[of].curve));
  const drawn = lines.flatMap((one, i): Line[] => {
    const {line} = colours[i]!;
    return [{label: ensembles[i]!.section, colour: line, values: one.measured},
      {label: '', colour: line, dash: [4, 4], values: one.cut_short},
      {label: '', colour: 'transparent', values: one.high}, {label: '', colour: 'transparent', values: one.low}];
  });
  const bands = lines.map((_, i) => ({high: 4 * i + 2, low: 4 * i + 3, colour: colours[i]!.band}));
  let width = 0;
  new ResizeObserver(() => {
    // Drawing does not change the width: no end of drawing otherwise.
    if (box.clientWidth === width || box.clientWidth === 0) return;
    width = box.clientWidth;
    plot(box, distances_m, t('distance_axis'), t('probability_axis'), drawn, {bands, shares: true, legend: false});
  }).observe(box);
  const confidence = show(100 * ensembles[0]!.confidence, 1);
  const cut_short = ensembles.some((one) => one[of].curve.censored_beyond_m !== null);
  return h('figure', {class: 'exceedance-figure'}, h('figcaption', {}, h('strong', {}, name)), box, h('ul', {class: 'key'},
    ensembles.map(({section}, i) => h('li', {}, swatch(colours[i]!.line), section)),
    h('li', {class: 'quiet'}, t('band_is', {percent: confidence})),
    cut_short ? h('li', {class: 'quiet'}, swatch('#444444', true), t('cut_short')) : null));
}
