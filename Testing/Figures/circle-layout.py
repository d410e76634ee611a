#!/usr/bin/python3
"""usage: circle-layout.py GRAPH.edges OUT.svg

Draws the nodes of an edge list on a circle, in the order of their names, with labels. Called by make-figures.
"""
import math
import sys

SIZE, RADIUS, DOT = 400, 150, 16


def main():
    if "--help" in sys.argv[1:2] or len(sys.argv) != 3:
        print(__doc__)
        return
    with open(sys.argv[1], encoding="utf-8") as file:
        edges = [line.split() for line in file if line.strip()]
    names = sorted({name for edge in edges for name in edge})
    places = {name: [SIZE / 2 + RADIUS * f(2 * math.pi * i / len(names)) for f in (math.sin, math.cos)]
              for i, name in enumerate(names)}
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{SIZE}" height="{SIZE}" font-family="sans-serif">']
    for a, b in edges:
        (x1, y1), (x2, y2) = places[a], places[b]
        parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="#212121" stroke-width="2"/>')
    for name, (x, y) in places.items():
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{DOT}" fill="#f8c9c4" stroke="#c62828" stroke-width="2"/>')
        parts.append(f'<text x="{x:.1f}" y="{y + 6:.1f}" text-anchor="middle" font-size="18">{name}</text>')
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write("\n".join([*parts, "</svg>", ""]))


if __name__ == "__main__":
    main()
