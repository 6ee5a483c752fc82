// Faults of the server, at the fields that they name.

import type {Fault} from '../api';
import {h} from '../dom';

/** The innermost element that holds the value a pointer names. */
export function element_of(root: ParentNode, pointer: string): HTMLElement | null {
  const held = [...root.querySelectorAll<HTMLElement>('[data-pointer]')]
    .filter(({dataset}) => pointer === dataset.pointer || pointer.startsWith(`${dataset.pointer}/`));
  return held.reduce<HTMLElement | null>((best, one) =>
    (best && best.dataset.pointer!.length > one.dataset.pointer!.length ? best : one), null);
}

/** Marks what is wrong in place of what was marked before. */
export function mark_faults(root: ParentNode, faults: readonly Fault[]): void {
  for (const old of root.querySelectorAll('.fault')) old.remove();
  for (const field of root.querySelectorAll('[aria-invalid]')) {
    field.removeAttribute('aria-invalid');
    field.removeAttribute('aria-describedby');
  }
  faults.forEach((fault, i) => {
    const place = element_of(root, fault.pointer);
    if (!place) return;
    const id = `fault-${i}`;
    const message = h('p', {class: 'fault', id, role: 'alert'}, fault.detail);
    place.append(message);
    const input = place.matches('.field') ? place.querySelector('input, select, textarea') : null;
    input?.setAttribute('aria-invalid', 'true');
    input?.setAttribute('aria-describedby', id);
    let outer = place.closest('details');
    while (outer) {
      outer.open = true;
      outer = outer.parentElement?.closest('details') ?? null;
    }
  });
}
