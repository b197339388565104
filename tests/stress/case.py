"""One call of the program, and what is to be said of its answer."""
import dataclasses
import json
import math
import resource
import signal
import subprocess
import time

from overlap import MANY, deepest, sizes

OVERLAP = 1e-9  # of the smaller side
ENERGY = 1e-6  # of the energy at hand

# How a run ends, from good to bad. The first three tell the caller what happened; the rest are faults.
FINE, REFUSED, OVER_BUDGET = "fine", "refused", "over budget"
FAULTS = ("hang", "crash", "internal error", "not a number", "overlap", "gains energy", "wrong answer")


@dataclasses.dataclass
class Case:
    """A scene, how to call the program with it, and what must be true of the answer."""
    scene: dict
    arguments: tuple = ()
    command: str = "run"
    expect: object = None  # function of the parsed answer: None, what is wrong with it, or an Outcome
    refuse: bool = False  # the scene is to be refused
    energy: float = 0.0  # J, the energy at hand where start, end and losses do not show it
    drift: float = ENERGY  # of the energy at hand
    name: str = ""
    then: object = None  # function of the scene and the parsed answer, if that is right: a case that must hold as well


@dataclasses.dataclass
class Outcome:
    status: str
    text: str = ""
    overlap: float = 0.0  # of the smaller side
    seconds: float = 0.0
    steps: int = 0

    @property
    def fault(self):
        return self.status in FAULTS


def smaller_side(scene):
    sides = [1.0]
    bodies = [b for kind in ("cube", "fixed", "tower", "wall", "pyramid", "pile") for b in scene.get(kind, [])]
    if bodies:
        sides = []
    for body in bodies:
        size = body.get("size", 1.0)
        sides += size if isinstance(size, list) else [size]
    return min(sides)


def strange_number(value):
    """Whether a number somewhere in the answer is none: JSON writes NaN and infinity as null."""
    if isinstance(value, dict):
        return any(strange_number(v) for v in value.values())
    if isinstance(value, list):
        return any(strange_number(v) for v in value)
    return value is None or (isinstance(value, float) and not math.isfinite(value))


def looks(case):
    """Samples at four times, the last at the end; of crowds, at the end alone."""
    end = case.scene.get("duration", 5.0)
    if len(sizes(case.scene)) > MANY:
        return ["--sample", repr(end)]
    return ["--sample", ",".join(repr(t) for t in sorted({end / 4, end / 2, 3 * end / 4, end}))]


def call(program, case, limit):
    """(exit code or None after `limit` seconds, standard output, standard error).

    Seconds are the processor's, so that a busy machine hangs nobody; ten times as many on the clock are too many as well.
    """
    def allow():
        resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(limit), math.ceil(limit)))
    try:
        done = subprocess.run([program, case.command, "-", "--json", *(["--quiet", *looks(case)] if case.command == "run" else []), *case.arguments],
                              input=json.dumps(case.scene), capture_output=True, text=True, timeout=10 * limit, preexec_fn=allow)
        # The soft and the hard limit are one: some kernels send one signal there, some the other.
        code = None if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL) else done.returncode
        return code, done.stdout, done.stderr.strip()
    except subprocess.TimeoutExpired:
        return None, "", ""


def rounding(answer):
    """m, of the positions of all samples."""
    far = [abs(body[key]) for sample in answer["samples"] for body in sample["bodies"].values() for key in ("x", "y")]
    return 16 * 2.0**-52 * max(far, default=0.0)


def judge_audit(case, answer):
    audit = answer["audit"]
    overlap = audit["max_penetration"] / smaller_side(case.scene)
    steps = answer["cost"]["steps"]
    seen = max((deepest(case.scene, sample) for sample in answer["samples"]), default=0.0) / smaller_side(case.scene)
    # Sines of the C library and sums in another order: as much as rounding of positions explains.
    if seen > OVERLAP + overlap + rounding(answer) / smaller_side(case.scene):
        return Outcome("overlap", f"overlap of {seen:.2g} of the smaller side, reported is {overlap:.2g}", seen, 0, steps)
    if overlap > OVERLAP:
        return Outcome("overlap", f"overlap of {overlap:.2g} of the smaller side", overlap, 0, steps)
    energy = audit["energy"]
    at_hand = max(abs(energy["start"]), abs(energy["end"]), energy["impact_loss"], case.energy)
    if energy["drift"] > case.drift * at_hand:
        return Outcome("gains energy", f"energy grew by {energy['drift']:.2g} J of {at_hand:.2g} J", overlap, 0, steps)
    return Outcome(FINE, "", overlap, 0, steps)


def judge_answer(case, answer):
    null_says_something = case.command == "explain" or "--margin" in case.arguments  # no corner, no limit
    if not null_says_something and strange_number(answer):
        return Outcome("not a number", "a number in the answer is null")
    outcome = judge_audit(case, answer) if case.command == "run" else Outcome(FINE)
    if outcome.status == FINE and case.expect:
        wrong = case.expect(answer)
        if isinstance(wrong, Outcome):
            return wrong
        if wrong:
            outcome.status, outcome.text = "wrong answer", wrong
    return outcome


def judge(case, limit, code, out, err):
    if code is None:
        return Outcome("hang", f"no end after {limit:g} s")
    if code < 0:
        return Outcome("crash", f"signal {-code}")
    if code == 2:
        return Outcome(FINE if case.refuse else REFUSED, err)
    if case.refuse:
        return Outcome("wrong answer", "taken, though it is to be refused")
    if code not in (0, 1, 3):
        return Outcome("internal error", f"exit code {code}: {err}")
    try:
        outcome = judge_answer(case, json.loads(out))
    except ValueError:
        return Outcome("internal error", "the answer is not JSON")
    if code == 3 and (outcome.status == FINE or case.command == "check"):
        outcome.status, outcome.text = OVER_BUDGET, err or "undecided"
    return outcome


def run_case(program, case, limit):
    begin = time.monotonic()
    code, out, err = call(program, case, limit)
    seconds = time.monotonic() - begin
    outcome = judge(case, limit, code, out, err)
    if case.then and outcome.status == FINE and out:
        outcome = run_case(program, case.then(case.scene, json.loads(out)), limit)
        seconds += outcome.seconds
    outcome.seconds = seconds
    return outcome
