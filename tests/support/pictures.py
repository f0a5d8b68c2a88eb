"""Pictures as a browser shows them: which colours they hold. The browser reads them, so no library is needed."""

from __future__ import annotations

from base64 import b64encode
from collections import Counter

from playwright.sync_api import Browser

_READ = """async (url) => {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const counts = {};
    for (const pixel of new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)) {
        counts[pixel] = (counts[pixel] ?? 0) + 1;
    }
    return counts;
}"""


def colours(window: Browser, png: bytes) -> Counter[tuple[int, int, int]]:
    """How many pixels of a PNG have each colour (red, green, blue)."""
    page = window.new_page()
    try:
        found = page.evaluate(_READ, f"data:image/png;base64,{b64encode(png).decode()}")
    finally:
        page.close()
    return Counter({(int(each) & 255, int(each) >> 8 & 255, int(each) >> 16 & 255): n for each, n in found.items()})


def drawn(seen: Counter[tuple[int, int, int]]) -> int:
    """Pixels that are not background: the colour that most of them have."""
    return sum(seen.values()) - seen.most_common(1)[0][1]


def red(seen: Counter[tuple[int, int, int]]) -> int:
    """Pixels of what shines."""
    return sum(number for (r, g, b), number in seen.items() if r > 200 and g < 90 and b < 90)
