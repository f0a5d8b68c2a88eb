import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateSync } from 'node:zlib';
import { RAPID, SHIFT, Text, Toolpath, countUpTo, type Chunk, type Header } from '../viewer/data.ts';
import { pick, type Projection } from '../viewer/pick.ts';
import { inSteps } from '../viewer/steps.ts';
import { thinned } from '../viewer/thin.ts';

const FEED = 1;
const ALL = { moves: Infinity, rapids: true, cuts: true };
/** From above: a millimetre is ten pixels, y goes up on the screen, what is higher is nearer. */
const ABOVE: Projection = [10, 0, 0, 0, 0, -10, 0, 100, 0, 0, -1, 0];

function packed(values: readonly number[]): string {
  const differences = Int32Array.from(values, (value, i) => value - (values[i - 1] ?? 0));
  return deflateSync(Buffer.from(differences.buffer)).toString('base64');
}

function header(moves: number): Header {
  const sources = [{ name: 'main.ngc' }, { name: 'sub.ngc' }];
  return { title: 'main.ngc', quantum: 0.5, moves, tools: [0], chunks: 1, start: [0, 0, 0], kinds: ['rapid', 'feed'], frameKinds: ['call', 'loop'], notes: [], sources, bounds: {} };
}

interface Move {
  readonly kind?: number;
  readonly points: readonly (readonly [number, number, number])[];
  readonly source?: number;
  readonly line?: number;
  readonly frame?: number;
}

function chunk(moves: readonly Move[], frames: readonly (readonly number[])[] = [], text = ''): Chunk {
  const points = moves.flatMap((move) => move.points);
  const columns: Record<string, string> = {
    kind: packed(moves.map(({ kind }) => kind ?? FEED)),
    tool: packed(moves.map(() => 0)),
    row: packed(moves.map((_, i) => i)),
    source: packed(moves.map(({ source }) => source ?? 0)),
    line: packed(moves.map(({ line }, i) => line ?? i)),
    frame: packed(moves.map(({ frame }) => frame ?? -1)),
    vertices: packed(moves.map((move) => move.points.length)),
  };
  'xyz'.split('').forEach((name, axis) => (columns[name] = packed(points.map((point) => point[axis]! * 2))));
  ['Parent', 'Source', 'Row', 'Kind', 'Number'].forEach((name, i) => (columns[`frame${name}`] = packed(frames.map((frame) => frame[i]!))));
  return { columns, text: deflateSync(text).toString('base64') };
}

async function path(moves: readonly Move[]): Promise<Toolpath> {
  const made = new Toolpath(header(moves.length));
  await made.add(chunk(moves));
  return made;
}

test('chunks become moves, points, frames and lines, one behind the other', async () => {
  const made = new Toolpath(header(3));
  await made.add(chunk([{ kind: RAPID, points: [[1, 0, 0]] }, { points: [[2, 1, 0], [3, 0, -1.5]], frame: 1, source: 1, line: 7 }], [[-1, 0, 4, 0, 0], [0, 1, 6, 1, 2]], 'G0 X1\nG2 X3\n'));
  await made.add(chunk([{ points: [[4, 0, 0]], line: 9 }], [], 'G1 X4\n'));
  assert.equal(made.count, 3);
  assert.deepEqual([...made.ends], [1, 3, 4]);
  assert.deepEqual([...made.points.subarray(0, 15)], [0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 0, -1.5, 4, 0, 0]);
  assert.deepEqual(made.stack(1), [
    { parent: 0, source: 1, row: 6, kind: 'loop', number: 2 },
    { parent: -1, source: 0, row: 4, kind: 'call', number: 0 },
  ]);
  assert.deepEqual(made.stack(2), []);
  assert.deepEqual([0, 1, 2, 3].map((row) => made.flat.line(row)), ['G0 X1', 'G2 X3', 'G1 X4', '']);
});

test('a source line has the moves that it made, in its own file only', async () => {
  const made = await path([{ points: [[1, 0, 0]], line: 5 }, { points: [[2, 0, 0]], line: 5, source: 1 }, { points: [[3, 0, 0]], line: 5 }]);
  assert.deepEqual(made.movesOf(0, 5), [0, 2]);
  assert.deepEqual(made.movesOf(1, 5), [1]);
  assert.deepEqual(made.movesOf(0, 6), []);
});

test('bounds leave out shifts', async () => {
  const made = await path([{ points: [[1, -2, 0]] }, { kind: SHIFT, points: [[50, 50, 50]] }, { kind: SHIFT, points: [[1, 1, 1]] }, { points: [[3, 1, 1]] }]);
  assert.deepEqual(made.bounds(), [[0, -2, 0], [3, 1, 1]]);
  assert.equal((await path([])).bounds(), undefined);
});

