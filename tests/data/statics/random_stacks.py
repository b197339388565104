#!/usr/bin/env python3
"""Writes random_stacks.json: 200 random stacks of boxes with margins by an exact rational simplex, the referee of
tests/unit/statics/random_stacks_test.cpp. Coordinates and masses are dyadic, so that doubles hold them exactly.

    python3 random_stacks.py > random_stacks.json

For each stack: one body, its range of `shift` (m) and of `load` (N, down in the middle of its top), and the range of the
horizontal acceleration (g) if nothing could slide. A range is [low, high] with null for no limit; null alone: none at all.
"""
import json
import random
from fractions import Fraction as F

GRAVITY = F(981, 100)
COUNT = 200


def stack(r):
    """Bricks [x, y, w, h, mass] in courses; each lies on the floor or on a part of a brick below."""
    bricks, below, y = [], None, F(0)
    for _ in range(r.randint(2, 5)):
        h = F(r.choice([16, 24, 32]), 32)
        x, course = F(r.randint(-32, 16), 32), []
        for _ in range(r.randint(1, 3)):
            w = F(r.randint(16, 80), 32)
            rests = below is None or any(min(x + w, b[0] + b[2] / 2) > max(x, b[0] - b[2] / 2) for b in below)
            if rests:
                course.append([x + w / 2, y + h / 2, w, h, F(r.randint(1, 32), 8)])
            x += w + F(r.randint(1, 16), 32)
        if not course:
            break
        bricks += course
        below, y = course, y + h
    return bricks


def contacts(bricks):
    """(upper, lower or None for the floor, x, y): both ends of every overlap."""
    found = []
    for i, (x, y, w, h, _) in enumerate(bricks):
        bottom, left, right = y - h / 2, x - w / 2, x + w / 2
        if bottom == 0:
            found += [(i, None, left, bottom), (i, None, right, bottom)]
        for j, (u, v, width, height, _) in enumerate(bricks):
            if v + height / 2 != bottom:
                continue
            low, high = max(left, u - width / 2), min(right, u + width / 2)
            if low < high:
                found += [(i, j, low, bottom), (i, j, high, bottom)]
    return found


def weights(bricks):
    return [x for b in bricks for x in (F(0), -b[4], F(0))]


def columns(bricks, rough):
    """Wrenches of the generators; `rough`: forces along the sides of both signs, too."""
    result = []
    for i, j, x, y in contacts(bricks):
        for fx, fy in [(F(0), F(1))] + ([(F(1), F(0)), (F(-1), F(0))] if rough else []):
            column = [F(0)] * (3 * len(bricks))
            for body, sign in ((i, 1), (j, -1)):
                if body is None:
                    continue
                rx, ry = x - bricks[body][0], y - bricks[body][1]
                column[3 * body] += sign * fx
                column[3 * body + 1] += sign * fy
                column[3 * body + 2] += sign * (rx * fy - ry * fx)
            result.append(column)
    return result


def highest(G, w, q):
    """Largest s with G f + w + s q = 0, f >= 0: a simplex with Bland's rule, in fractions. None: none; inf: no limit."""
    rows, n = len(w), len(G) + 2
    table = []
    for k in range(rows):
        row = [c[k] for c in G] + [q[k], -q[k]] + [F(0)] * rows + [-w[k]]
        if row[-1] < 0:
            row = [-x for x in row]
        row[n + k] = F(1)
        table.append(row)
    basis = [n + k for k in range(rows)]
    cost = [F(0)] * (n + rows + 1)
    for row in table:
        for k in range(n):
            cost[k] -= row[k]
        cost[-1] -= row[-1]
    if run(table, basis, cost, n) is None or cost[-1] != 0:
        return None
    for i in range(rows):  # what is left of the first phase leaves the basis, or its row is void
        if basis[i] >= n:
            column = next((k for k in range(n) if table[i][k] != 0), None)
            if column is not None:
                pivot(table, basis, cost, i, column)
    cost = [F(0)] * (n + rows + 1)
    cost[n - 2], cost[n - 1] = F(-1), F(1)
    for row, b in zip(table, basis):
        if cost[b] != 0:
            times = cost[b]
            cost = [c - times * x for c, x in zip(cost, row)]
    if run(table, basis, cost, n) is None:
        return float("inf")
    return cost[-1]


def run(table, basis, cost, n):
    while True:
        column = next((k for k in range(n) if cost[k] < 0), None)
        if column is None:
            return True
        best = None
        for i, row in enumerate(table):
            if row[column] > 0:
                key = (row[-1] / row[column], basis[i])
                if best is None or key < best[0]:
                    best = (key, i)
        if best is None:
            return None
        pivot(table, basis, cost, best[1], column)


def pivot(table, basis, cost, i, column):
    factor = table[i][column]
    table[i] = [x / factor for x in table[i]]
    for row in table + [cost]:
        if row is not table[i] and row[column] != 0:
            times = row[column]
            row[:] = [x - times * y if y else x for x, y in zip(row, table[i])]
    basis[i] = column


def span(G, w, q, unit=F(1)):
    """[low, high] of s times unit, as floats."""
    high = highest(G, w, q)
    if high is None:
        return None
    low = highest(G, w, [-x for x in q])
    return [None if s == float("inf") else float(sign * s * unit) for sign, s in ((-1, low), (1, high))]


def island(bricks, body):
    """The bricks that touch one another and this one; the others cannot help it."""
    pairs = [(i, j) for i, j, _, _ in contacts(bricks) if j is not None]
    found = {body}
    while True:
        more = {k for pair in pairs if found & set(pair) for k in pair} - found
        if not more:
            return [b for k, b in enumerate(bricks) if k in found], sum(k < body for k in found)
        found |= more


def case(seed):
    r = random.Random(seed)
    bricks = stack(r)
    body = r.randrange(len(bricks))
    near, k = island(bricks, body)
    smooth = columns(near, False)
    shift, load = [F(0)] * (3 * len(near)), [F(0)] * (3 * len(near))
    shift[3 * k + 2] = -near[k][4]
    load[3 * k + 1] = F(-1)
    tilt = [x for b in bricks for x in (b[4], F(0), F(0))]
    return {"bricks": [[float(x) for x in b] for b in bricks], "body": body, "shift": span(smooth, weights(near), shift),
            "load": span(smooth, weights(near), load, GRAVITY), "tilt": span(columns(bricks, True), weights(bricks), tilt)}


print("[" + ",\n".join(json.dumps(case(seed)) for seed in range(1, COUNT + 1)) + "]")
