/** Fewer segments than there are, none of them far from what is drawn. Knows no page. */
import { RAPID, SHIFT, type Toolpath } from './data.ts';

/** What is drawn: pairs of vertices, the move of each pair (ascending), and how far from it what is left out can lie, in mm. */
export interface Drawn {
  readonly pairs: Uint32Array;
  readonly moves: Uint32Array;
  readonly tolerance: number;
}

/** Moves between two pauses. */
const STEP = 0x2000;

/** The segments of a toolpath if they are at most `most`; else as many as are left if vertices of a cell are one, with the smallest cells that do. */
export function* thinned(path: Toolpath, most: number): Generator<void, Drawn> {
  const total = path.vertices;
  const bounds = path.bounds();
  if (total <= most || !bounds) return every(path, total);
  const size = Math.max(...bounds[1].map((high, axis) => high - bounds[0][axis]!));
  const shifts = path.kind.reduce((sum, kind) => sum + Number(kind === SHIFT), 0);
  for (let tolerance = size / 2000; ; tolerance *= 1.4) {
    const found = yield* clustered(path, bounds[0], tolerance, most, shifts);
    if (found) return found;
  }
}

function every(path: Toolpath, total: number): Drawn {
  const pairs = new Uint32Array(2 * total);
  const moves = new Uint32Array(total);
  let count = 0;
  for (let move = 0; move < path.count; move++) {
    if (path.kind[move] === SHIFT) continue;
    for (let i = path.startOf(move); i < path.ends[move]!; i++) {
      pairs[2 * count] = i;
      pairs[2 * count + 1] = i + 1;
      moves[count++] = move;
    }
  }
  return { pairs: pairs.slice(0, 2 * count), moves: moves.slice(0, count), tolerance: 0 };
}

/** All vertices of a cell are drawn as its first one: a cell's diagonal is the tolerance. The same segment is drawn once. */
function* clustered(path: Toolpath, low: readonly number[], tolerance: number, most: number, shifts: number): Generator<void, Drawn | undefined> {
  const cell = tolerance / Math.sqrt(3);
  const pairs = new Uint32Array(2 * most);
  const moves = new Uint32Array(most);
  // A new cell is reached by a new segment, or by a shift, of which there are few: no more cells than segments and these.
  const firsts = new Table(most + 2 + shifts);
  const met = new Table(most + 1);
  const { points, ends, kind } = path;
  const [left, front, bottom] = low as [number, number, number];
  const first = (vertex: number): number => {
    const x = Math.floor((points[3 * vertex]! - left) / cell);
    const y = Math.floor((points[3 * vertex + 1]! - front) / cell);
    const z = Math.floor((points[3 * vertex + 2]! - bottom) / cell);
    return firsts.put((x * 0x20000 + y) * 0x20000 + z, Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791), vertex);
  };
  let count = 0;
  let vertex = 0;
  let from = first(0);
  for (let move = 0; move < path.count; move++) {
    const rapid = kind[move] === RAPID ? 1 : 0;
    if (move % STEP === 0) yield;
    for (const end = ends[move]!; vertex < end; ) {
      const to = first(++vertex);
      if (from !== to && kind[move] !== SHIFT) {
        const lower = Math.min(from, to);
        const upper = Math.max(from, to);
        if (met.put((lower * 0x2000000 + upper) * 2 + rapid, Math.imul(lower, 0x9e3779b1) ^ Math.imul(upper, 0x85ebca6b) ^ rapid, vertex) === vertex) {
          if (count === most) return undefined;
          pairs[2 * count] = from;
          pairs[2 * count + 1] = to;
          moves[count++] = move;
        }
      }
      from = to;
    }
  }
  return { pairs: pairs.slice(0, 2 * count), moves: moves.slice(0, count), tolerance };
}

/** What came first with a key: a hash table of fixed size, several times as fast as a Map. */
class Table {
  private readonly keys: Float64Array;
  private readonly values: Uint32Array;
  private readonly mask: number;

  constructor(most: number) {
    const size = 2 ** Math.ceil(Math.log2(2 * most));
    this.keys = new Float64Array(size).fill(-1);
    this.values = new Uint32Array(size);
    this.mask = size - 1;
  }

  /** The value that the key has had, or this one. */
  put(key: number, hash: number, value: number): number {
    let at = (hash ^ (hash >>> 15)) & this.mask;
    while (this.keys[at] !== key) {
      if (this.keys[at] === -1) {
        this.keys[at] = key;
        return (this.values[at] = value);
      }
      at = (at + 1) & this.mask;
    }
    return this.values[at]!;
  }
}
