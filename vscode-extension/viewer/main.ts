/** Where the view begins: on the page of `deburr plot`, which brings its data, or in an editor, which sends them. */
import css from './viewer.css';
import { Text, bytes, type Chunk, type Header } from './data.ts';
import { element } from './elements.ts';
import { Listing } from './listing.ts';
import { Viewer } from './viewer.ts';

/** What an editor sends. */
type Sent =
  | { readonly type: 'header'; readonly header: Header }
  | { readonly type: 'chunk'; readonly chunk: Chunk }
  | { readonly type: 'cursor'; readonly uri: string; readonly line: number }
  | { readonly type: 'state'; readonly text: string };

interface Editor {
  postMessage(message: unknown): void;
}

declare global {
  interface Window {
    acquireVsCodeApi?: () => Editor;
    deburr?: Viewer;
  }
}

async function onPage(root: HTMLElement): Promise<void> {
  const read = <T>(id: string): T => JSON.parse(document.getElementById(id)!.textContent!) as T;
  const header = read<Header>('deburr-header');
  const texts = await Promise.all(header.sources.map(async ({ text }) => {
    const found = new Text();
    if (text) found.append(await bytes(text));
    return found;
  }));
  const tabs = element('div', { id: 'tabs' });
  const box = element('div', { id: 'listing' });
  const side = element('aside', {}, tabs, box);
  const stage = element('main', {});
  root.append(side, stage);
  let shown = -1;
  const listing = new Listing(box, (row) => {
    viewer.light(shown, row);
    listing.mark(row);
  });
  const open = (source: number): void => {
    if (source === shown) return;
    shown = source;
    tabs.querySelectorAll('button').forEach((tab, i) => tab.classList.toggle('open', i === source));
    listing.show(texts[source]!);
  };
  header.sources.forEach(({ name }, i) => {
    const tab = element('button', { textContent: name });
    tab.addEventListener('click', () => open(i));
    tabs.append(tab);
  });
  const viewer = new Viewer(stage, {
    chosen: (source, line) => {
      open(source);
      listing.mark(line);
    },
    line: (source, row) => texts[source]?.line(row) ?? '',
  });
  window.deburr = viewer;
  function* chunks(): Iterable<Chunk> {
    for (let i = 0; i < header.chunks; i++) {
      yield read<Chunk>(`deburr-chunk-${i}`);
      document.getElementById(`deburr-chunk-${i}`)!.remove();
    }
  }
  if (texts.length) open(0);
  await viewer.show(header, chunks());
  root.dataset['ready'] = String(Math.round(performance.now()));
}

function inEditor(root: HTMLElement, editor: Editor): void {
  const stage = element('main', {});
  const state = element('p', { id: 'state', textContent: 'The toolpath is being made.' });
  root.append(stage);
  let header: Header | undefined;
  let cursor: { uri: string; line: number } | undefined;
  let chosen: { uri: string | undefined; line: number } | undefined;
  const viewer = new Viewer(stage, {
    chosen: (source, line) => {
      chosen = { uri: header?.sources[source]?.uri, line };
      editor.postMessage({ type: 'chosen', ...chosen });
    },
    line: () => '',
  });
  stage.append(state);
  window.deburr = viewer;
  const follow = (): void => {
    // The cursor goes to the line of the move that was chosen here: that one goes on to shine alone.
    if (chosen && chosen.uri === cursor?.uri && chosen.line === cursor?.line) return;
    chosen = undefined;
    const source = viewer.path?.header.sources.findIndex(({ uri }) => uri === cursor?.uri) ?? -1;
    if (cursor && source >= 0) viewer.light(source, cursor.line);
  };
  let chunks: Chunk[] = [];
  window.addEventListener('message', async ({ data }: MessageEvent<Sent>) => {
    if (data.type === 'state') state.textContent = data.text;
    else if (data.type === 'cursor') {
      cursor = data;
      follow();
    } else {
      if (data.type === 'header') {
        header = data.header;
        chunks = [];
      } else chunks.push(data.chunk);
      // Only the first one is waited for with nothing to look at.
      if (header && !viewer.path) state.textContent = `The toolpath is being fetched: ${chunks.length} of ${header.chunks} parts.`;
      if (!header || chunks.length < header.chunks) return;
      const whole = chunks;
      chunks = [];
      await viewer.show(header, whole);
      viewer.colour();
      follow();
      root.dataset['ready'] = String(viewer.path?.count ?? 0);
    }
  });
  new MutationObserver(() => viewer.colour()).observe(document.body, { attributes: true, attributeFilter: ['class'] });
  editor.postMessage({ type: 'ready' });
}

const sheet = new CSSStyleSheet();
sheet.replaceSync(css);
document.adoptedStyleSheets = [sheet];
const root = document.getElementById('deburr')!;
const editor = window.acquireVsCodeApi?.();
if (editor) inEditor(root, editor);
else void onPage(root);
