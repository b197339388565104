"""The sweeps as a page of Markdown, and as one plot."""
import os
import shutil
import subprocess

INTRODUCTION = """# Stress report

Program: {version}. Machine: {machine}. Form: {form}; time limit per run {limit:g} s.
"Holds to" is the last value before the first that does not hold. A *fault* is a hang, a crash, an internal error (exit code 4), a
number that is none, an overlap above 1e-9 of the smaller side, energy from nothing, or a wrong answer; a *status* is a message with
exit code 2 (refused) or 3 (over the error budget): the caller knows.

| family | swept | from .. to | holds to | gives at | how it shows | faults | statuses | runs | longest run | worst overlap | repeat with |
|---|---|---|---|---|---|---|---|---|---|---|---|
"""

PLOT = """set terminal svg size 900,{height} font "sans,13" background "white"
set output "{svg}"
set logscale x
set format x "10^{{%T}}"
set yrange [-0.7:{top}]
set xlabel "value of what is swept (its unit is in the table)"
set grid x lc rgb "#dddddd"
set key outside top center horizontal
set xrange [{low:g}:{high:g}]
set ytics ({tics})
plot "{data}" index 0 using 1:2 with points pt 7 ps 0.9 lc rgb "#0072b2" title "holds", \\
     "" index 1 using 1:2 with points pt 4 ps 1.4 lw 2 lc rgb "#e69f00" title "clear status (exit 2 or 3)", \\
     "" index 2 using 1:2 with points pt 2 ps 1.4 lw 2 lc rgb "#000000" title "fault"
"""


def text(value):
    return "-" if value is None else f"{value:g}"


def row(sweep):
    failures = sweep.failures
    holds, gives = sweep.bounds()
    if sweep.family.collection:
        done = len(sweep.results)
        swept, holds_to = f"{done} {sweep.family.quantity}", f"{done - len({r.value for r in failures})} of {done}"
        gives_at = "-" if not failures else ", ".join(sorted({r.label for r in failures}))[:120]
    else:
        swept = f"{text(sweep.results[0].value)} .. {text(sweep.results[-1].value)}"
        holds_to, gives_at = text(holds), text(gives)
    first = failures[0] if failures else None
    shows = f"{first.worst.status}: {first.worst.text}".replace("|", "/").replace("\n", " ")[:160] if first else "-"
    faults = sum(o.fault for r in sweep.results for o in r.outcomes)
    statuses = sum(o.status != "fine" and not o.fault for r in sweep.results for o in r.outcomes)
    runs = sum(len(r.outcomes) for r in sweep.results)
    again = f"`tests/stress/sweep --family {sweep.family.name}" + (f" --value {first.value:g}`" if first else "`")
    return (f"| {sweep.family.name} | {sweep.family.quantity} | {swept} | {holds_to} | {gives_at} | {shows} | {faults} | {statuses} | {runs} | "
            f"{sweep.longest:.2g} s | {sweep.overlap:.1g} | {again} |\n")


def saved_scenes(sweeps):
    lines = [f"- {r.label}: {r.worst.status}: {r.worst.text}; `{r.command}`\n" for s in sweeps for r in s.failures if r.command]
    return "\n## What did not hold, run by run\n\n" + "".join(lines) if lines else ""


def plot_data(sweeps):
    blocks = [[], [], []]
    for level, sweep in enumerate(reversed(sweeps)):
        for r in sweep.results:
            kind = 0 if r.holds else 2 if r.worst.fault else 1
            blocks[kind].append(f"{r.value:g} {level}")
    # An empty block would shift the index of the next one.
    return "\n\n\n".join("\n".join(block or ["NaN NaN"]) for block in blocks) + "\n"


def draw(sweeps, folder):
    """The name of the plot, or None without gnuplot."""
    sweeps = [s for s in sweeps if not s.family.collection]
    if not shutil.which("gnuplot") or not sweeps:
        return None
    data = os.path.join(folder, "stress.dat")
    with open(data, "w") as file:
        file.write(plot_data(sweeps))
    tics = ", ".join(f'"{s.family.name.replace("_", " ")}" {level}' for level, s in enumerate(reversed(sweeps)))
    values = [r.value for s in sweeps for r in s.results]
    script = PLOT.format(low=min(values) / 5, high=max(values) * 5, svg=os.path.join(folder, "stress.svg"), data=data, top=len(sweeps) - 0.3, tics=tics, height=160 + 30 * len(sweeps))
    subprocess.run(["gnuplot"], input=script, text=True, check=True)
    os.remove(data)
    return "stress.svg"


def write(path, sweeps, **about):
    page = INTRODUCTION.format(**about) + "".join(row(s) for s in sweeps)
    svg = draw(sweeps, os.path.dirname(os.path.abspath(path)))
    page += f"\n![Where each family gives]({svg})\n" if svg else "\nNo plot: gnuplot is not installed.\n"
    page += saved_scenes(sweeps)
    with open(path, "w") as file:
        file.write(page)
