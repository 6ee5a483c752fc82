// Curves: one x, several lines.

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import {show} from '../words';

export interface Line {
  label: string;
  colour: string;
  dash?: number[];
  values: (number | null)[];
}

export interface Look {
  /** between two lines, by their places in the list */
  bands?: {high: number; low: number; colour: string}[];
  /** shares of 1, written as percentages up to 100 */
  shares?: boolean;
  legend?: boolean;
}

/** Draws into `target`, in place of what stood there. */
export function plot(target: HTMLElement, x: number[], x_label: string, y_label: string, lines: readonly Line[],
                     {bands = [], shares = false, legend = true}: Look = {}): void {
  target.replaceChildren();
  const numbers = (_: uPlot, values: number[]) => values.map((value) => show(value, 2));
  const percentages = (_: uPlot, values: number[]) => values.map((value) => `${show(100 * value, 0)} %`);
  const axis = {font: '11px system-ui, sans-serif', labelFont: '11px system-ui, sans-serif', labelSize: 18,
    values: numbers};
  new uPlot({
    width: Math.max(target.clientWidth || 320, 240), height: 200,
    scales: {x: {time: false}, y: {range: (_, __, most) => [0, shares ? 1 : (most || 1) * 1.05]}},
    legend: {show: legend, live: false}, cursor: {show: false},
    axes: [{...axis, label: x_label, size: 32},
      {...axis, label: y_label, size: shares ? 54 : 42, values: shares ? percentages : numbers}],
    series: [{}, ...lines.map(({label, colour, dash}) => ({label, stroke: colour, width: 2, dash,
      points: {show: false}}))],
    // A line's place in the list is one less than its series': the first series is x.
    bands: bands.map(({high, low, colour}) => ({series: [high + 1, low + 1], fill: colour})),
  }, [x, ...lines.map((line) => line.values)] as uPlot.AlignedData, target);
}
