import assert from 'node:assert/strict';
import { test } from 'node:test';
import { read, written } from '../src/definitions.ts';

test('values are read as they are written for the command line', () => {
  assert.deepEqual(read('Depth=15, _name=2  PAL[300]=5'), { values: { Depth: '15', _name: '2', 'PAL[300]': '5' }, wrong: undefined });
});

test('a value with blanks stands in quotes', () => {
  const values = { Material: 'Hard Steel', Empty: '' };
  assert.equal(written(values), 'Material="Hard Steel" Empty=""');
  assert.deepEqual(read(written(values)).values, values);
});

test('what cannot be read is named', () => {
  assert.equal(read('Depth=15 Peck').wrong, '`Peck` is no NAME=VALUE');
  assert.equal(read('').wrong, undefined);
});
