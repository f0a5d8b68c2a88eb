/** What a report of a fault needs, as a text that the user reads before anybody else does. */
import * as vscode from 'vscode';
import type { Server } from './server';

/** Open a new text with the facts filled in. Nothing is sent. */
export async function report(context: vscode.ExtensionContext, server: Server): Promise<void> {
  const program = vscode.window.activeTextEditor?.document;
  const said = program && (await server.explain(program.uri));
  const content = [
    '# A fault in deburr',
    '',
    'What I did, what I saw, and what I expected (the smallest program that shows it, please):',
    '',
    '```',
    program?.getText(vscode.window.activeTextEditor?.selection) ?? '',
    '```',
    '',
    '| | |',
    '|---|---|',
    `| extension | ${String(context.extension.packageJSON.version)} |`,
    `| server | ${server.info}, ${server.condition}, on ${server.python || 'no Python'} |`,
    `| editor | ${vscode.env.appName} ${vscode.version}, ${process.platform}, ${vscode.env.remoteName ?? 'local'} |`,
    `| language | ${said?.title ? `${said.title} (${said.reason})` : (program?.languageId ?? 'no program is open')} |`,
    '',
    'Settings:',
    '',
    '```json',
    JSON.stringify(server.told(program?.uri), null, 2),
    '```',
    '',
  ].join('\n');
  await vscode.window.showTextDocument(await vscode.workspace.openTextDocument({ language: 'markdown', content }));
}
