"""line_coverage.py BUILD ROOT FOLDER: which lines of ROOT/FOLDER were run, by the counts that gcov finds below BUILD.

A line of a header counts as run where any file that includes it ran it. Prints what no test runs, then the share of lines
that were run; exit code 1 where it is below 95 %.
"""
import collections
import json
import os
import subprocess
import sys

LEAST = 95.0  # %
BATCH = 20    # files per call of gcov


def notes_below(build):
    return sorted(os.path.join(folder, name) for folder, _, names in os.walk(build) for name in names if name.endswith(".gcno"))


def counts_of(notes, root, folder):
    """file -> line -> how often it was run, of files in the folder."""
    counts = collections.defaultdict(collections.Counter)
    for first in range(0, len(notes), BATCH):
        done = subprocess.run(["gcov", "--json-format", "--stdout", *notes[first:first + BATCH]], capture_output=True, text=True, check=True)
        for document in done.stdout.splitlines():
            unit = json.loads(document)
            for file in unit["files"]:
                path = os.path.relpath(os.path.join(unit["current_working_directory"], file["file"]), root)
                if not path.startswith(folder + os.sep):
                    continue
                for line in file["lines"]:
                    counts[path][line["line_number"]] += line["count"]
    return counts


def ranges(lines):
    """[3, 4, 5, 9] -> "3-5, 9"."""
    parts = []
    for line in lines:
        if parts and parts[-1][1] == line - 1:
            parts[-1][1] = line
        else:
            parts.append([line, line])
    return ", ".join(str(a) if a == b else f"{a}-{b}" for a, b in parts)


def main(build, root, folder):
    counts = counts_of(notes_below(build), os.path.realpath(root), folder)
    lines = sum(len(file) for file in counts.values())
    missed = {path: sorted(line for line, count in file.items() if count == 0) for path, file in sorted(counts.items())}
    for path, never in missed.items():
        if never:
            print(f"{path}: {100 * (1 - len(never) / len(counts[path])):.1f} %, never {ranges(never)}")
    run = lines - sum(len(never) for never in missed.values())
    if not lines:
        sys.exit(f"no counts below {build}")
    share = 100 * run / lines
    print(f"{folder}: {run} of {lines} lines are run, {share:.2f} %")
    return 0 if share >= LEAST else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
