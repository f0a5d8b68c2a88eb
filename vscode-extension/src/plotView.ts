/** The toolpath of a program beside it: it follows the cursor, and a click on a move goes to the line that made it. */
import * as vscode from 'vscode';
import type { Values } from './expandView';
import type { Server } from './server';
import { messages, type Answer } from './toolpath';

const PAUSE_MS = 400;

/** What the view says. */
type Said = { readonly type: 'ready' } | { readonly type: 'chosen'; readonly uri?: string; readonly line: number };

interface Shown {
  readonly panel: vscode.WebviewPanel;
  /** Counts what was begun: what was overtaken is not sent on. */
  turn: number;
  timer?: NodeJS.Timeout;
}

/** All toolpaths of the window. */
export class PlotView implements vscode.Disposable {
  private readonly shown = new Map<string, Shown>();
  private readonly listeners: vscode.Disposable[];
  private readonly place: vscode.Uri;
  private readonly icon: vscode.Uri;

  constructor(
    context: vscode.ExtensionContext,
    private readonly server: Server,
    private readonly values: Values,
  ) {
    this.icon = vscode.Uri.joinPath(context.extensionUri, 'icons', 'toolpath.svg');
    // The page of `deburr plot` holds the same script.
    this.place = vscode.Uri.joinPath(context.extensionUri, 'bundled', 'libs', 'deburr', 'plot');
    this.listeners = [
      vscode.workspace.onDidChangeTextDocument(({ document }) => server.languages.includes(document.languageId) && this.refresh()),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor }) => this.point(textEditor)),
      server.changed((condition) => condition === 'running' && this.refresh()),
    ];
  }

  dispose(): void {
    for (const each of this.listeners) each.dispose();
    for (const { panel, timer } of this.shown.values()) {
      clearTimeout(timer);
      panel.dispose();
    }
  }

  /** Open the view of a program beside it, or show the one that there is. */
  open(source: vscode.Uri): void {
    const key = source.toString();
    const there = this.shown.get(key);
    if (there) return there.panel.reveal(undefined, true);
    const name = source.path.slice(source.path.lastIndexOf('/') + 1);
    const panel = vscode.window.createWebviewPanel(
      'deburr.toolpath',
      `${name} (toolpath)`,
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, localResourceRoots: [this.place], retainContextWhenHidden: true },
    );
    panel.iconPath = this.icon;
    const shown: Shown = { panel, turn: 0 };
    this.shown.set(key, shown);
    panel.onDidDispose(() => {
      clearTimeout(shown.timer);
      this.shown.delete(key);
    });
    panel.webview.onDidReceiveMessage((said: Said) => (said.type === 'ready' ? this.send(key) : this.reveal(said)));
    panel.webview.html = page(panel.webview, this.place);
  }

  /** Draw everything that is shown anew, after a pause. A subprogram is part of programs that do not name it here. */
  refresh(): void {
    for (const [key, shown] of this.shown) {
      clearTimeout(shown.timer);
      shown.timer = setTimeout(() => void this.send(key), PAUSE_MS);
    }
  }

  private async send(key: string): Promise<void> {
    const shown = this.shown.get(key);
    if (!shown) return;
    const turn = ++shown.turn;
    const source = vscode.Uri.parse(key);
    const ask = (more: object): Promise<Answer | null | undefined> => this.server.execute<Answer | null>('deburr.plot', { uri: key, ...this.values.of(source), ...more });
    for await (const message of messages(ask)) {
      if (turn !== shown.turn || !this.shown.has(key)) return;
      await shown.panel.webview.postMessage(message);
    }
    for (const editor of vscode.window.visibleTextEditors) this.point(editor);
  }

  /** Let the moves of the line under the cursor shine. */
  private point(editor: vscode.TextEditor): void {
    if (!this.server.languages.includes(editor.document.languageId)) return;
    const message = { type: 'cursor', uri: editor.document.uri.toString(), line: editor.selection.active.line };
    for (const { panel } of this.shown.values()) void panel.webview.postMessage(message);
  }

  private async reveal({ uri, line }: { readonly uri?: string; readonly line: number }): Promise<void> {
    if (!uri) return;
    const target = vscode.Uri.parse(uri);
    const open = vscode.window.visibleTextEditors.find(({ document }) => document.uri.toString() === target.toString());
    const selection = new vscode.Range(line, 0, line, 0);
    await vscode.window.showTextDocument(target, { viewColumn: open?.viewColumn ?? vscode.ViewColumn.One, selection });
  }
}

/** A page that may run the viewer's script and nothing else. */
function page(webview: vscode.Webview, place: vscode.Uri): string {
  const script = webview.asWebviewUri(vscode.Uri.joinPath(place, 'viewer.js'));
  const policy = `default-src 'none'; script-src ${webview.cspSource}`;
  return `<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${policy}"></head>
<body><div id="deburr"></div><script src="${script}"></script></body></html>`;
}
