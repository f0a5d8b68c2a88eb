/** Which line of which file made a flat line, under which calls and loop passes: both ways. Knows no editor. */

/** Source Map v3 with the two fields that `deburr expand --source-map` adds. Rows are 0-based. */
export interface FlatMap {
  readonly sources: readonly string[];
  /** `[parent or -1, source, row, kind, number]` */
  readonly x_deburr_frames: readonly (readonly [number, number, number, string, number])[];
  /** For each flat line: `[source, row, frame or -1]` */
  readonly x_deburr_lines: readonly (readonly [number, number, number])[];
}

export interface Place {
  readonly uri: string;
  readonly row: number;
}

export interface Frame extends Place {
  readonly kind: string;
  readonly number: number;
}

/** Where a flat line comes from. */
export function originOf(map: FlatMap, line: number): Place | undefined {
  const found = map.x_deburr_lines[line];
  return found && place(map, found[0], found[1]);
}

/** The calls, files and loop passes above a flat line, the innermost first. */
export function stackOf(map: FlatMap, line: number): Frame[] {
  const stack: Frame[] = [];
  for (let at = map.x_deburr_lines[line]?.[2] ?? -1; at >= 0; ) {
    const frame = map.x_deburr_frames[at];
    if (!frame) break;
    const [parent, source, row, kind, number] = frame;
    stack.push({ ...place(map, source, row), kind, number });
    at = parent;
  }
  return stack;
}

/** All flat lines that a line of a source made. */
export function linesOf(map: FlatMap, uri: string, row: number): readonly number[] {
  return indexOf(map, uri)?.lines.get(row) ?? [];
}

/** The flat line to show for a line of a source: its first, or that of the nearest line above that made any. */
export function nearestLine(map: FlatMap, uri: string, row: number): number | undefined {
  const index = indexOf(map, uri);
  if (!index) return undefined;
  let [low, high] = [0, index.rows.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((index.rows[middle] ?? 0) <= row) low = middle + 1;
    else high = middle;
  }
  const found = index.rows[low - 1];
  return found === undefined ? undefined : index.lines.get(found)?.[0];
}

/** The flat lines of each row of a source, and those rows in order. */
interface Index {
  readonly lines: ReadonlyMap<number, readonly number[]>;
  readonly rows: readonly number[];
}

/** Made once for a map: a cursor moves more often than a program is expanded. */
const indexes = new WeakMap<FlatMap, readonly Index[]>();

function indexOf(map: FlatMap, uri: string): Index | undefined {
  let made = indexes.get(map);
  if (!made) indexes.set(map, (made = indexed(map)));
  return made[map.sources.findIndex((each) => same(each, uri))];
}

function indexed(map: FlatMap): Index[] {
  const found = map.sources.map(() => new Map<number, number[]>());
  map.x_deburr_lines.forEach(([source, row], line) => {
    const lines = found[source];
    const known = lines?.get(row);
    if (known) known.push(line);
    else lines?.set(row, [line]);
  });
  return found.map((lines) => ({ lines, rows: [...lines.keys()].sort((left, right) => left - right) }));
}

/** A stack in words, a line each: `2nd pass of the loop at peck.ngc:12`. */
export function told(frame: Frame): string {
  const where = `${frame.uri.slice(frame.uri.lastIndexOf('/') + 1)}:${frame.row + 1}`;
  return frame.kind === 'loop' ? `pass ${frame.number} of the loop at ${where}` : `${frame.kind} at ${where}`;
}

function place(map: FlatMap, source: number, row: number): Place {
  return { uri: map.sources[source] ?? '', row };
}

/** The server and the editor may write one URI differently: `file:///c%3A/a` and `file:///C:/a`. */
export function same(left: string, right: string): boolean {
  return left === right || decodeURIComponent(left).toLowerCase() === decodeURIComponent(right).toLowerCase();
}
