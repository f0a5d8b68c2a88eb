/** The expanded program beside its source: live, read-only, and in step with the cursor on both sides. */
import * as vscode from 'vscode';
import { linesOf, nearestLine, originOf, same, stackOf, told, type FlatMap } from './flatMap';
import { NOTHING, after, type Expanded, type Shown } from './preview';
import type { Server } from './server';

export const SCHEME = 'deburr-preview';
export const LANGUAGE = 'deburr-flat';
const PAUSE_MS = 250;

/** What a program is given, as arguments of `deburr.expand`; a toolpath by its URI. */
export interface Given {
  readonly define: Readonly<Record<string, string>>;
  readonly input?: string;
  readonly blockDelete?: 'on' | 'off';
}

/** What programs are given, remembered for the workspace. */
export interface Values {
  of(source: vscode.Uri): Given;
}

/** All previews of the window. */
export class ExpandView implements vscode.TextDocumentContentProvider, vscode.HoverProvider, vscode.CodeLensProvider, vscode.Disposable {
  private readonly shown = new Map<string, Shown>();
  private readonly timers = new Map<string, NodeJS.Timeout>();
  private readonly texts = new vscode.EventEmitter<vscode.Uri>();
  private readonly banners = new vscode.EventEmitter<void>();
  private readonly listeners: vscode.Disposable[];
  private readonly made = vscode.window.createTextEditorDecorationType({
    backgroundColor: new vscode.ThemeColor('editor.wordHighlightBackground'),
    isWholeLine: true,
    overviewRulerColor: new vscode.ThemeColor('editorOverviewRuler.wordHighlightForeground'),
  });
  readonly onDidChange = this.texts.event;
  readonly onDidChangeCodeLenses = this.banners.event;

