"""A path as an SVG picture: isometric and from three sides, with axes, a legend and what is to be known. The same path gives the same bytes.

Arcs are arcs where they look like a piece of an ellipse; seen edge-on, and helixes from aside, are chords within `CHORD` of a pixel.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import ceil, dist, floor, hypot, log10
from typing import TYPE_CHECKING, NamedTuple
from xml.sax.saxutils import escape

from deburr.motion.arcs import AXES_OF, points
from deburr.plot.extent import Extent, Reach, reach
from deburr.plot.notes import notes
from deburr.plot.segments import MOST, Drawn, Segment, drawn
from deburr.plot.views import FRONT, ISOMETRIC, SIDE, TOP, View, ellipse

if TYPE_CHECKING:
    from deburr.motion import Arc, Path
    from deburr.motion.path import Point

CHORD = 0.05
"""Pixels by which chords leave curves that SVG has no arc for."""
WIDTH, PANEL, MARGIN, GAP, HEAD = 1200, (530.0, 360.0), 50.0, 40.0, 60.0
COLOURS = ("#1f77b4", "#d95f02", "#2ca02c", "#9467bd", "#8c564b", "#e377c2", "#bcbd22", "#17a2b8")
"""Tools take these in turn, as in the viewer."""
_RAPID = "#999999"
_PIECE = 0.5
"""Chords that leave a circle by this part of its radius are pieces of a third of it: none is so long that SVG could take the other way round."""
_LINE = 18
_LONGEST = 150
"""Letters of a line of text."""


class Panel(NamedTuple):
    """A part of the picture: the view, its left upper corner, and the way from millimetres to pixels."""

    view: View
    left: float
    top: float
    scale: float
    shift: tuple[float, float]

    def at(self, point: Point) -> tuple[float, float]:
        """Where a point is on the picture, in pixels; y goes down."""
        right, up = self.view.seen(point)
        return self.shift[0] + right * self.scale, self.shift[1] - up * self.scale


def picture(name: str, path: Path, most: int = MOST) -> tuple[str, Drawn]:
    """The picture, and what was drawn in it."""
    goes = reach(path)
    around = goes.all or Extent(path.start, path.start)
    found = drawn(path, around, most)
    texts = [*_bounds(goes), *_said(path, found)]
    bottom = HEAD + 2 * (PANEL[1] + GAP + 20)
    height = bottom + _LINE * (len(texts) + 2)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{_n(height)}" viewBox="0 0 {WIDTH} {_n(height)}" '
        'font-family="DejaVu Sans, Verdana, Arial, sans-serif" font-size="12" fill="none" stroke-linecap="round" stroke-linejoin="round">',
        f"<title>{_shown(name)}</title>",
        f'<rect width="{WIDTH}" height="{_n(height)}" fill="#ffffff"/>',
        _text(MARGIN, 32, name, 'font-size="18"'),
    ]
    for panel in _panels(around):
        parts += _panel(panel, around, found.segments)
    parts += _legend(path, found.segments, bottom)
    parts += [_text(MARGIN, bottom + _LINE * (2 + row), text) for row, text in enumerate(texts)]
    return "\n".join([*parts, "</svg>", ""]), found


def _panels(around: Extent) -> list[Panel]:
    """The three sides have one scale, so that they belong together; the fourth has its own."""
    flat = min(_fitting(view, around) for view in (TOP, FRONT, SIDE))
    places = ((TOP, 0, 0), (ISOMETRIC, 1, 0), (FRONT, 0, 1), (SIDE, 1, 1))
    return [_placed(view, around, flat if view.axes else _fitting(view, around), x, y) for view, x, y in places]


def _placed(view: View, around: Extent, scale: float, column: int, row: int) -> Panel:
    left, top = MARGIN + column * (PANEL[0] + GAP), HEAD + row * (PANEL[1] + GAP + 20)
    low, high = _spread(view, around)
    middle = ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2)
    shift = (left + PANEL[0] / 2 - middle[0] * scale, top + PANEL[1] / 2 + middle[1] * scale)
    return Panel(view, left, top, scale, shift)


def _fitting(view: View, around: Extent) -> float:
    """Pixels a millimetre with which everything fits."""
    low, high = _spread(view, around)
    sides = [(high[i] - low[i], PANEL[i] * 0.86) for i in (0, 1)]
    return min((room / side for side, room in sides if side > 1e-9), default=1.0)


def _spread(view: View, around: Extent) -> tuple[tuple[float, float], tuple[float, float]]:
    rights, ups = zip(*(view.seen(corner) for corner in _corners(around)))
    return (min(rights), min(ups)), (max(rights), max(ups))


def _corners(around: Extent) -> list[Point]:
    x, y, z = zip(around.low, around.high)
    return [(x[i & 1], y[i >> 1 & 1], z[i >> 2]) for i in range(8)]


def _panel(panel: Panel, around: Extent, segments: Sequence[Segment]) -> Iterator[str]:
    left, top = panel.left, panel.top
    clip = f"c{panel.view.name[0]}"
    yield f'<clipPath id="{clip}"><rect x="{_n(left)}" y="{_n(top)}" width="{_n(PANEL[0])}" height="{_n(PANEL[1])}"/></clipPath>'
    yield f'<rect x="{_n(left)}" y="{_n(top)}" width="{_n(PANEL[0])}" height="{_n(PANEL[1])}" stroke="#bbbbbb"/>'
    yield _text(left + 6, top + 16, panel.view.name, 'fill="#777777"')
    yield from _ruled(panel) if panel.view.axes else _boxed(panel, around)
    yield f'<g clip-path="url(#{clip})" id="{panel.view.name.replace(" ", "-")}">'
    rapids = _curve(panel, (segment for segment in segments if segment.rapid))
    if rapids:
        yield f'<path class="rapid" stroke="{_RAPID}" stroke-dasharray="5 4" d="{rapids}"/>'
    for tool in _tools(segments):
        curve = _curve(panel, (segment for segment in segments if not segment.rapid and segment.tool == tool))
        yield f'<path class="cut" stroke="{_colour(tool)}" stroke-width="1.5" d="{curve}"/>'
        if panel.view is TOP and (
            holes := _holes(panel, (segment for segment in segments if not segment.rapid and segment.tool == tool))
        ):
            yield f'<path class="hole" stroke="{_colour(tool)}" stroke-width="6" d="{holes}"/>'
    yield "</g>"


def _curve(panel: Panel, segments: Iterable[Segment]) -> str:
    """Segments as the data of an SVG path."""
    parts: list[str] = []
    pen = ""
    met: set[tuple[str, str]] = set()
    for segment in segments:
        start, end = _place(panel.at(segment.start)), _place(panel.at(segment.end))
        if segment.arc is None:
            # Dashes that lie on each other would close each other's gaps.
            both = (start, end) if start < end else (end, start)
            if start == end or both in met:
                continue
            met.add(both)
        if start != pen:
            parts.append(f"M{start}")
        parts += [f"L{end}"] if segment.arc is None else _arc(panel, segment)
        pen = end
    return "".join(parts)


def _holes(panel: Panel, segments: Iterable[Segment]) -> str:
    """Cuts that go straight away from who looks, as dots: else no hole would be seen from above."""
    places = (
        _place(panel.at(segment.end))
        for segment in segments
        if segment.arc is None
        and segment.start != segment.end
        and _place(panel.at(segment.start)) == _place(panel.at(segment.end))
        and dist(segment.start, segment.end) * panel.scale > 1
    )
    return "".join(f"M{place}h0" for place in dict.fromkeys(places))


def _arc(panel: Panel, segment: Segment) -> Iterator[str]:
    """An arc as one or some of SVG's, or as chords."""
    arc = segment.arc
    assert arc is not None
    seen = ellipse(arc, panel.view)
    if seen is None:
        yield from (f"L{_place(panel.at(point))}" for point in points(arc, CHORD / panel.scale))
        return
    first, second, turned = seen.first * panel.scale, seen.second * panel.scale, -seen.turned
    # Counterclockwise on the picture is against SVG's growing angle, since its y goes down.
    flag = int((arc.turns > 0) != seen.same)
    for point in points(arc, _PIECE * dist(_plane(arc, arc.start), arc.centre)):
        yield f"A{_n(first)} {_n(second)} {_n(turned)} 0 {flag} {_place(panel.at(point))}"


