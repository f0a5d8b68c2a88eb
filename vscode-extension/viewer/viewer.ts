/** The view as people use it: picture, slider, switches, what lies under the pointer. Its host decides where sources are shown. */
import { RAPID, type Header, type Chunk, Toolpath } from './data.ts';
import { pick } from './pick.ts';
import { Scene, TOOLS, type View } from './scene.ts';
import { element, button, check } from './elements.ts';
import { inSteps } from './steps.ts';
import { thinned, type Drawn } from './thin.ts';

/** More segments than these are not drawn one by one; they are all there for the pointer. */
const DRAWN = 200_000;
const REACH = 7;

/** What the view asks of the page around it. */
export interface Host {
  /** A move was chosen: show the line that made it. */
  chosen(source: number, line: number): void;
  /** A line of a source, if it is known here. */
  line(source: number, row: number): string;
}

export class Viewer {
  path: Toolpath | undefined;
  /** The moves that shine. */
  lit: readonly number[] = [];
  private drawn: Drawn | undefined;
  private turn = 0;
  private readonly canvas = element('canvas', {});
  private readonly stage = element('div', { id: 'stage' }, this.canvas);
  private readonly names = ['X', 'Y', 'Z'].map((name) => element('span', { className: 'axis', textContent: name }));
  private readonly slider = element('input', { id: 'slider', type: 'range', min: '0', max: '0', title: 'how far the program has run' });
  private readonly position = element('output', { id: 'position' });
  private readonly hovered = element('div', { id: 'hover', className: 'told' });
  private readonly selected = element('div', { id: 'selected', className: 'told' });
  private readonly facts = element('div', { id: 'facts' });
  private readonly legend = element('div', { id: 'legend' });
  private readonly rapids = check('rapids', 'rapids');
  private readonly cuts = check('cuts', 'cuts');
  private readonly scene: Scene | undefined;
  private pressed: { x: number; y: number } | undefined;
  private pointer: { x: number; y: number } | undefined;