test('texts in parts have lines, in any script', () => {
  const text = new Text();
  text.append(new TextEncoder().encode('G0 X1\n(M\u00fcll \u{1f60b})\n'));
  assert.equal(text.line(1), '(M\u00fcll \u{1f60b})');
  text.append(new TextEncoder().encode('M2\n'));
  assert.equal(text.count, 3);
  assert.equal(text.line(2), 'M2');
  assert.equal(text.line(-1), '');
});

test('values up to a bound are counted', () => {
  assert.deepEqual([0, 1, 2, 5, 9].map((most) => countUpTo([1, 2, 2, 5], 4, most)), [0, 1, 3, 4, 4]);
  assert.equal(countUpTo([1, 2, 2, 5], 2, 9), 2);
});

test('the segment under the pointer is found, within reach', async () => {
  const made = await path([{ kind: RAPID, points: [[5, 0, 0]] }, { points: [[5, 5, 0]] }, { points: [[0, 5, 0]] }]);
  assert.equal(pick(made, ABOVE, 25, 98, 5, { ...ALL, moves: 3 }), 0);
  assert.equal(pick(made, ABOVE, 53, 75, 5, { ...ALL, moves: 3 }), 1);
  assert.equal(pick(made, ABOVE, 25, 75, 5, { ...ALL, moves: 3 }), undefined);
  assert.equal(pick(made, ABOVE, 25, 50, 5, { ...ALL, moves: 2 }), undefined, 'the slider has not come there');
  assert.equal(pick(made, ABOVE, 25, 98, 5, { moves: 3, rapids: false, cuts: true }), undefined);
});

test('of segments that lie on each other the one in front is found, then the last', async () => {
  const made = await path([{ points: [[5, 0, 0]] }, { points: [[5, 0, 3]] }, { points: [[0, 0, 3]] }, { points: [[5, 0, 3]] }]);
  assert.equal(pick(made, ABOVE, 25, 100, 5, { ...ALL, moves: 4 }), 3);
  assert.equal(pick(made, ABOVE, 25, 100, 5, { ...ALL, moves: 3 }), 2);
  assert.equal(pick(made, ABOVE, 25, 100, 5, { ...ALL, moves: 1 }), 0);
});

test('an arc is one move with all its chords', async () => {
  const made = await path([{ points: [[5, 1, 0], [5, 5, 0]] }]);
  assert.equal(pick(made, ABOVE, 50, 70, 3, { ...ALL, moves: 1 }), 0);
});

test('few segments are all drawn, but for shifts', async () => {
  const made = await path([{ points: [[1, 0, 0], [2, 0, 0]] }, { kind: SHIFT, points: [[2, 0, 9]] }, { points: [[3, 0, 9]] }]);
  const { pairs, moves, tolerance } = await inSteps(thinned(made, 10));
  assert.deepEqual([[...pairs], [...moves], tolerance], [[0, 1, 1, 2, 3, 4], [0, 0, 2], 0]);
});

test('of many segments those that are left out lie within the tolerance of one that is drawn', async () => {
  const moves = Array.from({ length: 3000 }, (_, i): Move => ({ points: [[(i * 37) % 101, Math.floor(i / 30) * 0.5, (i % 7) * 0.5]] }));
  const made = await path(moves);
  const { pairs, moves: of, tolerance } = await inSteps(thinned(made, 400));
  assert.ok(of.length <= 400 && tolerance > 0);
  assert.ok([...of].every((move, i) => i === 0 || move >= of[i - 1]!), 'in the order of the moves');
  const at = (vertex: number): number[] => [...made.points.subarray(3 * vertex, 3 * vertex + 3)];
  for (let i = 0; i < made.count; i += 11) {
    const middle = at(i).map((value, axis) => (value + at(i + 1)[axis]!) / 2);
    const nearest = Math.min(...Array.from(of, (_, n) => away(middle, at(pairs[2 * n]!), at(pairs[2 * n + 1]!))));
    assert.ok(nearest <= tolerance + 1e-6, `move ${i} is ${nearest} off`);
  }
});

function away(point: number[], start: number[], end: number[]): number {
  const way = end.map((value, axis) => value - start[axis]!);
  const square = way.reduce((sum, value) => sum + value * value, 0);
  const part = square ? point.reduce((sum, value, axis) => sum + (value - start[axis]!) * way[axis]!, 0) / square : 0;
  const t = Math.min(1, Math.max(0, part));
  return Math.hypot(...point.map((value, axis) => value - start[axis]! - t * way[axis]!));
}

test('others go on between the steps of long work', async () => {
  let turns = 0;
  const clock = setInterval(() => turns++);
  const began = performance.now();
  function* work(): Generator<void, string> {
    while (performance.now() - began < 200) yield;
    return 'done';
  }
  assert.equal(await inSteps(work()), 'done');
  clearInterval(clock);
  assert.ok(turns >= 3, `only ${turns} turns`);
});
