// Parts that several steps are made of.

import {Problem} from '../api';
import {h} from '../dom';
import {type Word, t} from '../words';

/** A line that says how something goes; read aloud when it changes. */
export class Report {
  readonly element = h('p', {class: 'report', role: 'status'});

  say(text: string, bad = false): void {
    this.element.textContent = text;
    this.element.classList.toggle('bad', bad);
  }

  problem(error: unknown): void {
    if (!(error instanceof Problem)) throw error;
    if (error.status === 0) return this.say(t('no_answer'), true);
    const faults = error.faults.map((fault) => ` ${fault.detail}.`).join('');
    this.say(error.message + faults, true);
  }
}

export function field(label: string, input: HTMLElement, pointer = ''): HTMLElement {
  const id = input.id || `in-${Math.random().toString(36).slice(2, 9)}`;
  input.id = id;
  return h('div', {class: 'field', 'data-pointer': pointer || null},
    h('label', {for: id}, label), h('span', {class: 'input'}, input));
}

export function facts(rows: readonly (readonly [string, string | Node | null])[]): HTMLElement {
  return h('dl', {class: 'facts'}, rows.filter(([, value]) => value !== null)
    .flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]));
}

export function warnings(list: readonly string[]): HTMLElement {
  if (list.length === 0) return h('p', {class: 'quiet'}, t('no_warnings'));
  return h('ul', {class: 'warnings'}, list.map((one) => h('li', {}, one)));
}

export function button(label: Word, run: () => void, kind = ''): HTMLButtonElement {
  return h('button', {type: 'button', class: kind, onclick: run}, t(label));
}
