// A form for a part of a document, made from the schema of that part. What is typed goes into the
// document at once; each field bears the JSON pointer that a fault of the server names.

import {h} from '../dom';
import type {Json, JsonObject} from '../types';
import {t, word_or} from '../words';
import {type Schema, type Schemas, pointer_part, typed_number, unit_of, variant_name} from './schema';

type Place = {holder: JsonObject | Json[]; key: string | number};

let ids = 0;

function label_of(name: string): string {
  return word_or(`field_${name}`, name.replace(/_/g, ' '));
}

export class SchemaForm {
  /** @param changed called after every change of the document
   *  @param names_of what a member may be chosen from, by its name: materials for "material"
   *  @param suggestions what may be typed, and other text too */
  constructor(private readonly schemas: Schemas, private readonly changed: () => void,
              private readonly names_of: (member: string) => string[] | null = () => null,
              private readonly suggestions: (member: string) => string[] = () => []) {}

  /** Fields of the members of an object, and a way to add those that may be there. */
  members(schema: Schema, object: JsonObject, pointer: string, only?: readonly string[]): HTMLElement {
    const box = h('div', {class: 'members', 'data-pointer': pointer});
    this.fill_members(box, this.schemas.resolve(schema), object, pointer, only);
    return box;
  }

  private fill_members(box: HTMLElement, schema: Schema, object: JsonObject, pointer: string,
    only?: readonly string[]): void {
    box.replaceChildren();
    const again = () => this.fill_members(box, schema, object, pointer, only);
    // The server sorts members by name; what must be there comes first, blocks of their own last.
    const rank = (name: string, member: Schema) =>
      (schema.required?.includes(name) ? 0 : 2) + (this.is_block(member) ? 1 : 0);
    const possible = Object.entries(schema.properties ?? {}).filter(([name]) => !only || only.includes(name))
      .sort(([a, x], [b, y]) => rank(a, x) - rank(b, y));
    const absent: string[] = [];
    for (const [name, member] of possible) {
      const form = this.schemas.resolve(member);
      if (form.const !== undefined) continue;
      const needed = schema.required?.includes(name) ?? false;
      if (!needed && object[name] === undefined) {
        absent.push(name);
        continue;
      }
      const remove = needed ? null : this.remove_button(label_of(name), () => {
        delete object[name];
        again();
      });
      box.append(this.member(name, form, {holder: object, key: name}, `${pointer}/${pointer_part(name)}`, remove));
    }
    const full = Object.keys(object).length >= (schema.maxProperties ?? Infinity);
    if (absent.length > 0 && !full) box.append(this.adder(absent, schema, object, again));
  }

  private is_block(member: Schema): boolean {
    const form = this.schemas.resolve(member);
    const variants = this.schemas.variants(form);
    return form.type === 'object' || form.type === 'array' || (variants.length > 0 &&
      variants.every((variant) => variant.type === 'object'));
  }

  private adder(absent: readonly string[], schema: Schema, object: JsonObject, again: () => void): HTMLElement {
    const choice = h('select', {class: 'adder', 'aria-label': t('add_field'), onchange: () => {
      object[choice.value] = this.schemas.blank(schema.properties![choice.value]!) ?? null;
      this.changed();
      again();
    }}, h('option', {value: ''}, t('add_field')), absent.map((name) => h('option', {value: name}, label_of(name))));
    return choice;
  }

  private remove_button(name: string, remove: () => void): HTMLElement {
    return h('button', {type: 'button', class: 'small', title: `${t('remove')}: ${name}`,
      'aria-label': `${t('remove')}: ${name}`,
      onclick: () => {
        remove();
        this.changed();
      }}, '×');
  }

  /** One member, by what its schema says it is. */
  private member(name: string, form: Schema, place: Place, pointer: string, remove: HTMLElement | null): HTMLElement {
    if (name === 'materials') return this.named(form, place, pointer);
    const variants = this.schemas.variants(form);
    if (variants.length > 0) return this.choice(name, variants, place, pointer, remove);
    if (form.type === 'object') {
      const object = value_at(place) as JsonObject;
      return h('fieldset', {}, h('legend', {}, label_of(name), ' ', remove), this.members(form, object, pointer));
    }
    if (form.type === 'array') return this.list(name, form, place, pointer, remove);
    return this.value(name, form, place, pointer, remove);
  }

