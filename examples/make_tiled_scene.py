#!/usr/bin/env python3
"""Writes a scene in parts: a glTF that references tiles, each with a file of its own.

    examples/make_tiled_scene.py town.gltf --tiles 6 4 --bodies 40

makes town.gltf and beside it town/0-0.gltf to town/5-3.gltf: hilly ground of triangles that goes on from tile to tile,
houses that stand on it, and crates, balls, pipes and stones upon each other, some across the borders of their tiles. A
tile is written and forgotten before the next, so that a scene may be larger than memory. Deterministic, standard
library only. `graze collide town.gltf` reads it as a whole, `mpirun -n 4 graze-mpi collide town.gltf` in parts;
docs/many-machines.md says what a tile is.
"""
import argparse
import base64
import json
import math
import pathlib
import random
import struct

SIZE = 20.0  # of a tile, in metres
CELLS = 16  # of the ground along each side of a tile
STONE = [[x, y, z] for x in (-0.4, 0.35) for y in (-0.3, 0.32) for z in (-0.38, 0.4)] + [[0, 0.5, 0.05], [0.52, 0, 0]]


def height(x, z):
    """The ground, one function for all tiles, rounded as a file of floats has it."""
    y = 0.8 * math.sin(0.13 * x) * math.cos(0.11 * z) + 0.3 * math.sin(0.31 * x + 0.2 * z)
    return struct.unpack("f", struct.pack("f", y))[0]


class Tile:
    """One glTF with implicit shapes, meshes and rigid bodies."""

    def __init__(self):
        self.shapes, self.nodes, self.meshes = [], [], []
        self.accessors, self.views, self.buffer = [], [], bytearray()

    def shape(self, kind, **numbers):
        entry = {"type": kind, kind: numbers}
        if entry not in self.shapes:
            self.shapes.append(entry)
        return {"shape": self.shapes.index(entry)}

    def values(self, rows, kind, component, fmt):
        flat = [v for row in rows for v in (row if kind == "VEC3" else [row])]
        self.views.append({"buffer": 0, "byteOffset": len(self.buffer), "byteLength": 4 * len(flat)})
        self.buffer.extend(struct.pack("<%d%s" % (len(flat), fmt), *flat))
        entry = {"bufferView": len(self.views) - 1, "componentType": component, "count": len(rows), "type": kind}
        if kind == "VEC3":
            entry["min"] = [min(r[i] for r in rows) for i in range(3)]
            entry["max"] = [max(r[i] for r in rows) for i in range(3)]
        self.accessors.append(entry)
        return len(self.accessors) - 1

    def mesh(self, points, triangles):
        self.meshes.append({"primitives": [{
            "attributes": {"POSITION": self.values(points, "VEC3", 5126, "f")},
            "indices": self.values([i for t in triangles for i in t], "SCALAR", 5125, "I")}]})
        return len(self.meshes) - 1

    def body(self, name, geometry, at, turn=(0, 0, 0, 1), moves=True):
        physics = {"collider": {"geometry": geometry}}
        if moves:
            physics["motion"] = {"mass": 1}
        self.nodes.append({"name": name, "translation": list(at), "rotation": list(turn),
                           "extensions": {"KHR_physics_rigid_bodies": physics}})

    def text(self):
        gltf = {"asset": {"version": "2.0", "generator": "make_tiled_scene.py"},
                "extensionsUsed": ["KHR_implicit_shapes", "KHR_physics_rigid_bodies"],
                "extensions": {"KHR_implicit_shapes": {"shapes": self.shapes}, "KHR_physics_rigid_bodies": {}},
                "scene": 0, "scenes": [{"nodes": list(range(len(self.nodes)))}], "nodes": self.nodes,
                "meshes": self.meshes, "accessors": self.accessors, "bufferViews": self.views,
                "buffers": [{"byteLength": len(self.buffer), "uri": "data:application/octet-stream;base64,"
                             + base64.b64encode(bytes(self.buffer)).decode()}]}
        return json.dumps(gltf) + "\n"


def ground(tile, x0, z0):
    step = SIZE / CELLS
    points = [[i * step, height(x0 + i * step, z0 + j * step), j * step]
              for j in range(CELLS + 1) for i in range(CELLS + 1)]
    corners = [j * (CELLS + 1) + i for j in range(CELLS) for i in range(CELLS)]
    triangles = [t for c in corners for t in ([c, c + CELLS + 1, c + 1], [c + 1, c + CELLS + 1, c + CELLS + 2])]
    tile.body("ground", {"mesh": tile.mesh(points, triangles)}, [0, 0, 0], moves=False)


def random_turn(dice):
    turn = [dice.gauss(0, 1) for _ in range(4)]
    length = math.sqrt(sum(t * t for t in turn))
    return [t / length for t in turn]


def make_tile(column, row, bodies):
    tile, dice = Tile(), random.Random(1000003 * column + row)
    x0, z0 = column * SIZE, row * SIZE
    ground(tile, x0, z0)
    for i in range(3):
        x, z, tall = dice.uniform(3, SIZE - 3), dice.uniform(3, SIZE - 3), dice.uniform(2, 7)
        tile.body("house %d" % i, tile.shape("box", size=[4.0, round(tall, 2), 3.0]),
                  [x, height(x0 + x, z0 + z) + tall / 2 - 0.5, z], moves=False)
    stone = tile.mesh(STONE, [[i, (i + 1) % len(STONE), (i + 2) % len(STONE)] for i in range(len(STONE))])
    for i in range(bodies):
        # Piles: many stand upon the one before, and may reach over the border.
        if i % 3 == 0:
            x, z = dice.uniform(0, SIZE), dice.uniform(0, SIZE)
            y = height(x0 + x, z0 + z) + 0.38
        else:
            x, y, z = x + dice.uniform(-0.3, 0.3), y + dice.uniform(0.6, 0.8), z + dice.uniform(-0.3, 0.3)
        kind = dice.choice(["crate", "ball", "pipe", "stone"])
        geometry = {"crate": lambda: tile.shape("box", size=[0.8, 0.8, 0.8]),
                    "ball": lambda: tile.shape("sphere", radius=0.42),
                    "pipe": lambda: tile.shape("cylinder", height=1.1, radiusBottom=0.3, radiusTop=0.3),
                    "stone": lambda: {"mesh": stone, "convexHull": True}}[kind]()
        tile.body("%s %d" % (kind, i), geometry, [x, y, z], random_turn(dice))
    return tile.text()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", type=pathlib.Path, help="the glTF to write; tiles go to a folder of its name")
    parser.add_argument("--tiles", type=int, nargs=2, default=[6, 4], metavar=("COLUMNS", "ROWS"))
    parser.add_argument("--bodies", type=int, default=40, help="that move, in each tile (40)")
    options = parser.parse_args()
    folder = options.scene.with_suffix("")
    folder.mkdir(parents=True, exist_ok=True)
    nodes = []
    for row in range(options.tiles[1]):
        for column in range(options.tiles[0]):
            name = "%d-%d.gltf" % (column, row)
            (folder / name).write_text(make_tile(column, row, options.bodies))
            nodes.append({"name": "tile %d-%d" % (column, row), "translation": [column * SIZE, 0, row * SIZE],
                          "extras": {"grazeTile": folder.name + "/" + name}})
    options.scene.write_text(json.dumps({
        "asset": {"version": "2.0", "generator": "make_tiled_scene.py"}, "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes}, indent=1) + "\n")


if __name__ == "__main__":
    main()
