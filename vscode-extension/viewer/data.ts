/** A toolpath as the server and the command line hand it out: columns in chunks, made into typed arrays. Knows no page. */

/** What is said once of a toolpath. Lengths are millimetres. */
export interface Header {
  readonly title: string;
  /** Millimetres that 1 stands for in a column of positions. */
  readonly quantum: number;
  readonly moves: number;
  readonly chunks: number;
  readonly start: readonly [number, number, number];
  /** Of all moves, and of those that cut: the lowest and the highest corner; null if there are none. */
  readonly bounds: Readonly<Record<string, readonly [readonly number[], readonly number[]] | null>>;
  readonly kinds: readonly string[];
  /** Numbers of tools; the moves have their places in this list. */
  readonly tools: readonly number[];
  readonly frameKinds: readonly string[];
  readonly notes: readonly string[];
  readonly sources: readonly Source[];
}

export interface Source {
  readonly name: string;
  readonly uri?: string;
  /** Its text, if the page brings it: packed. */
  readonly text?: string;
}

/** Some moves in a row. Chunks come in order. */
export interface Chunk {
  /** Packed columns: one entry for each move, each of their points, or each frame. */
  readonly columns: Readonly<Record<string, string>>;
  /** The flat lines behind those of the chunk before, up to that of the last move: packed. */
  readonly text: string;
}

/** A call or a loop pass. */
export interface Frame {
  readonly parent: number;
  readonly source: number;
  readonly row: number;
  readonly kind: string;
  readonly number: number;
}

/** Kinds of moves, as the server numbers them; a shift is none: another point of the tool counts from here on. */
export const RAPID = 0;
export const SHIFT = 5;
const FRAME = ['frameParent', 'frameSource', 'frameRow', 'frameKind', 'frameNumber'] as const;

/** All moves. Vertex 0 is where the tool stands at first; move m ends at vertex `ends[m]`. */
export class Toolpath {
  readonly kind: Uint8Array;
  readonly ends: Uint32Array;
  readonly tool: Int32Array;
  readonly row: Int32Array;
  readonly source: Int32Array;
  readonly line: Int32Array;
  readonly frame: Int32Array;
  /** x, y, z of each vertex: ends of moves, and points between on arcs. It has room for more. */
  points: Float32Array;
  readonly flat = new Text();
  /** The moves that are there so far. */
  count = 0;
  private readonly frames: number[][] = FRAME.map(() => []);
  private readonly low = [Infinity, Infinity, Infinity];
  private readonly high = [-Infinity, -Infinity, -Infinity];

  constructor(readonly header: Header) {
    const n = header.moves;
    this.kind = new Uint8Array(n);
    this.ends = new Uint32Array(n);
    this.tool = new Int32Array(n);
    this.row = new Int32Array(n);
    this.source = new Int32Array(n);
    this.line = new Int32Array(n);
    this.frame = new Int32Array(n);
    this.points = new Float32Array(3 * (n + 1));
    this.points.set(header.start);
  }

  /** Take in the next chunk. */
  async add(chunk: Chunk): Promise<void> {
    const names = Object.keys(chunk.columns);
    const unpacked = await Promise.all(names.map((name) => column(chunk.columns[name]!)));
    const of = (name: string): Int32Array => unpacked[names.indexOf(name)]!;
    const n = of('kind').length;
    for (const name of ['kind', 'tool', 'row', 'source', 'line', 'frame'] as const) this[name].set(of(name), this.count);
    const counts = of('vertices');
    const vertex = this.vertices;
    let end = vertex;
    for (let i = 0; i < n; i++) this.ends[this.count + i] = end += counts[i]!;
    this.reserve(end + 1);
    ['x', 'y', 'z'].forEach((name, axis) => {
      const values = of(name);
      for (let i = 0; i < values.length; i++) this.points[3 * (vertex + 1 + i) + axis] = values[i]! * this.header.quantum;
    });
    FRAME.forEach((name, i) => of(name).forEach((value) => this.frames[i]!.push(value)));
    this.flat.append(await bytes(chunk.text));
    this.count += n;
    this.reach(this.count - n);
  }

