import assert from 'node:assert/strict';
import { test } from 'node:test';
import { told, type Inspected } from '../src/settings.ts';

const inspect = (said: Record<string, Inspected>) => (name: string) => said[name];

test('only what somebody has set is told: a default would lie over the configuration file', () => {
  const said = { 'check.run': { defaultValue: true } as Inspected, 'check.fail-on': { globalValue: 'warning' } };
  assert.deepEqual(told(['check.run', 'check.fail-on'], inspect(said)), { check: { 'fail-on': 'warning' } });
});

test('the nearest setting wins, false and empty ones too', () => {
  const said = { 'check.run': { globalValue: true, workspaceValue: true, workspaceFolderValue: false } };
  assert.deepEqual(told(['check.run'], inspect(said)), { check: { run: false } });
});

test('the extension keeps its own settings to itself', () => {
  const said = { interpreter: { globalValue: ['python3'] }, 'trace.server': { globalValue: 'off' }, server: { globalValue: 'auto' } };
  assert.deepEqual(told(['interpreter', 'trace.server', 'server'], inspect(said)), {});
});

test('null means not set', () => {
  assert.deepEqual(told(['z32.axes'], inspect({ 'z32.axes': { globalValue: null } })), {});
});
