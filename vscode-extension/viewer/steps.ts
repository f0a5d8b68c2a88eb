/** Long work in short steps: the page goes on between them, and so does an editor that shares its thread with the page. */

const STEP_MS = 8;

/** The result of some work that pauses often. */
export async function inSteps<T>(work: Generator<void, T>): Promise<T> {
  for (;;) {
    const until = performance.now() + STEP_MS;
    do {
      const step = work.next();
      if (step.done) return step.value;
    } while (performance.now() < until);
    await rest();
  }
}

/** Let everything go first that waits. Timers of a page that nobody sees come once a second; this does not. */
function rest(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(undefined);
  });
}