  /** A number, a word, yes or no. */
  private value(name: string, form: Schema, place: Place, pointer: string, remove: HTMLElement | null): HTMLElement {
    const id = `field-${++ids}`;
    const set = (value: Json | undefined) => {
      put(place, value);
      this.changed();
    };
    const names = this.names_of(name) ?? (form.enum ? form.enum.map(String) : null);
    const now = value_at(place);
    let input: HTMLElement;
    if (form.type === 'boolean') {
      const box = h('input', {type: 'checkbox', id, onchange: () => set(box.checked)});
      box.checked = now === true;
      input = box;
    } else if (names) {
      const list = now === undefined || now === null || names.includes(String(now)) ? names : [String(now), ...names];
      const choice = h('select', {id, value: now ?? '', onchange: () =>
        set(typeof form.enum?.[0] === 'number' ? Number(choice.value) : choice.value)},
        now === undefined || now === null ? h('option', {value: ''}, '') : null,
        list.map((one) => h('option', {value: one}, one)));
      input = choice;
    } else {
      const is_number = form.type === 'number' || form.type === 'integer';
      const field = h('input', {type: 'text', id, value: now ?? '', inputmode: is_number ? 'decimal' : 'text',
        autocomplete: 'off',
        title: form.description ?? '', oninput: () => {
          const typed = is_number ? typed_number(field.value) : field.value;
          field.classList.toggle('odd', is_number && typeof typed === 'string');
          set(typed);
        }});
      input = field;
    }
    const unit = form.type === 'number' ? unit_of(name) : '';
    const suggested = this.suggestions(name);
    if (suggested.length > 0) input.setAttribute('list', `${id}-list`);
    return h('div', {class: 'field', 'data-pointer': pointer},
      h('label', {for: id}, label_of(name)), h('span', {class: 'input'}, input, h('span', {class: 'unit'}, unit),
        remove), suggested.length > 0 ? h('datalist', {id: `${id}-list`}, suggested.map((one) => h('option',
        {value: one}))) : null);
  }

  /** A value of one of several forms. */
  private choice(name: string, variants: readonly Schema[], place: Place, pointer: string,
    remove: HTMLElement | null): HTMLElement {
    const now = this.schemas.variant_of(variants, value_at(place));
    const plain = variants[now]!;
    const kinds = h('select', {'aria-label': `${label_of(name)}: ${t('kind')}`, value: now, onchange: () => {
      const wanted = variants[Number(kinds.value)]!;
      put(place, moved(value_at(place), wanted, this.schemas.blank(wanted)));
      this.changed();
      box.replaceWith(this.choice(name, variants, place, pointer, remove));
    }}, variants.map((variant, i) => h('option', {value: i}, variant.type === 'number' ? t('constant')
      : variant_label(variant, variants))));
    const box: HTMLElement = plain.type === 'object'
      ? h('fieldset', {'data-pointer': pointer}, h('legend', {}, label_of(name), ' ', variants.length > 1 ? kinds
        : null, ' ', remove),
        this.members(plain, (value_at(place) ?? {}) as JsonObject, pointer))
      : this.value(name, plain, place, pointer, h('span', {class: 'kinds'}, kinds, remove));
    return box;
  }

  /** Rows of a list: of objects one block each, of numbers side by side. */
  private list(name: string, form: Schema, place: Place, pointer: string, remove: HTMLElement | null): HTMLElement {
    const item = this.schemas.resolve((Array.isArray(form.items) ? form.items[0] : form.items) ?? {});
    const box = h('fieldset', {'data-pointer': pointer});
    const fill = () => {
      const list = (value_at(place) ?? []) as Json[];
      const change = (edit: () => void) => () => {
        edit();
        this.changed();
        fill();
      };
      const tools = (i: number) => h('span', {class: 'tools'},
        i > 0 ? h('button', {type: 'button', class: 'small', 'aria-label': `${t('up')} ${i + 1}`,
          onclick: change(() => list.splice(i - 1, 0, ...list.splice(i, 1)))}, '↑') : null,
        h('button', {type: 'button', class: 'small', 'aria-label': `${t('remove')} ${i + 1}`,
          onclick: change(() => list.splice(i, 1))}, '×'));
      box.replaceChildren(h('legend', {}, label_of(name), ' ', remove),
        ...list.map((value, i) => this.row(item, list, i, value, `${pointer}/${i}`, tools(i))),
        h('button', {type: 'button', class: 'small', onclick: change(() => list.push(this.schemas.blank(item) ?? null))},
          name === 'layers' ? t('add_layer') : t('add')));
    };
    fill();
    return box;
  }

