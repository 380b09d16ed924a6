#!/usr/bin/env python3
"""Writes examples/scenes/demo.gltf: a small pile of every kind of shape, some of which touch.

Deterministic, standard library only. The scene has no visible meshes but one: `graze collide --out` draws colliders.
"""
import base64
import json
import math
import pathlib
import struct

shapes, nodes, buffers, views, accessors, meshes = [], [], bytearray(), [], [], []


def shape(kind, **numbers):
    shapes.append({"type": kind, kind: numbers})
    return len(shapes) - 1


def turned(axis, degrees):
    half = math.radians(degrees) / 2
    return [a * math.sin(half) for a in axis] + [math.cos(half)]


def accessor(values, kind, component, fmt):
    flat = [v for value in values for v in (value if isinstance(value, (list, tuple)) else [value])]
    views.append({"buffer": 0, "byteOffset": len(buffers), "byteLength": len(flat) * struct.calcsize(fmt)})
    buffers.extend(struct.pack("<%d%s" % (len(flat), fmt), *flat))
    entry = {"bufferView": len(views) - 1, "componentType": component, "count": len(values), "type": kind}
    if kind == "VEC3":
        entry["min"] = [min(v[i] for v in values) for i in range(3)]
        entry["max"] = [max(v[i] for v in values) for i in range(3)]
    accessors.append(entry)
    return len(accessors) - 1


def mesh(points, triangles):
    position = accessor(points, "VEC3", 5126, "f")
    indices = accessor([i for t in triangles for i in t], "SCALAR", 5125, "I")
    meshes.append({"primitives": [{"attributes": {"POSITION": position}, "indices": indices}]})
    return len(meshes) - 1


def bowl(radius, depth, rings, sectors):
    points = [[0.0, -depth, 0.0]]
    for r in range(1, rings + 1):
        for s in range(sectors):
            angle, part = 2 * math.pi * s / sectors, r / rings
            points.append([radius * part * math.cos(angle), depth * (part * part - 1), radius * part * math.sin(angle)])
    triangles = [[0, 1 + (s + 1) % sectors, 1 + s] for s in range(sectors)]
    for r in range(rings - 1):
        for s in range(sectors):
            a, b = 1 + r * sectors + s, 1 + r * sectors + (s + 1) % sectors
            triangles += [[a, b, b + sectors], [a, b + sectors, a + sectors]]
    return mesh(points, triangles)


def node(name, geometry, translation, rotation=None, moves=True, trigger=False, group=0, scale=None):
    physics = {"trigger" if trigger else "collider": {"geometry": geometry, "collisionFilter": group}}
    if moves:
        physics["motion"] = {"mass": 1}
    entry = {"name": name, "translation": translation, "extensions": {"KHR_physics_rigid_bodies": physics}}
    if rotation:
        entry["rotation"] = rotation
    if scale:
        entry["scale"] = scale
    nodes.append(entry)
    return len(nodes) - 1


def of(index):
    return {"shape": index}


roots = []
cube = shape("box", size=[1, 1, 1])
ball = shape("sphere", radius=0.5)

roots.append(node("floor", of(shape("box", size=[11, 0.5, 8])), [0, -0.25, 0], moves=False))
for i, (x, y, angle) in enumerate([(-3.4, 0.495, 4), (-2.1, 0.497, -7), (-2.7, 1.487, 18), (-2.66, 2.48, 40)]):
    roots.append(node("crate %d" % (i + 1), of(cube), [x, y, -1.2], turned([0, 1, 0], angle)))
roots.append(node("bowl", {"mesh": bowl(1.4, 0.8, 6, 24)}, [0.9, 0.81, -1.6], moves=False))
roots.append(node("ball in the bowl", of(ball), [0.8, 0.515, -1.55]))
roots.append(node("column", of(shape("cylinder", height=2.2, radiusBottom=0.42, radiusTop=0.42)), [3.8, 1.095, -1.5]))
roots.append(node("roller", of(shape("cylinder", height=1.6, radiusBottom=0.4, radiusTop=0.4)), [3.1, 0.392, 1.0],
                  turned([0.6, 0, 0.8], 90)))
roots.append(node("pin", of(shape("capsule", height=1.2, radiusBottom=0.34, radiusTop=0.34)), [-4.31, 0.916, -1.15],
                  turned([0, 0, 1], -14)))
roots.append(node("skittle", of(shape("capsule", height=0.9, radiusBottom=0.42, radiusTop=0.24)), [1.3, 0.863, 1.5]))
roots.append(node("hat", of(shape("cylinder", height=1.1, radiusBottom=0.6, radiusTop=0)), [3.8, 2.735, -1.5]))
roots.append(node("pebble", of(ball), [-0.5, 0.372, 1.35], turned([0, 0, 1], 12), scale=[1.5, 0.7, 1.0]))
golden = (1 + math.sqrt(5)) / 2
corners = [p for s in (-1, 1) for t in (-golden, golden) for p in ([0, s, t], [s, t, 0], [t, 0, s])]
stone = mesh([[0.36 * c for c in p] for p in corners], [[i, (i + 1) % 12, (i + 2) % 12] for i in range(12)])
roots.append(node("stone", {"mesh": stone, "convexHull": True}, [-2.0, 0.535, 1.5], turned([1, 0.3, 0], 20.9)))

bar = shape("box", size=[1.5, 0.3, 0.3])
weight = shape("sphere", radius=0.38)
dumbbell = [node("bar", of(bar), [0, 0, 0], moves=False),
            node("left weight", of(weight), [-0.75, 0, 0], moves=False),
            node("right weight", of(weight), [0.75, 0, 0], moves=False)]
nodes.append({"name": "dumbbell", "translation": [-4.0, 0.372, 1.6], "rotation": turned([0, 1, 0], 35),
              "children": dumbbell, "extensions": {"KHR_physics_rigid_bodies": {"motion": {"mass": 3}}}})
roots.append(len(nodes) - 1)

roots.append(node("gate", of(shape("box", size=[0.3, 2.2, 2.2])), [2.4, 1.1, 1.3], moves=False, trigger=True))
roots.append(node("ghost", of(cube), [0.5, 0.35, 2.7], turned([0, 1, 0], 30), group=1))

physics = {"collisionFilters": [{"collisionSystems": ["solid"]},
                                {"collisionSystems": ["ghost"], "notCollideWithSystems": ["solid"]}]}
scene = {
    "asset": {"version": "2.0", "generator": "scripts/make_demo_scene.py"},
    "extensionsUsed": ["KHR_implicit_shapes", "KHR_physics_rigid_bodies"],
    "extensions": {"KHR_implicit_shapes": {"shapes": shapes}, "KHR_physics_rigid_bodies": physics},
    "scene": 0,
    "scenes": [{"name": "demo", "nodes": roots}],
    "nodes": nodes,
    "meshes": meshes,
    "accessors": accessors,
    "bufferViews": views,
    "buffers": [{"byteLength": len(buffers),
                 "uri": "data:application/octet-stream;base64," + base64.b64encode(bytes(buffers)).decode()}],
}
target = pathlib.Path(__file__).resolve().parent.parent / "examples" / "scenes" / "demo.gltf"
target.write_text(json.dumps(scene, indent=1) + "\n")
