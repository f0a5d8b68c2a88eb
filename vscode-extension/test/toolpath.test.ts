import assert from 'node:assert/strict';
import { test } from 'node:test';
import { messages, type Answer, type Message } from '../src/toolpath.ts';

async function all(answers: readonly (Answer | null | undefined)[], asked: object[] = []): Promise<Message[]> {
  const left = [...answers];
  const found: Message[] = [];
  const ask = (more: object): Promise<Answer | null | undefined> => {
    asked.push(more);
    return Promise.resolve(left.shift());
  };
  for await (const message of messages(ask)) found.push(message);
  return found;
}

test('chunks are asked for by their numbers and the stamp of the first', async () => {
  const asked: object[] = [];
  const found = await all([{ stamp: 7, chunks: 2, header: 'h', segments: 'a' }, { stamp: 7, chunks: 2, segments: 'b' }], asked);
  assert.deepEqual(asked, [{}, { chunk: 1, stamp: 7 }]);
  assert.deepEqual(found, [{ type: 'header', header: 'h' }, { type: 'chunk', chunk: 'a' }, { type: 'chunk', chunk: 'b' }, { type: 'state', text: '' }]);
});

test('a program that changes meanwhile is asked for from the first chunk on', async () => {
  const found = await all([
    { stamp: 7, chunks: 2, header: 'h', segments: 'a' },
    { stamp: 8, chunks: 1, segments: null },
    { stamp: 8, chunks: 1, header: 'i', segments: 'c' },
  ]);
  assert.deepEqual(found.map((each) => each.type), ['header', 'chunk', 'header', 'chunk', 'state']);
});

test('a program that always changes is given up', async () => {
  const [first, stale] = [{ stamp: 1, chunks: 2, header: 'h', segments: 'a' }, { stamp: 2, chunks: 2, segments: null }];
  const found = await all([first, stale, first, stale, first, stale]);
  assert.match((found.at(-1) as { text: string }).text, /changes faster/);
});

test('without a server, or with errors, what is shown stays and a line says why', async () => {
  assert.match(((await all([undefined]))[0] as { text: string }).text, /no language server/);
  const [told, ...rest] = await all([{ stamp: 1, chunks: 1, segments: null, findings: [1] }]);
  assert.deepEqual(rest, []);
  assert.match((told as { text: string }).text, /has a finding: what is shown is older/);
});

test('a run that was cut says so', async () => {
  const found = await all([{ stamp: 1, chunks: 1, header: 'h', segments: 'a', truncated: true }]);
  assert.match((found.at(-1) as { text: string }).text, /cut at its limit/);
});
