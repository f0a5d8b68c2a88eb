/** Values that programs are given for the preview, remembered for the workspace. */
import * as vscode from 'vscode';
import { read, written } from './definitions';
import type { Values } from './expandView';

const KEY = 'deburr.values';

export class Inputs implements Values {
  constructor(private readonly memory: vscode.Memento) {}

  of(source: vscode.Uri): Record<string, string> {
    return this.memory.get<Record<string, Record<string, string>>>(KEY, {})[source.toString()] ?? {};
  }

  /** Ask for the values of a program; false if the user turned away. */
  async ask(source: vscode.Uri): Promise<boolean> {
    const answer = await vscode.window.showInputBox({
      title: 'Values for the expansion',
      prompt: 'As on the command line: Depth=15, _name=2, HA=10, PAL[300]=5; separated by blanks or commas',
      value: written(this.of(source)),
      validateInput: (text) => read(text).wrong,
    });
    if (answer === undefined) return false;
    const all = this.memory.get<Record<string, Record<string, string>>>(KEY, {});
    await this.memory.update(KEY, { ...all, [source.toString()]: read(answer).values });
    return true;
  }
}
