// What a form needs to know of a JSON schema (draft 7, as the server publishes it).

import type {Json, JsonObject} from '../types';

export interface Schema {
  $ref?: string;
  type?: string;
  description?: string;
  properties?: Record<string, Schema>;
  additionalProperties?: boolean | Schema;
  required?: string[];
  oneOf?: Schema[];
  enum?: Json[];
  const?: Json;
  default?: Json;
  items?: Schema | Schema[];
  minItems?: number;
  maxItems?: number;
  maxProperties?: number;
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  exclusiveMaximum?: number;
  definitions?: Record<string, Schema>;
}

export class Schemas {
  constructor(readonly whole: Schema) {}

  /** The schema itself in place of a reference to it; what stands beside the reference wins. */
  resolve(schema: Schema): Schema {
    if (!schema.$ref) return schema;
    const name = schema.$ref.replace('#/definitions/', '');
    const {$ref: _, ...beside} = schema;
    return {...this.resolve(this.whole.definitions?.[name] ?? {}), ...beside};
  }

  /** Forms of a value that exclude each other; empty where there is one form only. */
  variants(schema: Schema): Schema[] {
    const list = (schema.oneOf ?? []).map((one) => this.resolve(one));
    // "one of these members must be there" says nothing of the form.
    return list.every((one) => one.properties || one.type || one.const !== undefined) ? list : [];
  }

  /** The variant that a value is written in, else the first. */
  variant_of(variants: readonly Schema[], value: Json | undefined): number {
    const whole = variants.findIndex((variant) => this.fits(variant, value, true));
    // What is not typed yet is missing: what it is called tells it too.
    return Math.max(whole >= 0 ? whole : variants.findIndex((variant) => this.fits(variant, value, false)), 0);
  }

  private fits(schema: Schema, value: Json | undefined, whole: boolean): boolean {
    if (typeof value !== 'object' || value === null || Array.isArray(value)) {
      return schema.type === kind_of(value) || (schema.type === undefined && !schema.properties);
    }
    if (schema.type !== 'object') return false;
    let called = false;
    for (const [name, member] of Object.entries(schema.properties ?? {})) {
      const {const: wanted, enum: words} = this.resolve(member);
      if (wanted === undefined && !(words && schema.required?.includes(name))) continue;
      called = true;
      if (wanted !== undefined ? value[name] !== wanted : !words!.includes(value[name] ?? null)) return false;
    }
    return (called && !whole) || (schema.required ?? []).every((name) => name in value);
  }

  /** The least that a value of this form holds: what must be there, empty, and constants. */
  blank(schema: Schema): Json | undefined {
    const form = this.resolve(schema);
    if (form.const !== undefined) return form.const;
    if (form.default !== undefined) return form.default;
    if (form.enum) return form.enum[0];
    const variants = this.variants(form);
    if (variants.length > 0) return this.blank(variants[0]!);
    if (form.type === 'object') {
      const made: JsonObject = {};
      for (const name of form.required ?? []) made[name] = this.blank(form.properties?.[name] ?? {});
      return made;
    }
    if (form.type === 'array') {
      const item = Array.isArray(form.items) ? undefined : form.items;
      return Array.from({length: form.minItems ?? 0}, () => (item ? this.blank(item) ?? null : null));
    }
    return form.type === 'boolean' ? false : undefined;
  }
}

function kind_of(value: Json | undefined): string {
  if (typeof value === 'number') return 'number';
  if (typeof value === 'string') return 'string';
  return typeof value === 'boolean' ? 'boolean' : 'none';
}

/** How a variant is told from the others: its law, its kind, or the member that only it has. */
export function variant_name(schema: Schema): string {
  for (const [name, member] of Object.entries(schema.properties ?? {})) {
    if (typeof member.const === 'string') return member.const;
    if (member.enum && schema.required?.includes(name)) return member.enum.join(', ');
  }
  return schema.required?.[0] ?? schema.type ?? '';
}

const units: readonly (readonly [RegExp, string])[] = [
  [/_kN_m3$/, 'kN/m³'], [/_kPa$/, 'kPa'], [/_Pa_sn$/, 'Pa sⁿ'], [/_Pa_s$/, 'Pa s'], [/_per_s$/, '1/s'], [/_deg$/, '°'],
  [/_m$/, 'm'], [/_s$/, 's'],
];

/** The unit that stands in a member's name; empty where it has none. */
export function unit_of(name: string): string {
  return units.find(([ending]) => ending.test(name))?.[1] ?? '';
}

/** A typed number, with either decimal sign; the text itself where it is none. */
export function typed_number(text: string): number | string | undefined {
  const trimmed = text.trim();
  if (trimmed === '') return undefined;
  const number = Number(trimmed.replace(',', '.').replace(/\u2212/g, '-'));
  return Number.isFinite(number) ? number : trimmed;
}

/** A part of a JSON pointer. */
export function pointer_part(name: string): string {
  return name.replace(/~/g, '~0').replace(/\//g, '~1');
}
