"""Newton's and Coulomb's laws in reported states alone: whether any forces of the contacts there give the accelerations that velocities show."""
import math
import random

from case import Case
from gallery import cube, scene

H = 2e-4  # s, between looks
TOUCHING, STILL = 1e-7, 3e-7  # m, m/s: of scenes whose sides and speeds are about 1
MISSED = 1e-6  # of the largest acceleration


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def turned(v):
    return [-v[1], v[0]]


class Body:
    """A cube at an instant, or a plane through the origin, which has no corners."""
    def __init__(self, a_scene, name, of, looks=None):
        self.name, self.friction = name, of.get("friction", a_scene["material"]["friction"])
        self.normal, self.at, self.v, self.a, self.spin, self.corners = of.get("normal"), [0.0, 0.0], [0.0, 0.0], [0.0, 0.0, 0.0], 0.0, []
        if looks is None:
            return
        states = [look["bodies"][name] for look in looks]
        now = states[2]
        self.at, self.v, self.spin = [now["x"], now["y"]], [now["vx"], now["vy"]], now["omega"]
        self.a = [slope([s[key] for s in states]) for key in ("vx", "vy", "omega")]
        self.strays = max(abs(slope([s[p] for s in states]) - now[v]) for p, v in (("x", "vx"), ("y", "vy"), ("theta", "omega")))
        w, h = (side / 2 for side in of["size"])
        u = [math.cos(now["theta"]), math.sin(now["theta"])]
        self.sides = [(u, w, h), ([-u[0], -u[1]], w, h), (turned(u), h, w), (turned([-u[0], -u[1]]), h, w)]  # normal, reach, half length
        self.corners = [[self.at[k] + x * u[k] + y * turned(u)[k] for k in (0, 1)] for x in (w, -w) for y in (h, -h)]
        self.mass = of["mass"]
        self.inertia = self.mass * (w * w + h * h) / 3

    def velocity(self, p):
        return [self.v[k] + self.spin * turned(self.arm(p))[k] for k in (0, 1)]

    def acceleration(self, p):
        r = self.arm(p)
        return [self.a[k] + self.a[2] * turned(r)[k] - self.spin**2 * r[k] for k in (0, 1)]

    def arm(self, p):
        return [p[k] - self.at[k] for k in (0, 1)]


def slope(five):
    return (five[0] - 8 * five[1] + 8 * five[3] - five[4]) / (12 * H)


def contacts(a, b):
    """(corner of a, normal out of b) where they touch."""
    if not b.corners:
        return [(p, b.normal) for p in a.corners if abs(dot(b.normal, p)) < TOUCHING]
    return [(p, n) for p in a.corners for n, reach, half in b.sides
            if abs(dot(n, b.arm(p)) - reach) < TOUCHING and abs(dot(turned(n), b.arm(p))) < half + TOUCHING]


def directions(a, b, p, n, mu, largest):
    """Of the forces on a that Coulomb's law allows: the edges of their cone."""
    t = turned(n)
    v = [x - y for x, y in zip(a.velocity(p), b.velocity(p))]
    if dot(v, n) > STILL:
        return []
    slip = dot(v, t)
    if abs(slip) < STILL:
        slip = dot([x - y for x, y in zip(a.acceleration(p), b.acceleration(p))], t) / largest
        slip = 0.0 if abs(slip) < 1e-3 else slip
    signs = (-1, 1) if slip == 0 else (-1,) if slip > 0 else (1,)
    return [[n[k] + s * mu * t[k] for k in (0, 1)] for s in signs]


def column(bodies, a, b, p, f):
    """What a force at p does to all, each by the root of its mass."""
    col = []
    for body in bodies:
        sign = (body is a) - (body is b)
        col += [sign * f[0] / body.mass**0.5, sign * f[1] / body.mass**0.5, sign * dot(turned(body.arm(p)), f) / body.inertia**0.5]
    return col


def solve(rows, right):
    """Gauss with pivots on the diagonal; unknowns without one are zero."""
    n, rows = len(right), [[*row, r] for row, r in zip(rows, right)]
    done = []
    for k in sorted(range(n), key=lambda i: -rows[i][i]):
        if rows[k][k] < 1e-10:
            continue
        done.append(k)
        for i in range(n):
            if i != k:
                times = rows[i][k] / rows[k][k]
                rows[i] = [x - times * y for x, y in zip(rows[i], rows[k])]
    return [rows[k][n] / rows[k][k] if k in done else 0.0 for k in range(n)]


def distance(columns, goal):
    """Of a goal from the cone of columns [Lawson, Hanson 1974]."""
    columns = [[x / math.hypot(*c) for x in c] for c in columns]
    x, used = [0.0] * len(columns), []
    for _ in range(5 * len(columns) + 5):
        left = [g - sum(c[i] * f for c, f in zip(columns, x)) for i, g in enumerate(goal)]
        gain, best = max(((dot(c, left), k) for k, c in enumerate(columns) if k not in used), default=(0.0, -1))
        if gain <= 1e-12 * math.hypot(*goal):
            break
        used.append(best)
        while used:
            y = solve([[dot(columns[i], columns[j]) for j in used] for i in used], [dot(columns[i], goal) for i in used])
            if min(y) >= 0:
                break
            part = min(x[k] / (x[k] - f) for k, f in zip(used, y) if f < 0)
            for k, f in zip(used, y):
                x[k] += part * (f - x[k])
            used = [k for k, f in zip(used, y) if f >= 0 or x[k] > 1e-14]
            x = [f if k in used else 0.0 for k, f in enumerate(x)]
        for k, f in zip(used, y if used else []):
            x[k] = f
    return math.hypot(*left)


