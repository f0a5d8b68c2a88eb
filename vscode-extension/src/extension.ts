/** Wires the parts together. Holds no logic of its own. */
import * as vscode from 'vscode';
import type { Location, Position } from 'vscode-languageclient/node';
import { openExample } from './examples';
import { ExpandView } from './expandView';
import { Inputs } from './inputs';
import { PlotView } from './plotView';
import { report } from './report';
import { SavedExpansion } from './saved';
import { Server } from './server';
import { Status } from './status';

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const log = vscode.window.createOutputChannel('deburr', { log: true });
  const languages = languagesOf(context);
  // The manifest's menus ask for it, so that no list of languages stands there.
  await vscode.commands.executeCommand('setContext', 'deburr.languages', languages);
  const server = new Server(context, log, languages);
  const inputs = new Inputs(context.workspaceState, server);
  const view = new ExpandView(server, inputs);
  const saved = new SavedExpansion(server, inputs);
  const plots = new PlotView(context, server, inputs);
  context.subscriptions.push(log, server, view, saved, plots, new Status(server), ...commands(server, view, inputs, saved, plots), ...helping(context, server, log));
  context.subscriptions.push(
    vscode.workspace.onDidGrantWorkspaceTrust(() => void server.start()),
    vscode.workspace.onDidChangeConfiguration((event) => {
      if (['deburr.interpreter', 'deburr.server'].some((name) => event.affectsConfiguration(name))) void server.start();
    }),
  );
  await server.start();
}

function commands(server: Server, view: ExpandView, inputs: Inputs, saved: SavedExpansion, plots: PlotView): vscode.Disposable[] {
  const register = vscode.commands.registerCommand;
  const editor = (act: (editor: vscode.TextEditor) => Promise<unknown>) => async () => {
    const active = vscode.window.activeTextEditor;
    if (active) await act(active);
  };
  return [
    // The code lens of the server names the program; the palette means the one that is open.
    register('deburr.showExpansion', async (uri?: unknown) => {
      const source = uri instanceof vscode.Uri ? uri : vscode.window.activeTextEditor?.document.uri;
      if (source) await view.open(source);
    }),
    register('deburr.showToolpath', editor(async (active) => plots.open(active.document.uri))),
    register('deburr.goToSource', editor((active) => view.goToSource(active))),
    register('deburr.showLines', editor((active) => view.showLines(active))),
    register('deburr.diffExpansion', editor((active) => saved.compare(active.document.uri))),
    register('deburr.setInputs', editor(async ({ document }) => (await inputs.ask(document.uri)) && (view.refresh(), plots.refresh()))),
    register('deburr.showReferences', (uri: string, position: Position, places: Location[]) => server.showReferences(uri, position, places)),
  ];
}

/** Commands that are about deburr itself. */
function helping(context: vscode.ExtensionContext, server: Server, log: vscode.LogOutputChannel): vscode.Disposable[] {
  const register = vscode.commands.registerCommand;
  return [
    register('deburr.openExample', () => openExample(context)),
    register('deburr.reportIssue', () => report(context, server)),
    register('deburr.restart', () => server.start()),
    register('deburr.showLog', () => log.show()),
    register('deburr.showVersion', () => vscode.window.showInformationMessage(`${server.info}, on ${server.python || 'no Python'}`)),
  ];
}

/** The languages of the manifest that have programs; flat programs have a language for colours only. */
function languagesOf(context: vscode.ExtensionContext): string[] {
  const said = context.extension.packageJSON.contributes.languages as { id: string; extensions?: string[] }[];
  return said.filter((each) => each.extensions).map((each) => each.id);
}
