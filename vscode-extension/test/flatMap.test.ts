import assert from 'node:assert/strict';
import { test } from 'node:test';
import { linesOf, nearestLine, originOf, stackOf, told, type FlatMap } from '../src/flatMap.ts';

// A program of three lines that calls `peck` from line 2; there a loop in line 4 runs twice over line 5.
const map: FlatMap = {
  sources: ['file:///a/main.ngc', 'file:///a/peck.ngc'],
  x_deburr_frames: [
    [-1, 0, 1, 'call', 1],
    [0, 1, 3, 'loop', 1],
    [0, 1, 3, 'loop', 2],
  ],
  x_deburr_lines: [
    [0, 0, -1],
    [1, 4, 1],
    [1, 4, 2],
    [0, 2, -1],
  ],
};

test('a flat line knows its origin and what is above it, the innermost first', () => {
  assert.deepEqual(originOf(map, 2), { uri: 'file:///a/peck.ngc', row: 4 });
  assert.deepEqual(stackOf(map, 2).map(told), ['pass 2 of the loop at peck.ngc:4', 'call at main.ngc:2']);
  assert.deepEqual(stackOf(map, 0), []);
});

test('a line that is not there has no origin', () => {
  assert.equal(originOf(map, 4), undefined);
  assert.deepEqual(stackOf(map, 4), []);
});

test('a source line knows all its flat lines', () => {
  assert.deepEqual(linesOf(map, 'file:///a/peck.ngc', 4), [1, 2]);
  assert.deepEqual(linesOf(map, 'file:///a/main.ngc', 1), []);
  assert.deepEqual(linesOf(map, 'file:///a/other.ngc', 0), []);
});

test('a URI is the same however its colon and letters are written', () => {
  const windows: FlatMap = { ...map, sources: ['file:///C:/a b.ngc', ''] };
  assert.deepEqual(linesOf(windows, 'file:///c%3A/a%20b.ngc', 0), [0]);
});

test('a line that makes nothing shows what stands above it', () => {
  assert.equal(nearestLine(map, 'file:///a/main.ngc', 1), 0);
  assert.equal(nearestLine(map, 'file:///a/peck.ngc', 3), undefined);
});
