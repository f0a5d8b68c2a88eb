/** What programs are given for the preview, remembered for the workspace: values, a toolpath, the block-delete switch. */
import * as vscode from 'vscode';
import { read, written } from './definitions';
import type { Given, Values } from './expandView';
import type { Server } from './server';

const KEY = 'deburr.given';
const NOTHING: Given = { define: {} };
/** The switch's next position: as the machine has it, on, off. */
const NEXT = { '': 'on', on: 'off', off: undefined } as const;

/** A part of what is given, as a row to choose; undefined from `ask`: the user turned away. */
interface Part extends vscode.QuickPickItem {
  ask(): Promise<Given | undefined>;
}

export class Inputs implements Values {
  constructor(
    private readonly memory: vscode.Memento,
    private readonly server: Server,
  ) {}

  of(source: vscode.Uri): Given {
    return this.all()[source.toString()] ?? NOTHING;
  }

  /** Ask for what a program is given; false if the user turned away. */
  async ask(source: vscode.Uri): Promise<boolean> {
    const parts = this.parts(source, (await this.server.explain(source))?.takes ?? []);
    const chosen = parts.length > 1 ? await vscode.window.showQuickPick(parts, { title: 'What the expansion is given' }) : parts[0];
    const given = await chosen?.ask();
    if (given === undefined) return false;
    await this.memory.update(KEY, { ...this.all(), [source.toString()]: given });
    return true;
  }

  private parts(source: vscode.Uri, takes: readonly string[]): Part[] {
    const given = this.of(source);
    const { define, input, blockDelete } = given;
    const parts: Part[] = [{ label: 'Values', description: written(define), ask: async () => withValues(given, await askForValues(define)) }];
    if (takes.includes('input')) {
      const description = input && vscode.workspace.asRelativePath(vscode.Uri.parse(input));
      parts.push({ label: 'Toolpath file', ...(description && { description }), ask: async () => withToolpath(given, await askForToolpath(source)) });
    }
    if (takes.includes('blockDelete')) {
      parts.push({ label: 'Block delete', description: blockDelete ?? 'as it is configured', ask: () => Promise.resolve(switched(given)) });
    }
    if (parts.length > 1) parts.push({ label: 'Forget all of it', ask: () => Promise.resolve(NOTHING) });
    return parts;
  }

  private all(): Record<string, Given> {
    return this.memory.get<Record<string, Given>>(KEY, {});
  }
}

function withValues(given: Given, define: Given['define'] | undefined): Given | undefined {
  return define && { ...given, define };
}

function withToolpath(given: Given, file: vscode.Uri | undefined): Given | undefined {
  return file && { ...given, input: file.toString() };
}

function switched({ blockDelete, ...rest }: Given): Given {
  const next = NEXT[blockDelete ?? ''];
  return next ? { ...rest, blockDelete: next } : rest;
}

async function askForValues(now: Given['define']): Promise<Given['define'] | undefined> {
  const answer = await vscode.window.showInputBox({
    title: 'Values for the expansion',
    prompt: 'As on the command line: Depth=15, _name=2, HA=10, PAL[300]=5; separated by blanks or commas',
    value: written(now),
    validateInput: (text) => read(text).wrong,
  });
  return answer === undefined ? undefined : read(answer).values;
}

async function askForToolpath(source: vscode.Uri): Promise<vscode.Uri | undefined> {
  const chosen = await vscode.window.showOpenDialog({
    title: 'The toolpath that the template is given',
    defaultUri: vscode.Uri.joinPath(source, '..'),
    filters: { Toolpaths: ['cl', 'jsonl'], 'All files': ['*'] },
  });
  return chosen?.[0];
}
