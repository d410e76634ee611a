"""Drawings of the group report, as SVG."""

import statistics

from cohort.page import text_of

WIDTH, HEIGHT, MARGIN = 640, 46, 190
INK, FAR, PALE = "#3f6ea8", "#c77700", "#ddd"


def strips(measures):
    """Draws one strip per measure (name, values, outlier flags): a tick per value, the median as a dark line."""
    rows = [strip for name, values, far in measures if values for strip in [_strip(name, values, far)]]
    shifted = "".join(f'<g transform="translate(0 {index * HEIGHT})">{row}</g>' for index, row in enumerate(rows))
    return _svg(WIDTH + MARGIN, HEIGHT * len(rows), shifted)


def curve(points, x_name, y_name):
    """Draws connected points (x, y), y from 0 to 1."""
    width, height = 420, 240
    right = max([x for x, _ in points] + [1.0])
    places = [(50 + (width - 70) * x / right, 20 + (height - 70) * (1.0 - y)) for x, y in points]
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    dots = "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{INK}"/>' for x, y in places)
    frame = f'<path d="M50 20V{height - 50}H{width - 20}" fill="none" stroke="#999"/>'
    labels = (
        _text(46, 24, "1", "end") + _text(46, height - 46, "0", "end") + _text(50, 12, y_name)
        + _text(width - 20, height - 34, text_of(round(right, 1)), "end") + _text(50, height - 34, "0")
        + _text(width / 2, height - 16, x_name, "middle")
    )
    return _svg(width, height, f'{frame}<polyline points="{path}" fill="none" stroke="{INK}" stroke-width="1.5"/>{dots}{labels}')


def _strip(name, values, far):
    low, high = min(values), max(values)

    def place(value):
        return MARGIN + 10 + (WIDTH - 20) * ((value - low) / (high - low) if high > low else 0.5)

    ticks = "".join(
        f'<path d="M{place(value):.1f} 8v16" stroke="{FAR if is_far else INK}" stroke-width="2" opacity=".7"/>'
        for value, is_far in sorted(zip(values, far), key=lambda pair: pair[1])
    )
    middle = statistics.median(values)
    return (
        f'<path d="M{MARGIN + 10} 24h{WIDTH - 20}" stroke="{PALE}"/>{ticks}<path d="M{place(middle):.1f} 4v24" stroke="#1a1a1a"/>'
        + _text(MARGIN - 6, 21, name, "end") + _text(MARGIN + 10, 40, text_of(low))
        + _text(MARGIN + WIDTH - 10, 40, text_of(high), "end") + _text(MARGIN + WIDTH / 2, 40, f"median {text_of(middle)}", "middle")
    )


def _text(x, y, text, anchor="start"):
    return f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}">{text}</text>'


def _svg(width, height, content):
    place = f'xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}"'
    return f'<svg {place} font-family="system-ui, sans-serif" font-size="12" fill="#1a1a1a">{content}</svg>'
