/** The picture in three dimensions: draws when something changed, and only then. */
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  ConeGeometry,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  Scene as World,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { RAPID, countUpTo, type Toolpath } from './data.ts';
import type { Projection } from './pick.ts';
import type { Drawn } from './thin.ts';

export type View = 'iso' | 'top' | 'front' | 'side';
export type Point = readonly [number, number, number];

/** Where the eye is, and what is up. */
const VIEWS: Readonly<Record<View, readonly [Point, Point]>> = {
  iso: [[1, -1, 1], [0, 0, 1]],
  top: [[0, 0, 1], [0, 1, 0]],
  front: [[0, -1, 0], [0, 0, 1]],
  side: [[1, 0, 0], [0, 0, 1]],
};
/** Tools take these in turn: colours that are told apart by most people, on light and dark. */
export const TOOLS = ['#1f77b4', '#d95f02', '#2ca02c', '#9467bd', '#8c564b', '#e377c2', '#bcbd22', '#17a2b8'];
/** Wide lines weigh four times as much, so that more than these are lit as narrow ones. */
const WIDE = 50_000;

interface Layer {
  readonly lines: LineSegments;
  readonly moves: Uint32Array;
}

export class Scene {
  private readonly world = new World();
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, -1, 1);
  private readonly renderer: WebGLRenderer;
  private readonly controls: OrbitControls;
  private readonly tool = new Mesh(new ConeGeometry(0.4, 1, 16).rotateX(-Math.PI / 2).translate(0, 0, 0.5), new MeshBasicMaterial({ color: '#e0a800' }));
  private readonly box = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ color: '#888888' }));
  private layers: Partial<Record<'rapids' | 'cuts', Layer>> = {};
  private lit: LineSegments | LineSegments2 | undefined;
  private low: Point = [0, 0, 0];
  private high: Point = [1, 1, 1];
  private waiting = 0;

  /** Throws where the browser has no WebGL. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly painted: () => void,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.paint());
    this.world.add(this.box, this.tool);
    this.camera.up.set(0, 0, 1);
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
  }

  /** Show another toolpath; the eye stays where it is if it shows the same part of space. */
  show(path: Toolpath, drawn: Drawn): void {
    for (const layer of Object.values(this.layers)) this.drop(layer.lines);
    this.light(path, []);
    this.layers = { cuts: this.layer(path, drawn, false), rapids: this.layer(path, drawn, true) };
    const [low, high] = path.bounds() ?? [[0, 0, 0], [1, 1, 1]];
    const same = [...low, ...high].every((value, i) => value === [...this.low, ...this.high][i]);
    this.low = low as unknown as Point;
    this.high = high as unknown as Point;
    this.box.geometry.setAttribute('position', new BufferAttribute(edges(this.low, this.high), 3));
    this.box.geometry.computeBoundingSphere();
    if (!same) this.look('iso');
    this.paint();
  }

  /** Look from one of four sides, at everything. */
  look(view: View): void {
    const [eye, up] = VIEWS[view];
    const centre = this.low.map((value, axis) => (value + this.high[axis]!) / 2) as unknown as Point;
    const radius = Math.max(1e-3, Math.hypot(...this.high.map((value, axis) => value - this.low[axis]!)) / 2);
    this.camera.up.set(...up);
    this.camera.position.set(...(centre.map((value, axis) => value + (eye[axis]! * 4 * radius) / Math.hypot(...eye)) as [number, number, number]));
    this.camera.near = -100 * radius;
    this.camera.far = 100 * radius;
    this.camera.zoom = 1;
    this.controls.target.set(...centre);
    // The controls know one upward direction, that of their first frame: seen from above they turn about it all the same.
    this.camera.lookAt(this.controls.target);
    this.fit(radius * 1.1);
    this.controls.update();
    this.paint();
  }

  /** Show the first moves only, with the tool at the end of the last of them. */
  upTo(path: Toolpath, count: number): void {
    for (const layer of Object.values(this.layers)) layer.lines.geometry.setDrawRange(0, 2 * countUpTo(layer.moves, layer.moves.length, count - 1));
    const vertex = count ? path.ends[count - 1]! : 0;
    this.tool.position.fromArray(path.points, 3 * vertex);
    this.paint();
  }

  visible(rapids: boolean, cuts: boolean): void {
    if (this.layers.rapids) this.layers.rapids.lines.visible = rapids;
    if (this.layers.cuts) this.layers.cuts.lines.visible = cuts;
    this.paint();
  }

  /** Let some moves shine, and no others. */
  light(path: Toolpath, moves: readonly number[]): void {
    if (this.lit) this.drop(this.lit);
    this.lit = undefined;
    const points: number[] = [];
    for (const move of moves) {
      for (let i = path.startOf(move); i < path.ends[move]!; i++) for (let k = 0; k < 6; k++) points.push(path.points[3 * i + k]!);
    }
    if (points.length) {
      this.lit = points.length <= 6 * WIDE ? wide(points) : narrow(points);
      this.lit.renderOrder = 1;
      this.world.add(this.lit);
    }
    this.paint();
  }

  colours(background: string, box: string): void {
    this.renderer.setClearColor(new Color(background));
    (this.box.material as LineBasicMaterial).color.set(box);
    this.paint();
  }

  /** The way from space to the pixels of the canvas. */
  projection(): Projection {
    this.camera.updateMatrixWorld();
    const m = new Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse).elements;
    const { clientWidth: w, clientHeight: h } = this.canvas;
    const row = (i: number, scale: number, shift: number): number[] => [m[i]! * scale, m[i + 4]! * scale, m[i + 8]! * scale, m[i + 12]! * scale + shift];
    return [...row(0, w / 2, w / 2), ...row(1, -h / 2, h / 2), ...row(2, 1, 0)];
  }

  /** Where on the canvas the axes' names stand: behind three corners of the bounding box, as far as it goes along them. */
  axes(): ({ x: number; y: number } | undefined)[] {
    const reach = 1.06;
    return [0, 1, 2].map((axis) => {
      if (this.low[axis] === this.high[axis]) return undefined;
      const at = new Vector3(...this.low);
      at.setComponent(axis, this.low[axis]! + (this.high[axis]! - this.low[axis]!) * reach);
      at.project(this.camera);
      return { x: ((at.x + 1) / 2) * this.canvas.clientWidth, y: ((1 - at.y) / 2) * this.canvas.clientHeight };
    });
  }

  paint(): void {
    this.waiting ||= requestAnimationFrame(() => {
      this.waiting = 0;
      const pixel = (this.camera.top - this.camera.bottom) / this.camera.zoom / Math.max(1, this.canvas.clientHeight);
      this.tool.scale.setScalar(16 * pixel);
      this.renderer.render(this.world, this.camera);
      this.painted();
    });
  }

  private layer(path: Toolpath, drawn: Drawn, rapids: boolean): Layer {
    const chosen = drawn.moves.reduce((sum, move) => sum + Number((path.kind[move] === RAPID) === rapids), 0);
    const points = new Float32Array(6 * chosen);
    const shades = new Uint8Array(6 * chosen);
    const along = new Float32Array(2 * chosen);
    const moves = new Uint32Array(chosen);
    const palette = TOOLS.map((name) => new Color(name).toArray().map((value) => Math.round(255 * value)));
    let n = 0;
    drawn.moves.forEach((move, i) => {
      if ((path.kind[move] === RAPID) !== rapids) return;
      const from = 3 * drawn.pairs[2 * i]!;
      const to = 3 * drawn.pairs[2 * i + 1]!;
      for (let k = 0; k < 3; k++) {
        points[6 * n + k] = path.points[from + k]!;
        points[6 * n + 3 + k] = path.points[to + k]!;
        shades[6 * n + k] = shades[6 * n + 3 + k] = palette[path.tool[move]! % palette.length]![k]!;
      }
      along[2 * n + 1] = Math.hypot(points[6 * n + 3]! - points[6 * n]!, points[6 * n + 4]! - points[6 * n + 1]!, points[6 * n + 5]! - points[6 * n + 2]!);
      moves[n++] = move;
    });
    const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(points, 3));
    geometry.setAttribute('color', new BufferAttribute(shades, 3, true)).setAttribute('lineDistance', new BufferAttribute(along, 1));
    const bounds = path.bounds();
    const dash = bounds ? Math.hypot(...bounds[1].map((high, axis) => high - bounds[0][axis]!)) / 120 : 1;
    const material = rapids ? new LineDashedMaterial({ color: '#999999', dashSize: dash, gapSize: dash }) : new LineBasicMaterial({ vertexColors: true });
    const lines = new LineSegments(geometry, material);
    lines.frustumCulled = false;
    this.world.add(lines);
    return { lines, moves };
  }

  private drop(lines: LineSegments | LineSegments2): void {
    this.world.remove(lines);
    lines.geometry.dispose();
    (lines.material as LineBasicMaterial).dispose();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement!;
    if (!clientWidth || !clientHeight) return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(clientWidth, clientHeight);
    this.fit(Math.min(this.camera.top, this.camera.right));
    this.paint();
  }

  /** Make a circle of this radius fill the canvas. */
  private fit(radius: number): void {
    const aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
    this.camera.right = radius * Math.max(1, aspect);
    this.camera.top = radius / Math.min(1, aspect);
    this.camera.left = -this.camera.right;
    this.camera.bottom = -this.camera.top;
    this.camera.updateProjectionMatrix();
  }
}

function wide(points: number[]): LineSegments2 {
  return new LineSegments2(new LineSegmentsGeometry().setPositions(points), new LineMaterial({ color: '#ff2d2d', linewidth: 4, depthTest: false, transparent: true }));
}

function narrow(points: number[]): LineSegments {
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(points), 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color: '#ff2d2d', depthTest: false, transparent: true }));
}

/** The twelve edges of a box. */
function edges(low: Point, high: Point): Float32Array {
  const found: number[] = [];
  const corner = (i: number): number[] => [0, 1, 2].map((axis) => (i & (1 << axis) ? high : low)[axis]!);
  for (let i = 0; i < 8; i++) for (const bit of [1, 2, 4]) if (!(i & bit)) found.push(...corner(i), ...corner(i | bit));
  return new Float32Array(found);
}
