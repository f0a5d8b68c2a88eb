/** The language server: found, started, restarted, and never started for a folder that is not trusted. */
import * as path from 'node:path';
import { setTimeout } from 'node:timers/promises';
import * as vscode from 'vscode';
import { LanguageClient, State, type LanguageClientOptions, type Location, type Position, type ServerOptions, type StaticFeature } from 'vscode-languageclient/node';
import { candidates, choose, type Refusal } from './interpreter';
import { told } from './settings';

/** What the server may run on: whatever there is, only a Python of the machine, only what comes with the extension. */
export type Mode = 'auto' | 'python' | 'bundled';
export type Condition = 'starting' | 'running' | 'stopped' | 'untrusted' | 'no Python';

/** What the server answers to `deburr.explainDialect`. */
export interface Explained {
  readonly reason: string;
  /** The language's name; undefined with all below if it is in none that is known. */
  readonly title?: string;
  /** Whose manual decides, where the language has several. */
  readonly profile?: string | null;
  /** Arguments of `deburr.expand` that the language heeds. */
  readonly takes?: readonly string[];
}

/** One server for the window; `changed` tells of its condition. */
export class Server implements vscode.Disposable {
  private client: LanguageClient | undefined;
  private generation = 0;
  private turn: Promise<void> = Promise.resolve();
  private readonly conditions = new vscode.EventEmitter<Condition>();
  readonly changed = this.conditions.event;
  condition: Condition = 'stopped';
  python = '';

  constructor(
    private readonly context: vscode.ExtensionContext,
    readonly log: vscode.LogOutputChannel,
    readonly languages: readonly string[],
  ) {}

  /** Start it, or start it again. Who asks while it starts waits for that: two servers at once would both own its commands. */
  start(): Promise<void> {
    const generation = ++this.generation;
    this.turn = this.turn.then(() => (generation === this.generation ? this.restart() : undefined));
    return this.turn;
  }

  private async restart(): Promise<void> {
    await this.stop();
    if (!vscode.workspace.isTrusted) return this.become('untrusted');
    this.become('starting');
    const interpreter = this.setting<string[]>('interpreter') ?? [];
    const mode = this.setting<Mode>('server') ?? 'auto';
    const choice = mode === 'bundled' ? { refused: [] } : await choose(candidates(interpreter, await ofPythonExtension(), process.platform));
    if ('found' in choice) {
      this.python = `${choice.found.command.join(' ')} (Python ${choice.version}, ${choice.found.from})`;
      return this.run(this.onPython(choice.found.command));
    }
    for (const { candidate, why } of choice.refused) this.log.warn(`\`${candidate.command.join(' ')}\` (${candidate.from}) ${why}`);
    // A setting that names a Python is meant: a mistake in it is said, and nothing else is run in its place.
    if (mode === 'python' || (mode === 'auto' && interpreter.length > 0)) return this.refuse(choice.refused);
    this.python = 'the bundled runtime';
    return this.run(this.onBundled());
  }

  /** Ask the server to do one of its commands; undefined while there is no server. */
  async execute<T>(command: string, argument: object): Promise<T | undefined> {
    if (this.client?.state !== State.Running) return undefined;
    return this.client.sendRequest<T>('workspace/executeCommand', { command, arguments: [argument] });
  }

  /** In which language the server takes a file to be, and what an expansion of it can be given. */
  async explain(source: vscode.Uri): Promise<Explained | undefined> {
    return this.execute<Explained>('deburr.explainDialect', { uri: source.toString() });
  }

  /** Show places that the server has found; its code lens over a definition asks for it. */
  async showReferences(uri: string, position: Position, places: Location[]): Promise<void> {
    const convert = this.client?.protocol2CodeConverter;
    if (!convert) return;
    const found = places.map((place) => convert.asLocation(place));
    await vscode.commands.executeCommand('editor.action.showReferences', vscode.Uri.parse(uri), convert.asPosition(position), found);
  }

  /** What the server says of itself. */
  get info(): string {
    const said = this.client?.initializeResult?.serverInfo;
    return said ? `${said.name} ${said.version ?? ''}`.trim() : this.condition;
  }

  async stop(): Promise<void> {
    const client = this.client;
    this.client = undefined;
    await client?.dispose().catch((error: unknown) => this.log.warn(`the server did not stop well: ${String(error)}`));
  }

  dispose(): void {
    void this.stop();
  }

  private onPython([command, ...first]: readonly [string, ...string[]]): ServerOptions {
    return { command, args: [...first, '-I', this.bundled('serve.py')] };
  }

