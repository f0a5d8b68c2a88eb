/** A program's toolpath as the server hands it out: asked for chunk by chunk, and passed on as messages to the view. Knows no editor. */

/** What the server answers to `deburr.plot`; the viewer knows what stands in `header` and `segments`. */
export interface Answer {
  readonly stamp: number;
  readonly chunks: number;
  /** Nothing, if the program has errors or has become another one since the stamp. */
  readonly segments: unknown;
  readonly header?: unknown;
  readonly findings?: readonly unknown[];
  readonly truncated?: boolean;
}

/** What the view is told. */
export type Message =
  | { readonly type: 'header'; readonly header: unknown }
  | { readonly type: 'chunk'; readonly chunk: unknown }
  | { readonly type: 'state'; readonly text: string };

/** How often a program may change while its chunks are asked for. */
const TRIES = 3;

/** Everything that the view is to be told of a program; `ask` puts the question, with more arguments. */
export async function* messages(ask: (more: object) => Promise<Answer | null | undefined>): AsyncGenerator<Message> {
  for (let tries = 0; tries < TRIES; tries++) {
    const first = await ask({});
    if (!first) return yield state('There is no language server to ask for the toolpath.');
    if (!first.segments) return yield state(`The program has ${first.findings?.length === 1 ? 'a finding' : `${first.findings?.length ?? 0} findings`}: what is shown is older.`);
    yield { type: 'header', header: first.header };
    yield { type: 'chunk', chunk: first.segments };
    let number = 1;
    for (; number < first.chunks; number++) {
      const next = await ask({ chunk: number, stamp: first.stamp });
      if (!next?.segments) break;
      yield { type: 'chunk', chunk: next.segments };
    }
    if (number >= first.chunks) return yield state(first.truncated ? 'The run was cut at its limit: the rest is not shown.' : '');
  }
  yield state('The program changes faster than it can be drawn.');
}

function state(text: string): Message {
  return { type: 'state', text };
}
