"""Overlap measured from reported states alone: the program's own audit is not believed."""
import math

MANY = 80  # bodies; every pair is looked at


def sizes(scene):
    """Name -> (width, height) of every moving body; None where the scene has generators of mixed sizes."""
    found = {}
    for i, body in enumerate(scene.get("cube", [])):
        found[body.get("name", f"cube{i + 1}")] = body.get("size", 1.0)
    for kind in ("tower", "pile"):
        for i, group in enumerate(scene.get(kind, [])):
            for k in range(group["count"]):
                found[f"{group.get('name', kind + str(i + 1))}_{k + 1}"] = group.get("size", 1.0)
    return {name: tuple(size) if isinstance(size, list) else (size, size) for name, size in found.items()}


def box(x, y, angle, size, origin):
    """(middle, axes, half sides), the middle relative to `origin`, which keeps small bodies exact far away."""
    c, s = math.cos(angle), math.sin(angle)
    return (x - origin[0], y - origin[1]), ((c, s), (-s, c)), (size[0] / 2, size[1] / 2)


def reach(a_box, direction):
    return sum(h * abs(axis[0] * direction[0] + axis[1] * direction[1]) for axis, h in zip(a_box[1], a_box[2]))


def depth(a, b):
    """How deep two boxes are in each other: the smallest way out, by separating axes; negative if apart."""
    way = (b[0][0] - a[0][0], b[0][1] - a[0][1])
    return min(reach(a, n) + reach(b, n) - abs(way[0] * n[0] + way[1] * n[1]) for n in (*a[1], *b[1]))


def depth_in_plane(a, plane, origin):
    normal, point = plane.get("normal", [0, 1]), plane.get("point", [0, 0])
    length = math.hypot(*normal)
    n = (normal[0] / length, normal[1] / length)
    return reach(a, n) - sum(n[i] * (a[0][i] - (point[i] - origin[i])) for i in (0, 1))


def deepest(scene, sample):
    """m, of the deepest pair of a sample; 0 for scenes with too many bodies to look at all pairs."""
    known, bodies = sizes(scene), sample["bodies"]
    if len(bodies) > MANY or not bodies or set(known) != set(bodies):
        return 0.0
    first = next(iter(bodies.values()))
    origin = (first["x"], first["y"])
    boxes = [box(b["x"], b["y"], b["theta"], known[name], origin) for name, b in bodies.items()]
    still = [box(*f["position"], f.get("angle", 0.0), f["size"] if isinstance(f["size"], list) else [f["size"]] * 2, origin)
             for f in scene.get("fixed", [])]
    worst = 0.0
    for i, a in enumerate(boxes):
        for b in boxes[i + 1:] + still:
            if math.hypot(b[0][0] - a[0][0], b[0][1] - a[0][1]) < math.hypot(*a[2]) + math.hypot(*b[2]):
                worst = max(worst, depth(a, b))
        for plane in scene.get("plane", []):
            worst = max(worst, depth_in_plane(a, plane, origin))
    return worst
