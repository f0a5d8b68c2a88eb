/** A listing of any length: only the lines in view are elements. */

export interface Lines {
  readonly count: number;
  line(row: number): string;
}

const HEIGHT = 18;
/** Browsers have no higher elements. */
const MOST = 15_000_000;

export class Listing {
  private readonly rows = document.createElement('div');
  private readonly space = document.createElement('div');
  private lines: Lines = { count: 0, line: () => '' };
  private marked = -1;

  constructor(
    private readonly box: HTMLElement,
    private readonly chosen: (row: number) => void,
  ) {
    this.rows.className = 'rows';
    box.append(this.space, this.rows);
    box.addEventListener('scroll', () => this.fill());
    this.rows.addEventListener('click', (event) => {
      const row = (event.target as HTMLElement).closest<HTMLElement>('[data-row]')?.dataset['row'];
      if (row !== undefined) this.chosen(Number(row));
    });
    new ResizeObserver(() => this.fill()).observe(box);
  }

  show(lines: Lines): void {
    this.lines = lines;
    this.space.style.height = `${Math.min(MOST, lines.count * HEIGHT)}px`;
    this.marked = -1;
    this.box.scrollTop = 0;
    this.fill();
  }

  /** Mark a line and bring it into view. */
  mark(row: number): void {
    this.marked = row;
    const first = this.first();
    if (row < first + 2 || row >= first + this.fitting() - 2) this.box.scrollTop = this.rate() * Math.max(0, row - this.fitting() / 2);
    this.fill();
  }

  private fitting(): number {
    return Math.max(1, Math.floor(this.box.clientHeight / HEIGHT));
  }

  /** How far a line is scrolled: its height, unless there are too many. */
  private rate(): number {
    const hidden = this.lines.count - this.fitting();
    return hidden > 0 ? (this.space.clientHeight - this.box.clientHeight) / hidden : HEIGHT;
  }

  private first(): number {
    return Math.max(0, Math.floor(this.box.scrollTop / this.rate()));
  }

  private fill(): void {
    const first = this.first();
    const last = Math.min(this.lines.count, first + this.fitting() + 2);
    this.rows.style.top = `${this.box.scrollTop}px`;
    const elements: HTMLElement[] = [];
    for (let row = first; row < last; row++) {
      const element = document.createElement('div');
      element.dataset['row'] = String(row);
      element.className = row === this.marked ? 'row marked' : 'row';
      const number = document.createElement('span');
      number.textContent = String(row + 1);
      element.append(number, this.lines.line(row));
      elements.push(element);
    }
    this.rows.replaceChildren(...elements);
  }
}