  constructor(
    private readonly server: Server,
    private readonly values: Values,
  ) {
    const selector = { scheme: SCHEME };
    this.listeners = [
      this.made,
      vscode.workspace.registerTextDocumentContentProvider(SCHEME, this),
      vscode.languages.registerHoverProvider(selector, this),
      vscode.languages.registerCodeLensProvider(selector, this),
      vscode.workspace.onDidChangeTextDocument(({ document }) => this.edited(document)),
      // Not `onDidCloseTextDocument`: a document is also closed and opened when its language is set.
      vscode.window.tabGroups.onDidChangeTabs(({ closed }) => closed.forEach((tab) => this.closed(tab))),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor }) => this.follow(textEditor)),
      // An editor that is opened at a line says nothing of a selection.
      vscode.window.onDidChangeActiveTextEditor((editor) => editor && this.follow(editor)),
      vscode.window.onDidChangeTextEditorVisibleRanges((event) => this.scrolled(event)),
      server.changed((condition) => condition === 'running' && this.refresh()),
    ];
  }

  dispose(): void {
    for (const timer of this.timers.values()) clearTimeout(timer);
    for (const each of this.listeners) each.dispose();
  }

  /** Open the preview of a program beside it. */
  async open(source: vscode.Uri): Promise<void> {
    const uri = previewOf(source);
    await this.expand(source);
    const document = await vscode.languages.setTextDocumentLanguage(await vscode.workspace.openTextDocument(uri), LANGUAGE);
    await vscode.window.showTextDocument(document, { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true, preview: false });
  }

  /** Expand everything that is shown anew: values or settings have changed. */
  refresh(): void {
    for (const source of this.shown.keys()) void this.expand(vscode.Uri.parse(source));
  }

  /** From a flat line to the line that made it. */
  async goToSource(editor: vscode.TextEditor): Promise<void> {
    const map = this.mapOf(editor.document.uri);
    const origin = map && originOf(map, editor.selection.active.line);
    if (!origin) return;
    const selection = new vscode.Range(origin.row, 0, origin.row, 0);
    await vscode.window.showTextDocument(vscode.Uri.parse(origin.uri), { viewColumn: vscode.ViewColumn.One, selection });
  }

  /** All flat lines that the line under the cursor made, as a list to choose from. */
  async showLines(editor: vscode.TextEditor): Promise<void> {
    await this.open(editor.document.uri);
    const uri = previewOf(editor.document.uri);
    const map = this.mapOf(uri);
    if (!map) return;
    const document = await vscode.workspace.openTextDocument(uri);
    const rows = linesOf(map, editor.document.uri.toString(), editor.selection.active.line);
    const items = rows.map((row) => ({ label: document.lineAt(row).text, description: `line ${row + 1}`, detail: stackOf(map, row).map(told).join(' ← '), row }));
    const chosen = await vscode.window.showQuickPick(items, { placeHolder: `${rows.length} flat lines come from this line` });
    if (chosen) await vscode.window.showTextDocument(document, { viewColumn: vscode.ViewColumn.Beside, selection: new vscode.Range(chosen.row, 0, chosen.row, 0) });
  }

  provideTextDocumentContent(uri: vscode.Uri): string {
    return this.shown.get(sourceOf(uri).toString())?.text ?? '';
  }

  provideHover(document: vscode.TextDocument, position: vscode.Position): vscode.Hover | undefined {
    const map = this.mapOf(document.uri);
    const origin = map && originOf(map, position.line);
    if (!map || !origin) return undefined;
    const lines = [`from ${origin.uri.slice(origin.uri.lastIndexOf('/') + 1)}:${origin.row + 1}`, ...stackOf(map, position.line).map(told)];
    return new vscode.Hover(new vscode.MarkdownString(lines.map((line) => `- ${line}`).join('\n')));
  }

  provideCodeLenses(document: vscode.TextDocument): vscode.CodeLens[] {
    const banner = this.shown.get(sourceOf(document.uri).toString())?.banner;
    return banner ? [new vscode.CodeLens(new vscode.Range(0, 0, 0, 0), { title: `$(warning) ${banner}`, tooltip: banner, command: '' })] : [];
  }

  private mapOf(preview: vscode.Uri): FlatMap | undefined {
    return this.shown.get(sourceOf(preview).toString())?.map;
  }

  private edited(document: vscode.TextDocument): void {
    if (!this.server.languages.includes(document.languageId)) return;
    // A snippet or subroutine is part of programs that do not name it here: all that is shown is expanded anew.
    for (const source of this.shown.keys()) {
      clearTimeout(this.timers.get(source));
      this.timers.set(source, setTimeout(() => void this.expand(vscode.Uri.parse(source)), PAUSE_MS));
    }
  }

  private closed({ input }: vscode.Tab): void {
    if (input instanceof vscode.TabInputText && input.uri.scheme === SCHEME) this.shown.delete(sourceOf(input.uri).toString());
  }

  private async expand(source: vscode.Uri): Promise<void> {
    const key = source.toString();
    const answer = await this.server.execute<Expanded | null>('deburr.expand', { uri: key, ...this.values.of(source) });
    this.shown.set(key, after(this.shown.get(key) ?? NOTHING, answer ?? undefined));
    this.texts.fire(previewOf(source));
    this.banners.fire();
  }

  /** Keep the other side in step with the cursor. */
  private follow(textEditor: vscode.TextEditor): void {
    if (textEditor !== vscode.window.activeTextEditor) return;
    const { uri } = textEditor.document;
    const { line } = textEditor.selection.active;
    // The side of the cursor belongs to nothing.
    textEditor.setDecorations(this.made, []);
    if (uri.scheme === SCHEME) this.markSource(uri, line);
    else for (const preview of vscode.window.visibleTextEditors) this.markFlat(preview, uri, line);
  }

  /** Scroll the other side along, once the cursor is out of sight: until then the other side shows what belongs to the cursor. */
  private scrolled({ textEditor, visibleRanges }: vscode.TextEditorVisibleRangesChangeEvent): void {
    const top = visibleRanges[0]?.start.line;
    const seesCursor = visibleRanges.some((range) => range.contains(textEditor.selection.active));
    // The other side follows; what it then shows must not move this one.
    if (top === undefined || seesCursor || textEditor !== vscode.window.activeTextEditor) return;
    const { uri } = textEditor.document;
    const map = uri.scheme === SCHEME ? this.mapOf(uri) : undefined;
    const origin = map && originOf(map, top);
    for (const editor of vscode.window.visibleTextEditors) {
      const shown = editor.document.uri;
      if (origin && same(origin.uri, shown.toString())) reveal(editor, origin.row);
      const flat = shown.scheme === SCHEME && uri.scheme !== SCHEME ? this.mapOf(shown) : undefined;
      const line = flat && nearestLine(flat, uri.toString(), top);
      if (line !== undefined) reveal(editor, line);
    }
  }

  private markFlat(preview: vscode.TextEditor, source: vscode.Uri, line: number): void {
    if (preview.document.uri.scheme !== SCHEME) return;
    const map = this.mapOf(preview.document.uri);
    if (!map) return;
    const rows = linesOf(map, source.toString(), line);
    this.mark(preview, rows, rows[0] ?? nearestLine(map, source.toString(), line));
  }

  private markSource(preview: vscode.Uri, line: number): void {
    const map = this.mapOf(preview);
    const origin = map && originOf(map, line);
    if (!origin) return;
    for (const editor of vscode.window.visibleTextEditors) {
      if (same(origin.uri, editor.document.uri.toString())) this.mark(editor, [origin.row], origin.row);
    }
  }

  private mark(editor: vscode.TextEditor, rows: readonly number[], shown: number | undefined): void {
    editor.setDecorations(this.made, rows.map((row) => new vscode.Range(row, 0, row, 0)));
    if (shown !== undefined) editor.revealRange(new vscode.Range(shown, 0, shown, 0), vscode.TextEditorRevealType.InCenterIfOutsideViewport);
  }
}

function reveal(editor: vscode.TextEditor, line: number): void {
  editor.revealRange(new vscode.Range(line, 0, line, 0), vscode.TextEditorRevealType.AtTop);
}

/** The preview of a source. */
export function previewOf(source: vscode.Uri): vscode.Uri {
  return vscode.Uri.from({ scheme: SCHEME, path: `${source.path} (expanded)`, query: source.toString() });
}

/** The source of a preview. */
export function sourceOf(preview: vscode.Uri): vscode.Uri {
  return vscode.Uri.parse(preview.query);
}