  private row(item: Schema, list: Json[], i: number, value: Json, pointer: string, tools: HTMLElement): HTMLElement {
    if (item.type === 'object') {
      return h('div', {class: 'item'}, h('div', {class: 'item-head'}, h('span', {class: 'quiet'}, i + 1), tools),
        this.members(item, value as JsonObject, pointer));
    }
    if (item.type !== 'array') {
      const is_number = item.type === 'number';
      const field = h('input', {type: 'text', inputmode: is_number ? 'decimal' : 'text', value: value ?? '',
        'aria-label': String(i + 1), oninput: () => {
          list[i] = (is_number ? typed_number(field.value) : field.value) ?? null;
          this.changed();
        }});
      return h('div', {class: 'item numbers', 'data-pointer': pointer}, field, tools);
    }
    const row = (Array.isArray(value) ? value : [value]) as Json[];
    list[i] = row;
    const cells = Array.from({length: item.maxItems ?? row.length}, (_, at) => {
      const field = h('input', {type: 'text', inputmode: 'decimal', value: row[at] ?? '',
        'aria-label': `${i + 1}, ${at + 1}`,
        oninput: () => {
          row[at] = typed_number(field.value) ?? null;
          this.changed();
        }});
      return field;
    });
    return h('div', {class: 'item numbers', 'data-pointer': pointer}, cells, tools);
  }

  /** Members whose names the user gives: the materials. */
  private named(form: Schema, place: Place, pointer: string): HTMLElement {
    const item = form.additionalProperties as Schema;
    const box = h('fieldset', {'data-pointer': pointer});
    const fill = (open = '') => {
      const object = value_at(place) as Record<string, JsonObject>;
      const rename = (from: string, to: string) => {
        if (!to || to === from || to in object) return;
        const renamed = Object.entries(object).map(([name, value]) => [name === from ? to : name, value]);
      put(place, Object.fromEntries(renamed) as JsonObject);
        this.changed();
        fill(to);
      };
      box.replaceChildren(h('legend', {}, label_of('materials')),
        ...Object.keys(object).map((name) => {
          const field: HTMLInputElement = h('input', {type: 'text', value: name, 'aria-label': t('name'),
            onchange: () => rename(name, field.value.trim())});
          return h('details', {class: 'material', open: name === open},
            h('summary', {}, name),
            h('div', {class: 'field'}, h('label', {}, t('name'), ' ', field), this.remove_button(name, () => {
              delete object[name];
              fill();
            })),
            this.members(item, object[name]!, `${pointer}/${pointer_part(name)}`));
        }),
        h('button', {type: 'button', class: 'small', onclick: () => {
          let i = 1;
          while (`soil-${i}` in object) ++i;
          object[`soil-${i}`] = this.schemas.blank(item) as JsonObject;
          this.changed();
          fill(`soil-${i}`);
        }}, t('add_material')));
    };
    fill();
    return box;
  }
}

/** Two of one name are told apart by what they ask for. */
function variant_label(variant: Schema, variants: readonly Schema[]): string {
  const name = variant_name(variant);
  const label = word_or(`field_${name}`, name);
  if (variants.filter((one) => variant_name(one) === name).length < 2) return label;
  const asked = (variant.required ?? []).filter((member) => variant.properties?.[member]?.const === undefined);
  return `${label} (${asked.map(label_of).join(', ')})`;
}

function value_at({holder, key}: Place): Json | undefined {
  return (holder as Record<string | number, Json | undefined>)[key];
}

function put({holder, key}: Place, value: Json | undefined): void {
  if (value === undefined && !Array.isArray(holder)) delete holder[key];
  else (holder as Record<string | number, Json | undefined>)[key] = value ?? null;
}

/** What two forms of a value have in common is kept when one becomes the other. */
function moved(from: Json | undefined, to: Schema, blank: Json | undefined): Json | undefined {
  const is_object = (value: Json | undefined): value is JsonObject => typeof value === 'object' && value !== null &&
    !Array.isArray(value);
  if (!is_object(from) || !is_object(blank)) return blank;
  const kept = Object.entries(from).filter(([name]) => to.properties?.[name] &&
    to.properties[name]!.const === undefined);
  return {...blank, ...Object.fromEntries(kept)};
}
