/** What of the editor's settings the server is told: what somebody has set, and never a default, which would lie over `deburr.toml`. Knows no editor. */

/** What the editor knows of one setting. */
export interface Inspected {
  readonly globalValue?: unknown;
  readonly workspaceValue?: unknown;
  readonly workspaceFolderValue?: unknown;
}

/** Settings that are the extension's own. */
const OWN = new Set(['interpreter', 'trace.server', 'server']);

/** The server's settings as nested tables: `check.fail-on` becomes `{check: {"fail-on": ...}}`. */
export function told(names: readonly string[], inspect: (name: string) => Inspected | undefined): Record<string, unknown> {
  const found: Record<string, unknown> = {};
  for (const name of names) {
    const value = OWN.has(name) ? undefined : set(inspect(name));
    if (value !== undefined && value !== null) put(found, name.split('.'), value);
  }
  return found;
}

function set(said: Inspected | undefined): unknown {
  return said?.workspaceFolderValue ?? said?.workspaceValue ?? said?.globalValue;
}

function put(table: Record<string, unknown>, path: readonly string[], value: unknown): void {
  const [head, ...rest] = path;
  if (head === undefined) return;
  if (rest.length === 0) table[head] = value;
  else put((table[head] ??= {}) as Record<string, unknown>, rest, value);
}
