/** Which Python runs the server: the first candidate that is new enough. Knows no editor. */
import { execFile } from 'node:child_process';

export const OLDEST: readonly [number, number] = [3, 11];

/** A command line that starts a Python, and who named it. */
export interface Candidate {
  readonly command: readonly [string, ...string[]];
  readonly from: 'setting' | 'Python extension' | 'PATH';
}

export interface Refusal {
  readonly candidate: Candidate;
  readonly why: string;
}

export type Choice = { readonly found: Candidate; readonly version: string } | { readonly refused: readonly Refusal[] };

/** Runs a command line and gives what it printed. */
export type Run = (command: readonly [string, ...string[]], args: readonly string[]) => Promise<string>;

/** The candidates in their order; a setting that names one is the only one, so that a mistake in it is seen. */
export function candidates(setting: readonly string[], extension: string | undefined, platform: string): Candidate[] {
  const [first, ...rest] = setting;
  if (first) return [{ command: [first, ...rest], from: 'setting' }];
  const path: [string, ...string[]][] = platform === 'win32' ? [['py', '-3'], ['python'], ['python3']] : [['python3'], ['python']];
  const known: Candidate[] = path.map((command) => ({ command, from: 'PATH' }));
  return extension ? [{ command: [extension], from: 'Python extension' }, ...known] : known;
}

/** The first candidate that is new enough, or why none is. */
export async function choose(list: readonly Candidate[], run: Run = runPython): Promise<Choice> {
  const refused: Refusal[] = [];
  for (const candidate of list) {
    const version = await versionOf(candidate, run);
    if (typeof version === 'string') refused.push({ candidate, why: version });
    else if (newEnough(version)) return { found: candidate, version: version.join('.') };
    else refused.push({ candidate, why: `is Python ${version.join('.')}; ${OLDEST.join('.')} or newer is needed` });
  }
  return { refused };
}

async function versionOf(candidate: Candidate, run: Run): Promise<[number, number] | string> {
  try {
    const said = /^(\d+)\.(\d+)\s*$/.exec(await run(candidate.command, ['-I', '-c', 'import sys;print("%d.%d" % sys.version_info[:2])']));
    return said ? [Number(said[1]), Number(said[2])] : 'does not answer as Python does';
  } catch (error) {
    return (error as NodeJS.ErrnoException).code === 'ENOENT' ? 'is not there' : 'cannot be started';
  }
}

function newEnough([major, minor]: [number, number]): boolean {
  return major > OLDEST[0] || (major === OLDEST[0] && minor >= OLDEST[1]);
}

function runPython([file, ...first]: readonly [string, ...string[]], args: readonly string[]): Promise<string> {
  return new Promise((resolve, reject) =>
    execFile(file, [...first, ...args], { timeout: 10_000 }, (error, stdout) => (error ? reject(error) : resolve(stdout))),
  );
}