  /** The last vertex so far. */
  get vertices(): number {
    return this.count ? this.ends[this.count - 1]! : 0;
  }

  /** The vertex at which a move begins. */
  startOf(move: number): number {
    return move ? this.ends[move - 1]! : 0;
  }

  /** The calls and passes above a move, innermost first. */
  stack(move: number): Frame[] {
    const found: Frame[] = [];
    for (let i = this.frame[move]!; i >= 0; i = this.frames[0]![i]!) {
      const [parent, source, row, kind, number] = this.frames.map((values) => values[i]!) as [number, number, number, number, number];
      found.push({ parent, source, row, kind: this.header.frameKinds[kind]!, number });
    }
    return found;
  }

  /** The moves that a source line made. */
  movesOf(source: number, line: number): number[] {
    const found: number[] = [];
    for (let i = 0; i < this.count; i++) if (this.line[i] === line && this.source[i] === source) found.push(i);
    return found;
  }

  private reserve(vertices: number): void {
    if (3 * vertices <= this.points.length) return;
    const more = new Float32Array(Math.max(3 * vertices, 2 * this.points.length));
    more.set(this.points);
    this.points = more;
  }

  /** The lowest and the highest corner of what is drawn; arcs count as their chords. */
  bounds(): [number[], number[]] | undefined {
    return this.low[0]! <= this.high[0]! ? [this.low, this.high] : undefined;
  }

  private reach(first: number): void {
    const { low, high, points } = this;
    for (let move = first; move < this.count; move++) {
      if (this.kind[move] === SHIFT) continue;
      for (let i = this.startOf(move); i <= this.ends[move]!; i++) {
        for (let axis = 0; axis < 3; axis++) {
          const value = points[3 * i + axis]!;
          if (value < low[axis]!) low[axis] = value;
          if (value > high[axis]!) high[axis] = value;
        }
      }
    }
  }
}

/** A text of any length, of which single lines are wanted. */
export class Text {
  private parts: Uint8Array[] = [];
  private whole = new Uint8Array();
  private starts: Uint32Array | undefined;

  append(part: Uint8Array): void {
    this.parts.push(part);
    this.starts = undefined;
  }

  get count(): number {
    return this.index().length - 1;
  }

  /** A line by its number from 0, without its end. */
  line(row: number): string {
    const starts = this.index();
    const [start, end] = [starts[row], starts[row + 1]];
    return start === undefined || end === undefined ? '' : new TextDecoder().decode(this.whole.subarray(start, end - 1));
  }

  private index(): Uint32Array {
    if (this.starts) return this.starts;
    this.whole = joined([this.whole, ...this.parts]);
    this.parts = [];
    const starts = [0];
    for (let at = this.whole.indexOf(10); at >= 0; at = this.whole.indexOf(10, at + 1)) starts.push(at + 1);
    return (this.starts = Uint32Array.from(starts));
  }
}

/** How many of the first `count` values, which ascend, are at most `most`. */
export function countUpTo(values: ArrayLike<number>, count: number, most: number): number {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle]! <= most) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** A column: base 64 of deflated differences, 32 bits each, the lowest byte first. */
async function column(packed: string): Promise<Int32Array> {
  const raw = await bytes(packed);
  const values = new Int32Array(raw.buffer, raw.byteOffset, raw.byteLength / 4);
  for (let i = 1; i < values.length; i++) values[i]! += values[i - 1]!;
  return values;
}

/** What was packed: base 64 of a deflated stream. */
export async function bytes(packed: string): Promise<Uint8Array> {
  const raw = atob(packed);
  const deflated = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) deflated[i] = raw.charCodeAt(i);
  const stream = new Blob([deflated]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function joined(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