  constructor(
    box: HTMLElement,
    private readonly host: Host,
  ) {
    this.stage.append(...this.names, this.hovered);
    const views = (['iso', 'top', 'front', 'side'] as View[]).map((view) => button(view, () => this.scene?.look(view)));
    const bar = element('div', { id: 'bar' }, ...views, this.rapids.label, this.cuts.label, this.legend);
    const run = element('div', { id: 'run' }, this.slider, this.position);
    box.append(bar, this.stage, run, this.selected, this.facts);
    this.slider.addEventListener('input', () => this.run());
    for (const { input } of [this.rapids, this.cuts]) input.addEventListener('change', () => this.scene?.visible(this.rapids.input.checked, this.cuts.input.checked));
    try {
      this.scene = new Scene(this.canvas, () => this.label());
    } catch (error) {
      this.stage.replaceChildren(element('p', { id: 'broken', textContent: `The picture needs WebGL, which this browser does not give: ${String(error)}. A plot without it: deburr plot FILE -o plot.svg` }));
    }
    this.canvas.addEventListener('pointerdown', (event) => (this.pressed = at(event)));
    this.canvas.addEventListener('click', (event) => this.clicked(at(event)));
    this.canvas.addEventListener('pointermove', (event) => this.hover(event.buttons ? undefined : at(event)));
    this.canvas.addEventListener('pointerleave', () => this.hover(undefined));
    this.colour();
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.colour());
  }

  /** Show a toolpath: what is said of it, then its chunks as they come. Until all is there the one before stays, and one that was overtaken is dropped. */
  async show(header: Header, chunks: AsyncIterable<Chunk> | Iterable<Chunk>): Promise<void> {
    const turn = ++this.turn;
    const path = new Toolpath(header);
    for await (const chunk of chunks) await path.add(chunk);
    const drawn = await inSteps(thinned(path, DRAWN));
    if (turn !== this.turn) return;
    this.path = path;
    this.lit = [];
    this.drawn = drawn;
    this.scene?.show(path, drawn);
    this.slider.max = String(path.count);
    this.slider.value = this.slider.max;
    this.run();
    this.scene?.visible(this.rapids.input.checked, this.cuts.input.checked);
    this.selected.replaceChildren();
    this.hovered.replaceChildren();
    this.say(header);
  }

  /** Let the moves of a source line shine; how many there are. */
  light(source: number, line: number): number {
    if (!this.path) return 0;
    this.lit = this.path.movesOf(source, line);
    this.scene?.light(this.path, this.lit);
    const name = this.path.header.sources[source]?.name ?? '';
    this.selected.replaceChildren(element('p', { textContent: `${name}:${line + 1}: ${count(this.lit.length, 'move')}` }));
    return this.lit.length;
  }

  /** Where the middle of a move lies on the canvas, in pixels. */
  middleOf(move: number): { x: number; y: number } {
    const { path, scene } = this;
    if (!path || !scene) return { x: NaN, y: NaN };
    const [a, b] = [path.startOf(move), path.ends[move]!];
    const whole = (a + b) % 2 === 0 && b - a > 1;
    const from = Math.floor((a + b) / 2);
    const point = [0, 1, 2].map((axis) => (path.points[3 * from + axis]! + path.points[3 * (whole ? from : from + 1) + axis]!) / 2);
    const m = scene.projection();
    const row = (i: number): number => m[i]! * point[0]! + m[i + 1]! * point[1]! + m[i + 2]! * point[2]! + m[i + 3]!;
    return { x: row(0), y: row(4) };
  }

  /** The colours of the page around it. */
  colour(): void {
    const style = getComputedStyle(this.stage);
    this.scene?.colours(style.backgroundColor, style.borderColor);
  }

  /** What is told of a move: its flat line, the line that made it, the calls and passes above that. */
  private told(move: number): HTMLElement[] {
    const path = this.path!;
    const { sources, kinds, tools } = path.header;
    const end = [0, 1, 2].map((axis) => `${'XYZ'[axis]}${tidy(path.points[3 * path.ends[move]! + axis]!)}`).join(' ');
    const [source, row] = [path.source[move]!, path.line[move]!];
    const place = `${sources[source]?.name}:${row + 1}`;
    const text = this.host.line(source, row);
    return [
      element('p', { className: 'flat', textContent: `flat ${path.row[move]! + 1}: ${path.flat.line(path.row[move]!)}` }),
      element('p', { className: 'source', textContent: text ? `${place}: ${text.trim()}` : place }),
      ...path.stack(move).map((frame) => element('p', { className: 'frame', textContent: stacked(frame.kind, frame.number, `${sources[frame.source]?.name}:${frame.row + 1}`) })),
      element('p', { className: 'end', textContent: `${kinds[path.kind[move]!]} to ${end}, tool ${tools[path.tool[move]!]}` }),
    ];
  }

  private clicked(place: { x: number; y: number }): void {
    const moved = this.pressed && Math.hypot(place.x - this.pressed.x, place.y - this.pressed.y) > 3;
    const move = moved ? undefined : this.under(place);
    if (move === undefined || !this.path) return;
    this.lit = [move];
    this.scene?.light(this.path, this.lit);
    this.selected.replaceChildren(...this.told(move));
    this.host.chosen(this.path.source[move]!, this.path.line[move]!);
  }

  /** Of many movements of the pointer only the last is followed. */
  private hover(place: { x: number; y: number } | undefined): void {
    const waiting = this.pointer !== undefined;
    this.pointer = place;
    if (!place) this.hovered.replaceChildren();
    else if (!waiting) {
      requestAnimationFrame(() => {
        const last = this.pointer;
        this.pointer = undefined;
        if (!last) return;
        const move = this.under(last);
        this.hovered.replaceChildren(...(move === undefined ? [] : this.told(move)));
        // Below the pointer on its right, or as far as there is room.
        this.hovered.style.left = `${Math.max(0, Math.min(last.x + 14, this.canvas.clientWidth - this.hovered.offsetWidth - 4))}px`;
        const above = last.y + 14 + this.hovered.offsetHeight > this.canvas.clientHeight;
        this.hovered.style.top = `${above ? last.y - 14 - this.hovered.offsetHeight : last.y + 14}px`;
      });
    }
  }

  private under(place: { x: number; y: number }): number | undefined {
    if (!this.path || !this.scene) return undefined;
    const visible = { moves: Number(this.slider.value), rapids: this.rapids.input.checked, cuts: this.cuts.input.checked };
    return pick(this.path, this.scene.projection(), place.x, place.y, REACH, visible);
  }

  private run(): void {
    const done = Number(this.slider.value);
    this.position.textContent = `${done.toLocaleString('en')} of ${count(this.path?.count ?? 0, 'move')}`;
    if (this.path) this.scene?.upTo(this.path, done);
  }

  private label(): void {
    this.scene?.axes().forEach((place, axis) => {
      this.names[axis]!.hidden = !place;
      if (place) this.names[axis]!.style.transform = `translate(${place.x}px, ${place.y}px)`;
    });
  }

  private say(header: Header): void {
    const path = this.path!;
    const facts = [...header.notes];
    const total = path.vertices;
    if (this.drawn?.tolerance) {
      facts.unshift(`${this.drawn.moves.length.toLocaleString('en')} of ${total.toLocaleString('en')} segments are drawn; the others lie within ${tidy(this.drawn.tolerance)} mm of these. The pointer finds all.`);
    }
    const rows = Object.entries(header.bounds).map(([what, corners]) => {
      const ranges = corners ? [0, 1, 2].map((axis) => `${'XYZ'[axis]} ${tidy(corners[0][axis]!)} to ${tidy(corners[1][axis]!)}`).join(', ') + ' mm' : 'none';
      return element('p', { className: 'bounds', textContent: `${what}: ${ranges}` });
    });
    this.facts.replaceChildren(...rows, ...facts.map((note) => element('p', { className: 'note', textContent: note })));
    const used = header.tools.map(() => false);
    for (let move = 0; move < path.count; move++) if (path.kind[move] !== RAPID) used[path.tool[move]!] = true;
    this.legend.replaceChildren(
      ...header.tools.flatMap((number, i) => {
        if (!used[i]) return [];
        const entry = element('span', { className: 'entry', textContent: number ? `tool ${number}` : 'no tool' });
        entry.style.setProperty('--shade', TOOLS[i % TOOLS.length]!);
        return [entry];
      }),
    );
  }
}

function at(event: MouseEvent): { x: number; y: number } {
  return { x: event.offsetX, y: event.offsetY };
}

function stacked(kind: string, number: number, place: string): string {
  return kind === 'loop' ? `pass ${number} of the loop in ${place}` : `${kind} in ${place}`;
}

function tidy(value: number): string {
  return String(Number(value.toFixed(3)));
}

function count(number: number, what: string): string {
  return `${number.toLocaleString('en')} ${what}${number === 1 ? '' : 's'}`;
}
