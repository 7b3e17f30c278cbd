#!/usr/bin/env python3
"""Curves of the errors of ways over the radius of wires, from the table that antialiasing-bench prints.

    antialiasing-bench lines | curves.py docs/guides/antialiasing.svg
"""
import math
import sys

WAYS = {"none": "#8c8c8c", "msaa-4": "#c2541b", "msaa-8": "#b8860b", "post": "#7a5fb0", "wire-clamp-msaa-4": "#1f77b4",
        "wire-coverage": "#2a8a4a"}
STYLE = "<style>svg{color:#24292f}@media(prefers-color-scheme:dark){svg{color:#d0d7de}}</style>"
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 640, 330, 54, 130, 26, 44
LEAST, MOST = 0.001, 0.2


def read(lines):
    """{way: [(radius, rmse)]} of the scenes called 'lines r RADIUS'."""
    curves = {way: [] for way in WAYS}
    for line in lines:
        cells = line.split("\t")
        if cells[0].startswith("lines r ") and cells[1] in curves:
            curves[cells[1]].append((float(cells[0][8:]), float(cells[2])))
    return {way: sorted(points) for way, points in curves.items() if points}


def svg(curves):
    radii = sorted({radius for points in curves.values() for radius, _ in points})
    low, high = math.log(radii[0]), math.log(radii[-1])

    def x(radius):
        return LEFT + (math.log(radius) - low) / (high - low) * (WIDTH - LEFT - RIGHT)

    def y(error):
        return TOP + (math.log(MOST) - math.log(error)) / (math.log(MOST) - math.log(LEAST)) * (HEIGHT - TOP - BOTTOM)

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" '
           f'font-size="11" fill="currentColor">', STYLE,
           f'<text x="{LEFT}" y="14">root mean square error at edges, of a channel\'s range</text>']
    for error in (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2):
        out.append(f'<line x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{y(error):.1f}" y2="{y(error):.1f}" '
                   f'stroke="currentColor" stroke-opacity=".15"/>')
        out.append(f'<text x="{LEFT - 6}" y="{y(error) + 4:.1f}" text-anchor="end">{error:g}</text>')
    for radius in radii:
        out.append(f'<text x="{x(radius):.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{radius:g}</text>')
    out.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2:.0f}" y="{HEIGHT - 8}" text-anchor="middle">'
               f'radius of the wires, pixels</text>')
    taken = []
    for way, points in sorted(curves.items(), key=lambda item: -item[1][-1][1]):
        places = " ".join(f"{x(radius):.1f},{y(error):.1f}" for radius, error in points)
        out.append(f'<polyline points="{places}" fill="none" stroke="{WAYS[way]}" stroke-width="2"/>')
        label = y(points[-1][1]) + 4
        while any(abs(label - other) < 12 for other in taken):
            label += 2
        taken.append(label)
        out.append(f'<text x="{WIDTH - RIGHT + 8}" y="{label:.1f}" fill="{WAYS[way]}">{way}</text>')
    return "\n".join(out + ["</svg>"]) + "\n"


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(svg(read(sys.stdin)))