def missed(a_scene, bodies, planes):
    """By how much no forces give the accelerations, as a share of the largest of them."""
    pairs = {frozenset(pair["bodies"]): pair["friction"] for pair in a_scene.get("pair", [])}
    g = a_scene.get("gravity", [0, -9.81])
    largest = math.hypot(*g) + max(math.hypot(*b.a[:2]) + abs(b.a[2]) + b.spin**2 for b in bodies)
    columns = []
    for a in bodies:
        for b in [*bodies, *planes]:
            mu = pairs.get(frozenset((a.name, b.name)), math.sqrt(a.friction * b.friction))
            for p, n in contacts(a, b) if a is not b else []:
                columns += [column(bodies, a, b, p, f) for f in directions(a, b, p, n, mu, largest)]
    goal = []
    for b in bodies:
        goal += [b.mass**0.5 * (b.a[0] - g[0]), b.mass**0.5 * (b.a[1] - g[1]), b.inertia**0.5 * b.a[2]]
    return distance(columns, goal) / (largest * sum(b.mass for b in bodies)**0.5)


def obeys(a_scene, times):
    def expect(answer):
        if answer["cost"]["hand_overs"]:
            return None  # stepped: of second order only
        looks = {look["t"]: look for look in answer["samples"]}
        events = [event["t"] for event in answer["events"]]
        planes = [Body(a_scene, plane["name"], plane) for plane in a_scene["plane"]]
        for t in times:
            if any(abs(t - e) < 3 * H for e in events):
                continue
            five = [looks[u] for u in around(t)]
            bodies = [Body(a_scene, c["name"], c, five) for c in a_scene["cube"]]
            strays = max(b.strays for b in bodies)
            if strays > 1e-6 * (1 + max(math.hypot(*b.v) for b in bodies)):
                return f"velocities are by {strays:.2g} m/s not those of positions at {t:.4f} s"
            wrong = missed(a_scene, bodies, planes)
            if wrong > MISSED:
                return f"no forces give the accelerations at {t:.4f} s, by {wrong:.2g} of the largest"
        return None
    return expect


def around(t):
    return [t + k * H for k in (-2, -1, 0, 1, 2)]


def leaning(draw):
    """A ladder at a wall."""
    length, width, angle = draw.uniform(1, 3), draw.uniform(0.02, 0.3), math.pi - draw.uniform(0.2, 1.4)
    reach = [length / 2 * abs(math.cos(angle)) + width / 2 * math.sin(angle), length / 2 * math.sin(angle) + width / 2 * abs(math.cos(angle))]
    return [{"name": "floor", "normal": [0, 1]}, {"name": "wall", "normal": [1, 0]}], [cube("a", *reach, size=[length, width], angle=angle, mass=1.0)]


def rocking(draw):
    w, h, angle = draw.uniform(0.2, 1), draw.uniform(0.2, 2), draw.uniform(-0.5, 0.5)
    y = w / 2 * abs(math.sin(angle)) + h / 2 * math.cos(angle)
    return [{"name": "floor", "normal": [0, 1]}], [cube("a", 0, y, size=[w, h], angle=angle, mass=1.0, velocity=[draw.choice([0, draw.uniform(-3, 3)]), 0])]


def thrown(draw):
    """Up to three cubes onto ground that is level, or a groove."""
    slope_of = draw.choice([0, draw.uniform(0.2, 0.8)])
    planes = [{"name": f"p{side}", "normal": [side * math.sin(slope_of), math.cos(slope_of)]} for side in ((1, -1) if slope_of else (1,))]
    return planes, [cube(f"c{i}", 2.2 * (i % 2) - 1, 3.6 + 2.4 * (i // 2), size=[draw.uniform(0.4, 1.5), draw.uniform(0.4, 1.5)], mass=10**draw.uniform(-1, 1),
                         angle=draw.uniform(-3, 3), velocity=[draw.uniform(-3, 3), draw.uniform(-3, 3)], spin=draw.uniform(-5, 5),
                         friction=draw.choice([0, 0.3, 1.0, draw.random()])) for i in range(draw.randint(1, 3))]


def sliding(draw):
    """Slabs on each other on a slope, each with a speed of its own."""
    angle, depth, cubes = draw.uniform(0.1, 0.9), 0.0, []
    along, up = [math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]
    for i in range(draw.randint(1, 4)):
        h, v = draw.uniform(0.2, 0.7), draw.choice([0, draw.uniform(-2, 2)])
        cubes.append(cube(f"b{i}", *[(depth + h / 2) * x for x in up], size=[draw.uniform(0.6, 2), h], mass=10**draw.uniform(-0.7, 0.7), angle=angle,
                          velocity=[v * x for x in along]))
        depth += h
    return [{"name": "slope", "normal": up}], cubes


def random_laws(seed):
    draw = random.Random(f"laws {int(seed)}")
    planes, cubes = draw.choice([leaning, rocking, thrown, sliding])(draw)
    a_scene = scene(cubes, 1.5, planes=planes, material={"friction": draw.choice([0.1, 0.3, 0.6, draw.random()]), "restitution": draw.choice([0, 0, 0.4])})
    if draw.random() < 0.5:
        a_scene["pair"] = [{"bodies": [planes[0]["name"], cubes[0]["name"]], "friction": draw.random()}]
    times = [0.04 + 0.07 * k for k in range(21)]
    return [Case(a_scene, ("--sample", ",".join(repr(u) for t in times for u in around(t))), expect=obeys(a_scene, times))]
