/** Which segment lies under the pointer: all of them are looked at, drawn or not. Knows no page. */
import { RAPID, SHIFT, type Toolpath } from './data.ts';

/** From space to the screen: x, y in pixels and a depth that grows away from the viewer, as rows of four factors. */
export type Projection = readonly number[];

/** Which moves can be seen. */
export interface Visible {
  readonly moves: number;
  readonly rapids: boolean;
  readonly cuts: boolean;
}

/** Pixels that are taken for equally near. */
const BAND = 1;

/** The move nearest to a place on the screen, at most `reach` pixels off; of several equally near the one in front, then the last. */
export function pick(path: Toolpath, to: Projection, x: number, y: number, reach: number, visible: Visible): number | undefined {
  const { points, kind, ends } = path;
  const [a, b, c, d, e, f, g, h, i, j, k, l] = to as [number, number, number, number, number, number, number, number, number, number, number, number];
  let found: number | undefined;
  let best = Infinity;
  let bestDepth = Infinity;
  let vertex = 0;
  let px = points[0]!, py = points[1]!, pz = points[2]!;
  let x0 = a * px + b * py + c * pz + d, y0 = e * px + f * py + g * pz + h, z0 = i * px + j * py + k * pz + l;
  for (let move = 0; move < visible.moves; move++) {
    const seen = kind[move] === RAPID ? visible.rapids : visible.cuts && kind[move] !== SHIFT;
    for (const end = ends[move]!; vertex < end; ) {
      vertex++;
      px = points[3 * vertex]!;
      py = points[3 * vertex + 1]!;
      pz = points[3 * vertex + 2]!;
      const x1 = a * px + b * py + c * pz + d, y1 = e * px + f * py + g * pz + h, z1 = i * px + j * py + k * pz + l;
      const near = seen && (x0 < x1 ? x1 - x >= -reach && x0 - x <= reach : x0 - x >= -reach && x1 - x <= reach) && (y0 < y1 ? y1 - y >= -reach && y0 - y <= reach : y0 - y >= -reach && y1 - y <= reach);
      if (near) {
        const dx = x1 - x0, dy = y1 - y0;
        const length = dx * dx + dy * dy;
        const t = length ? Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / length)) : 0;
        const distance = Math.hypot(x0 + t * dx - x, y0 + t * dy - y);
        if (distance <= reach) {
          const band = Math.floor(distance / BAND);
          const depth = z0 + t * (z1 - z0);
          if (band < best || (band === best && depth <= bestDepth + 1e-6)) {
            best = band;
            bestDepth = depth;
            found = move;
          }
        }
      }
      x0 = x1;
      y0 = y1;
      z0 = z1;
    }
  }
  return found;
}
