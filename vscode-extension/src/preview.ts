/** What the preview of a program shows: the newest expansion that there is, kept while the source is faulty. Knows no editor. */
import type { FlatMap } from './flatMap';

/** What the server answers to `deburr.expand`. */
export interface Expanded {
  readonly uri: string;
  readonly text: string;
  readonly sourceMap: FlatMap;
  readonly findings: readonly { readonly severity?: number; readonly message: string }[];
  readonly truncated: boolean;
}

export interface Shown {
  readonly text: string;
  readonly map: FlatMap | undefined;
  /** What a reader must know of the text; empty: it is whole and new. */
  readonly banner: string;
}

export const NOTHING: Shown = { text: '', map: undefined, banner: 'not expanded yet' };
const ERROR = 1;

/** What is shown after an answer. A faulty program has no expansion: the last one stays, and the banner says so. */
export function after(before: Shown, answer: Expanded | undefined): Shown {
  if (!answer) return { ...before, banner: 'the language server does not answer' };
  const wrong = answer.findings.filter((each) => each.severity === ERROR);
  if (answer.truncated) return { text: answer.text, map: answer.sourceMap, banner: `cut after ${answer.sourceMap.x_deburr_lines.length} lines` };
  const [first] = wrong;
  if (first) return { ...before, banner: `${before.map ? 'the last good expansion: ' : ''}the program has ${counted(wrong.length)}: ${first.message}` };
  return { text: answer.text, map: answer.sourceMap, banner: '' };
}

function counted(number: number): string {
  return number === 1 ? 'an error' : `${number} errors`;
}
