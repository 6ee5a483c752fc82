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

/** Draws into `target`, in place of what stood there. */
export function plot(target: HTMLElement, x: number[], x_label: string, y_label: string, lines: readonly Line[]): void {
  target.replaceChildren();
  const numbers = (_: uPlot, values: number[]) => values.map((value) => show(value, 2));
  const axis = {font: '11px system-ui, sans-serif', labelFont: '11px system-ui, sans-serif', labelSize: 18,
    values: numbers};
  new uPlot({
    width: Math.max(target.clientWidth || 320, 240), height: 200,
    scales: {x: {time: false}, y: {range: (_, __, most) => [0, (most || 1) * 1.05]}},
    legend: {live: false}, cursor: {show: false},
    axes: [{...axis, label: x_label, size: 32}, {...axis, label: y_label, size: 42}],
    series: [{}, ...lines.map(({label, colour, dash}) => ({label, stroke: colour, width: 2, dash,
      points: {show: false}}))],
  }, [x, ...lines.map((line) => line.values)] as uPlot.AlignedData, target);
}