def _plane(arc: Arc, point: Point) -> tuple[float, float]:
    first, second, _ = AXES_OF[arc.plane]
    return point[first], point[second]


def _ruled(panel: Panel) -> Iterator[str]:
    """Axes with ticks along the lower and the left edge, and where zero is."""
    across, upward = panel.view.axes[0], panel.view.axes[1]
    left, top = panel.left, panel.top
    bottom, right = top + PANEL[1], left + PANEL[0]
    x0, y0 = panel.shift
    for value in _ticks((left - x0) / panel.scale, (right - x0) / panel.scale):
        x = x0 + value * panel.scale
        yield _line(x, top, x, bottom, "#e4e4e4" if value else "#b0b0b0")
        yield _text(x, bottom + 15, _tidy(value), 'text-anchor="middle" font-size="10"')
    for value in _ticks((y0 - bottom) / panel.scale, (y0 - top) / panel.scale):
        y = y0 - value * panel.scale
        yield _line(left, y, right, y, "#e4e4e4" if value else "#b0b0b0")
        yield _text(left - 5, y + 4, _tidy(value), 'text-anchor="end" font-size="10"')
    yield _text(right, bottom + 28, f"{across} (mm)", 'text-anchor="end" font-size="11"')
    yield _text(left - 5, top - 6, f"{upward} (mm)", 'font-size="11"')


