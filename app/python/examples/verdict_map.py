#!/usr/bin/env python3
"""Which stacks of three stand? One character per stack: the middle block is shifted by x, the top one by y against it.

    python3 verdict_map.py            # 61 x 31 exact verdicts as text
    python3 verdict_map.py map.png    # 201 x 201 as a picture (python3-matplotlib)
"""
import sys

import numpy as np

import wuerfel as w


def verdicts(columns, rows, reach=0.75):
    template = w.Scene({"plane": [{"name": "floor"}],
                        "cube": [{"name": "a", "on": "floor"}, {"name": "b", "on": "a"}, {"name": "c", "on": "b"}]})
    x, y = np.linspace(-reach, reach, columns), np.linspace(reach, -reach, rows)
    scenes = [template.with_(**{"cube.b.offset": float(b), "cube.c.offset": float(c)}) for c in y for b in x]
    stands = np.array([check.verdict == "stands" for check in w.check_many(scenes)])
    return x, y, stands.reshape(rows, columns)


def main():
    if len(sys.argv) < 2:
        for row in verdicts(61, 31)[2]:
            print("".join("#" if stands else "." for stands in row))
        return
    import matplotlib
    matplotlib.use("agg")
    from matplotlib import pyplot
    x, y, stands = verdicts(201, 201)
    pyplot.imshow(stands, extent=(x[0], x[-1], y[-1], y[0]), cmap="Greens")
    pyplot.xlabel("shift of the middle block / m")
    pyplot.ylabel("shift of the top block against it / m")
    pyplot.title("stacks of three that stand")
    pyplot.savefig(sys.argv[1], dpi=150)


if __name__ == "__main__":
    main()
