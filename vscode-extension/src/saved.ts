/** What an edit does to the flat program: the expansion of the saved or the committed text beside that of the open one. */
import * as vscode from 'vscode';
import { LANGUAGE, type Values } from './expandView';
import type { Expanded } from './preview';
import type { Server } from './server';

const SCHEME = 'deburr-compared';

/** The part of the Git extension's interface that is used. */
interface Git {
  getAPI(version: 1): { getRepository(uri: vscode.Uri): { show(ref: string, path: string): Promise<string> } | null };
}

export class SavedExpansion implements vscode.TextDocumentContentProvider, vscode.Disposable {
  private readonly texts = new Map<string, string>();
  private readonly listener = vscode.workspace.registerTextDocumentContentProvider(SCHEME, this);
  private number = 0;

  constructor(
    private readonly server: Server,
    private readonly values: Values,
  ) {}

  dispose(): void {
    this.listener.dispose();
  }

  provideTextDocumentContent(uri: vscode.Uri): string {
    return this.texts.get(uri.toString()) ?? '';
  }

  /** Show how the flat program of the open text differs from that of an older one. */
  async compare(source: vscode.Uri): Promise<void> {
    const older = await this.older(source);
    if (!older) return;
    const [left, right] = await Promise.all([this.expanded(source, older.text), this.expanded(source, undefined)]);
    if (left === undefined || right === undefined) return;
    const name = source.path.slice(source.path.lastIndexOf('/') + 1);
    await vscode.commands.executeCommand('vscode.diff', left, right, `${name}: expansion of the ${older.name} ↔ the open text`);
  }

  /** The text to compare with; where the file is under version control, the user chooses. */
  private async older(source: vscode.Uri): Promise<{ name: string; text: string } | undefined> {
    const committed = await committedText(source);
    const saved = { label: 'saved file', text: async () => vscode.workspace.decode(await vscode.workspace.fs.readFile(source), { uri: source }) };
    if (committed === undefined) return { name: saved.label, text: await saved.text() };
    const chosen = await vscode.window.showQuickPick([saved, { label: 'committed file', text: async () => committed }]);
    return chosen && { name: chosen.label, text: await chosen.text() };
  }

  private async expanded(source: vscode.Uri, text: string | undefined): Promise<vscode.Uri | undefined> {
    const answer = await this.server.execute<Expanded | null>('deburr.expand', { uri: source.toString(), ...this.values.of(source), text });
    const wrong = answer?.findings.find((each) => each.severity === 1);
    if (!answer || (wrong && !answer.truncated)) {
      void vscode.window.showWarningMessage(`The ${text === undefined ? 'open' : 'older'} text has no expansion: ${wrong?.message ?? 'the language server does not answer'}`);
      return undefined;
    }
    const uri = vscode.Uri.from({ scheme: SCHEME, path: source.path, query: String(++this.number) });
    this.texts.set(uri.toString(), answer.text);
    await vscode.languages.setTextDocumentLanguage(await vscode.workspace.openTextDocument(uri), LANGUAGE);
    return uri;
  }
}

async function committedText(source: vscode.Uri): Promise<string | undefined> {
  const git = vscode.extensions.getExtension<Git>('vscode.git');
  if (!git?.isActive) return undefined;
  try {
    return await git.exports.getAPI(1).getRepository(source)?.show('HEAD', source.fsPath);
  } catch {
    return undefined;
  }
}
