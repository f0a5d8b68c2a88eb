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
    const program = vscode.window.activeTextEditor?.document;
    const language = program?.languageId ?? '';
    this.item.text = `deburr: ${condition}`;
    this.item.detail = python;
    this.item.severity = SEVERITY[condition];
    this.item.busy = condition === 'starting';
    this.item.command = condition === 'running' ? { title: 'Show Log', command: 'deburr.showLog' } : { title: 'Restart', command: 'deburr.restart' };
    this.bar.text = `${ICON[condition]} deburr`;
    this.bar.tooltip = `deburr: ${condition}${python && `, on ${python}`}`;
    if (!program || !this.server.languages.includes(language)) return this.bar.hide();
    this.bar.show();
    void this.name(program);
  }

  /** The language and the profile by which the program is read, once the server has said them. */
  private async name(program: vscode.TextDocument): Promise<void> {
    const said = await this.server.explain(program.uri);
    if (!said?.title || program !== vscode.window.activeTextEditor?.document) return;
    const named = said.profile ? `${said.title}, ${said.profile}` : said.title;
    this.item.text = `deburr: ${named}`;
    this.bar.text = `${ICON[this.server.condition]} deburr: ${named}`;
    this.bar.tooltip = `deburr reads this as ${named} (${said.reason}); it is ${this.server.condition}, on ${this.server.python}`;
  }
}
