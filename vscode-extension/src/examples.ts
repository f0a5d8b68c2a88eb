/** Small programs with a mistake in each, to see what deburr does without a program at hand. */
import * as vscode from 'vscode';

interface Language {
  readonly id: string;
  readonly aliases: readonly [string, ...string[]];
  readonly extensions?: readonly [string, ...string[]];
}

/** Open the example of a language that the user chooses, as a text without a file. */
export async function openExample(context: vscode.ExtensionContext): Promise<void> {
  const { languages } = context.extension.packageJSON.contributes as { languages: Language[] };
  const items = languages.flatMap(({ id, aliases, extensions }) => (extensions ? [{ label: aliases[0], id, file: `example${extensions[0]}` }] : []));
  const chosen = await vscode.window.showQuickPick(items, { placeHolder: 'In which language?' });
  if (!chosen) return;
  const file = vscode.Uri.joinPath(context.extensionUri, 'walkthrough', chosen.file);
  const content = await vscode.workspace.decode(await vscode.workspace.fs.readFile(file));
  await vscode.window.showTextDocument(await vscode.workspace.openTextDocument({ language: chosen.id, content }));
}
