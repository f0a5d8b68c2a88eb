import assert from 'node:assert/strict';
import { test } from 'node:test';
import { candidates, choose, type Candidate } from '../src/interpreter.ts';

const missing = Object.assign(new Error('spawn'), { code: 'ENOENT' });
const answers = (said: Record<string, string | Error>) => async (command: readonly string[]) => {
  const found = said[command.join(' ')] ?? missing;
  if (found instanceof Error) throw found;
  return found;
};
const names = (list: readonly Candidate[]) => list.map((each) => each.command.join(' '));

test('a setting is the only candidate, so that a mistake in it is seen', () => {
  assert.deepEqual(names(candidates(['py', '-3.12'], '/venv/python', 'win32')), ['py -3.12']);
});

test('the Python extension comes before the PATH, which is asked as each system has it', () => {
  assert.deepEqual(names(candidates([], '/venv/python', 'linux')), ['/venv/python', 'python3', 'python']);
  assert.deepEqual(names(candidates([], undefined, 'win32')), ['py -3', 'python', 'python3']);
});

test('the first that is new enough is taken', async () => {
  const choice = await choose(candidates([], undefined, 'linux'), answers({ python3: '3.10\n', python: '3.11\n' }));
  assert.ok('found' in choice);
  assert.deepEqual([choice.found.command, choice.version], [['python'], '3.11']);
});

test('a version is compared as numbers, not as text', async () => {
  assert.ok('refused' in (await choose(candidates([], undefined, 'linux'), answers({ python3: '3.9', python: '2.7' }))));
  assert.ok('found' in (await choose(candidates([], undefined, 'linux'), answers({ python3: '4.0' }))));
});

test('each refusal has its reason', async () => {
  const choice = await choose(candidates([], '/venv/python', 'linux'), answers({ '/venv/python': '3.10', python: 'hello' }));
  assert.ok('refused' in choice);
  assert.deepEqual(
    choice.refused.map((each) => each.why),
    ['is Python 3.10; 3.11 or newer is needed', 'is not there', 'does not answer as Python does'],
  );
});

test('the Python of this machine answers', async () => {
  const choice = await choose(candidates([], undefined, process.platform));
  assert.ok('found' in choice);
});