  /** Python in WebAssembly, run by the editor's own Node: slower to start, but always there. */
  private onBundled(): ServerOptions {
    return { command: process.execPath, args: [this.bundled('pyodide.mjs')], options: { env: { ...process.env, ELECTRON_RUN_AS_NODE: '1' } } };
  }

  private bundled(name: string): string {
    return path.join(this.context.extensionPath, 'bundled', name);
  }

  private async run(options: ServerOptions): Promise<void> {
    this.log.info(`the server runs on ${this.python}`);
    const client = new LanguageClient('deburr', 'deburr', options, this.clientOptions());
    this.client = client;
    client.registerFeature(ABLE);
    client.onDidChangeState(({ newState }) => {
      if (client === this.client) this.become(newState === State.Running ? 'running' : newState === State.Starting ? 'starting' : 'stopped');
    });
    try {
      await Promise.race([client.start(), silence(PATIENCE)]);
    } catch (error) {
      this.become('stopped');
      void this.offer(`The language server could not be started: ${String(error)}`);
    }
  }

  private clientOptions(): LanguageClientOptions {
    const schemes = ['file', 'untitled', 'vscode-notebook-cell'];
    return {
      documentSelector: this.languages.flatMap((language) => schemes.map((scheme) => ({ scheme, language }))),
      outputChannel: this.log,
      initializationOptions: this.told(undefined),
      middleware: {
        // The server's code lens asks for the flat program: here it is shown, not only answered.
        executeCommand: (command, args: unknown[], next) =>
          command === 'deburr.expand' ? vscode.commands.executeCommand('deburr.showExpansion', uriOf(args)) : next(command, args),
        workspace: {
          configuration: (params) => params.items.map((item) => this.told(item.scopeUri ? vscode.Uri.parse(item.scopeUri) : undefined)),
        },
      },
    };
  }

  /** What the user has set, for a file. */
  told(file: vscode.Uri | undefined): Record<string, unknown> {
    const pages = this.context.extension.packageJSON.contributes.configuration as { properties: Record<string, unknown> }[];
    const names = pages.flatMap((page) => Object.keys(page.properties)).map((name) => name.slice('deburr.'.length));
    const configuration = vscode.workspace.getConfiguration('deburr', file);
    return told(names, (name) => configuration.inspect(name));
  }

  private setting<T>(name: string): T | undefined {
    return vscode.workspace.getConfiguration('deburr').get<T>(name);
  }

  private refuse(refused: readonly Refusal[]): void {
    this.become('no Python');
    const [first] = refused;
    const reason = first?.candidate.from === 'setting' ? `\`${first.candidate.command.join(' ')}\` in deburr.interpreter ${first.why}` : 'no Python 3.11 or newer was found';
    void this.offer(`deburr cannot start: ${reason}.`, 'Open Settings');
  }

  /** An error with ways out. */
  private async offer(message: string, ...more: string[]): Promise<void> {
    const answer = await vscode.window.showErrorMessage(message, ...more, 'Show Log', 'Try Again');
    if (answer === 'Show Log') this.log.show();
    if (answer === 'Open Settings') await vscode.commands.executeCommand('workbench.action.openSettings', 'deburr.interpreter');
    if (answer === 'Try Again') await this.start();
  }

  private become(condition: Condition): void {
    this.condition = condition;
    this.conditions.fire(condition);
  }
}

/** Milliseconds after which a server that says nothing is given up: it would hold up whoever starts it again. */
const PATIENCE = 60_000;

async function silence(milliseconds: number): Promise<never> {
  await setTimeout(milliseconds, undefined, { ref: false });
  throw new Error(`it has not answered for ${milliseconds / 1000} seconds`);
}

/** What this client can do that the protocol has no name for. */
const ABLE: StaticFeature = {
  fillClientCapabilities: (capabilities) => {
    capabilities.experimental = { ...(capabilities.experimental as object | undefined), commands: { commands: ['deburr.showReferences'] } };
  },
  initialize: () => undefined,
  getState: () => ({ kind: 'static' }),
  clear: () => undefined,
};

function uriOf([argument]: readonly unknown[]): vscode.Uri | undefined {
  const said = (argument as { uri?: unknown } | undefined)?.uri;
  return typeof said === 'string' ? vscode.Uri.parse(said) : undefined;
}

/** The interpreter that the Python extension has chosen, if it is installed. */
async function ofPythonExtension(): Promise<string | undefined> {
  const extension = vscode.extensions.getExtension('ms-python.python');
  if (!extension) return undefined;
  try {
    const api = (await extension.activate()) as { environments?: { getActiveEnvironmentPath(): { path: string } } };
    return api.environments?.getActiveEnvironmentPath().path;
  } catch {
    return undefined;
  }
}