def _boxed(panel: Panel, around: Extent) -> Iterator[str]:
    """The box around everything, its edges from the lowest corner named."""
    corners = _corners(around)
    for i, corner in enumerate(corners):
        for bit in (1, 2, 4):
            if not i & bit:
                yield _line(*panel.at(corner), *panel.at(corners[i | bit]), "#dddddd")
    x0, y0 = panel.at(around.low)
    for axis, name in enumerate("XYZ"):
        if around.high[axis] - around.low[axis] < 1e-9:
            continue
        x, y = panel.at(corners[1 << axis])
        yield _line(x0, y0, x, y, "#777777")
        length = hypot(x - x0, y - y0) or 1.0
        x, y = x + (x - x0) / length * 12, y + (y - y0) / length * 12 + 4
        yield _text(x, y, name, 'text-anchor="middle" font-size="12" font-weight="bold"')


def _ticks(low: float, high: float) -> list[float]:
    """Round values between two, some six of them."""
    rough = (high - low) / 6
    power = 10.0 ** floor(log10(rough))
    step = next(power * factor for factor in (1, 2, 5, 10) if power * factor >= rough * 0.999)
    # Margins of half a step keep numbers off the corners.
    return [number * step for number in range(ceil(low / step + 0.2), floor(high / step - 0.2) + 1)]


def _legend(path: Path, segments: Sequence[Segment], top: float) -> Iterator[str]:
    x, y = MARGIN, top + _LINE / 2
    rapid = [("rapid", _RAPID, ' stroke-dasharray="5 4"')] if any(segment.rapid for segment in segments) else []
    named = [(f"tool {number}" if number else "no tool", _colour(tool), ' stroke-width="1.5"') for tool, number in enumerate(path.tools) if tool in _tools(segments)]  # fmt: skip
    for name, colour, style in rapid + named:
        yield f'<path stroke="{colour}"{style} d="M{_n(x)} {_n(y)}h34"/>'
        yield _text(x + 40, y + 4, name)
        x += 60 + 8 * len(name)


def _bounds(goes: Reach) -> Iterator[str]:
    for name, extent in (("all moves", goes.all), ("cuts", goes.cuts)):
        ranges = zip("XYZ", extent.low, extent.high) if extent else ()
        said = ", ".join(f"{axis} {_tidy(low)} to {_tidy(high)}" for axis, low, high in ranges)
        yield f"{name}: {said} mm" if said else f"{name}: none"


def _said(path: Path, found: Drawn) -> Iterator[str]:
    """What the picture does not show."""
    if found.tolerance:
        yield told(found)
    for text in notes(path):
        yield text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


def told(found: Drawn) -> str:
    """What was left out."""
    return f"{len(found.segments):,} of {found.total:,} segments are drawn; what is left out lies within {found.tolerance:.3g} mm of them"


def _tools(segments: Sequence[Segment]) -> list[int]:
    return sorted({segment.tool for segment in segments if not segment.rapid})


def _colour(tool: int) -> str:
    return COLOURS[tool % len(COLOURS)]


def _line(x1: float, y1: float, x2: float, y2: float, colour: str) -> str:
    return f'<path stroke="{colour}" d="M{_n(x1)} {_n(y1)}L{_n(x2)} {_n(y2)}"/>'


def _text(x: float, y: float, text: str, style: str = "") -> str:
    fill = "" if "fill=" in style else ' fill="#333333"'
    return f'<text x="{_n(x)}" y="{_n(y)}"{fill}{" " if style else ""}{style}>{_shown(text)}</text>'


def _shown(text: str) -> str:
    """A text as XML; signs that no XML may hold are blanks."""
    return escape("".join(sign if sign.isprintable() else " " for sign in text))


def _place(at: tuple[float, float]) -> str:
    return f"{_n(at[0])} {_n(at[1])}"


def _n(value: float) -> str:
    """A number of pixels: hundredths at most."""
    said = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if said == "-0" else said


def _tidy(value: float) -> str:
    """A number of millimetres: thousandths at most."""
    said = f"{value:.3f}".rstrip("0").rstrip(".")
    return "0" if said == "-0" else said
