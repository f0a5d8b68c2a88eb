import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NOTHING, after, type Expanded } from '../src/preview.ts';

const map = { sources: ['file:///a.ngc'], x_deburr_frames: [], x_deburr_lines: [[0, 0, -1]] as [number, number, number][] };
const good: Expanded = { uri: 'file:///a.ngc', text: 'G0 X1\n', sourceMap: map, findings: [], truncated: false };
const faulty: Expanded = { ...good, text: '', findings: [{ severity: 1, message: 'no end' }, { severity: 2, message: 'odd' }] };

test('a new expansion is shown as it is', () => {
  assert.deepEqual(after(NOTHING, good), { text: 'G0 X1\n', map, banner: '' });
});

test('warnings do not hide an expansion', () => {
  assert.equal(after(NOTHING, { ...good, findings: [{ severity: 2, message: 'odd' }] }).text, 'G0 X1\n');
});

test('while the source is faulty the last good expansion stays, and the banner says so', () => {
  const shown = after(after(NOTHING, good), faulty);
  assert.deepEqual(shown, { text: 'G0 X1\n', map, banner: 'the last good expansion: the program has an error: no end' });
});

test('a program that was faulty from the start has no expansion', () => {
  assert.deepEqual(after(NOTHING, faulty), { text: '', map: undefined, banner: 'the program has an error: no end' });
});

test('an expansion that was cut is shown, and so is that it was', () => {
  assert.equal(after(NOTHING, { ...good, truncated: true, findings: faulty.findings }).banner, 'cut after 1 lines');
});

test('without an answer nothing is lost', () => {
  assert.equal(after(after(NOTHING, good), undefined).text, 'G0 X1\n');
});
