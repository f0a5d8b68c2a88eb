/** What the status bar says: which language a program is in, and how the server is. */
import * as vscode from 'vscode';
import type { Condition, Server } from './server';

const SEVERITY: Record<Condition, vscode.LanguageStatusSeverity> = {
  starting: vscode.LanguageStatusSeverity.Information,
  running: vscode.LanguageStatusSeverity.Information,
  stopped: vscode.LanguageStatusSeverity.Error,
  untrusted: vscode.LanguageStatusSeverity.Warning,
  'no Python': vscode.LanguageStatusSeverity.Error,
};
const ICON: Record<Condition, string> = {
  starting: '$(loading~spin)',
  running: '$(check)',
  stopped: '$(error)',
  untrusted: '$(workspace-untrusted)',
  'no Python': '$(error)',
};

/** An item in the status bar and one behind the braces. */
export class Status implements vscode.Disposable {
  private readonly bar = vscode.window.createStatusBarItem('deburr', vscode.StatusBarAlignment.Right, 100);
  private readonly item: vscode.LanguageStatusItem;
  private readonly listeners: vscode.Disposable[];

  constructor(private readonly server: Server) {
    this.item = vscode.languages.createLanguageStatusItem('deburr', server.languages.map((language) => ({ language })));
    this.bar.name = 'deburr';
    this.bar.command = 'deburr.showLog';
    this.listeners = [server.changed(() => this.show()), vscode.window.onDidChangeActiveTextEditor(() => this.show())];
    this.show();
  }

  dispose(): void {
    for (const each of [this.bar, this.item, ...this.listeners]) each.dispose();
  }

  private show(): void {
    const { condition, python } = this.server;
    const language = vscode.window.activeTextEditor?.document.languageId ?? '';
    this.item.text = `deburr: ${condition}`;
    this.item.detail = python;
    this.item.severity = SEVERITY[condition];
    this.item.busy = condition === 'starting';
    this.item.command = condition === 'running' ? { title: 'Show Log', command: 'deburr.showLog' } : { title: 'Restart', command: 'deburr.restart' };
    this.bar.text = `${ICON[condition]} deburr`;
    this.bar.tooltip = `deburr: ${condition}${python && `, on ${python}`}`;
    if (this.server.languages.includes(language)) this.bar.show();
    else this.bar.hide();
  }
}
