"""Bounds for figures that must not get worse: read, written, and held against what was measured.

Figures are a dictionary from the name of a row to its figures by name; bounds have the same form. All figures are better
the smaller they are; a figure that a row does not have is not there."""
import csv

# Of an error a bound is the measured size times HEADROOM, and at least this: what rounding may do.
HEADROOM = 4.0
FLOOR = {
    "state_error": 1e-13,  # of the size of a cube, as in `bench`
    "event_error_s": 1e-13,
    "overlap_m": 1e-12,
    "energy_drift_J": 1e-11,
    "residual": 1e-11,  # asked for is 1e-10
}
# Of a count of instructions: a compiler's update may cost some percent, a lost warm start costs a factor.
RATIO = "ratio"
RATIO_HEADROOM = 1.5

FIGURES = [*FLOOR, RATIO]


def bound_of(name, value):
    """The bound to record for a figure of this name and value."""
    if name == RATIO:
        return RATIO_HEADROOM * value
    # What stands does not move at all, and a state error of exactly zero happens nowhere else.
    if name == "state_error" and value == 0.0:
        return 0.0
    return max(HEADROOM * value, FLOOR[name])


def judge(bounds, measured):
    """One line for everything that is worse than its bound or that only one of the two has."""
    complaints = []
    for row in sorted({*bounds, *measured}):
        if row not in measured:
            complaints.append(f"{row}: was not measured")
        elif row not in bounds:
            complaints.append(f"{row}: has no bound")
        else:
            complaints += [f"{row}: {c}" for c in judge_row(bounds[row], measured[row])]
    return complaints


def judge_row(bounds, figures):
    for name in FIGURES:
        if name in bounds and name not in figures:
            yield f"{name} was not measured"
        elif name in figures and name not in bounds:
            yield f"{name} has no bound"
        elif name in bounds and not figures[name] <= bounds[name]:  # what is not a number fails too
            yield f"{name} is {figures[name]:.3g}, its bound {bounds[name]:.3g}"


def read_bounds(path):
    with open(path, newline="") as file:
        return {line["row"]: {name: float(line[name]) for name in FIGURES if line[name]} for line in csv.DictReader(file)}


def write_bounds(path, measured):
    with open(path, "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["row", *FIGURES])
        for row, figures in measured.items():
            out.writerow([row, *(f"{bound_of(name, figures[name]):.2g}" if name in figures else "" for name in FIGURES)])
