/** `NAME=VALUE` pairs as they are typed. Knows no editor. */

export interface Definitions {
  readonly values: Record<string, string>;
  /** What cannot be read; undefined: everything can. */
  readonly wrong: string | undefined;
}

/** Pairs separated by blanks or commas; a value with blanks stands in double quotes. */
export function read(text: string): Definitions {
  const values: Record<string, string> = {};
  const rest = text.replace(/([^\s=,"]+)\s*=\s*(?:"([^"]*)"|([^\s,"]+))/g, (_, name: string, quoted?: string, plain?: string) => {
    values[name] = quoted ?? plain ?? '';
    return '';
  });
  const left = rest.replace(/[\s,]+/g, ' ').trim();
  return { values, wrong: left ? `\`${left}\` is no NAME=VALUE` : undefined };
}

/** The pairs as text that `read` reads. */
export function written(values: Readonly<Record<string, string>>): string {
  return Object.entries(values).map(([name, value]) => `${name}=${/^[^\s,"]+$/.test(value) ? value : `"${value}"`}`).join(' ');
}
