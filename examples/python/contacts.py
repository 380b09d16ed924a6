"""Contacts, drawn: a pile in the plane, and one box on another in space.

A notebook in a file: each `# %%` begins a cell for an editor that knows them, and the whole runs as a program:

    python3 examples/python/contacts.py [picture.svg]
"""

# %% What is drawn with
import io
import itertools
import pathlib
import sys

import matplotlib

matplotlib.use("svg" if __name__ == "__main__" else matplotlib.get_backend())
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import graze
from graze import plane

matplotlib.rcParams.update({"svg.hashsalt": "graze", "font.size": 9})


# %% A renderer: what the library draws, on the axes of matplotlib
class Paper:
    layers = ["shapes", "contacts"]

    def __init__(self, axes, center=(0, 0, 0), size=1, alpha=1):
        self.axes, self.center, self.size, self.alpha = axes, center, size, alpha
        self.flat = not hasattr(axes, "zaxis")

    @staticmethod
    def color(meaning):
        return np.array(graze.suggested_color(meaning)) / 255

    def polygon(self, corners, layer, meaning):
        look = {"fc": self.color(meaning), "ec": "#333333", "lw": 0.8, "alpha": self.alpha}
        if self.flat:
            self.axes.fill(*corners.T[:2], **look)
        else:
            self.axes.add_collection3d(Poly3DCollection([upright(corners)], **look))

    def point(self, at, layer, meaning):
        at = at[:2] if self.flat else upright(at)
        self.axes.plot(*at[:, None], "o", color=self.color(meaning), ms=5, zorder=3)

    def arrow(self, at, direction, layer, meaning):
        color = self.color(meaning)
        if self.flat:
            self.axes.annotate("", at[:2] + 0.45 * direction[:2], at[:2], zorder=3,
                               arrowprops={"arrowstyle": "-|>", "color": color, "shrinkA": 0, "shrinkB": 0})
        else:
            self.axes.quiver(*upright(at), *(0.5 * upright(direction)), color=color, lw=1.2)


def upright(points):
    """Y is up in Graze's scenes, z in matplotlib's."""
    return np.asarray(points)[..., [2, 0, 1]]


# %% A pile in the plane: shapes, and where each stands (x, y, angle)
PILE = [
    (plane.HalfPlane(), (0, 0, 0)),
    (plane.Box((3, 1)), (-1, 0.49, 0)),
    (plane.Box((1.2, 1.1)), (1.9, 0.545, 0)),
    (plane.Circle(0.6), (-1.6, 1.57, 0)),
    (plane.ConvexPolygon([(-0.9, -0.4), (0.9, -0.4), (0.5, 0.5), (-0.5, 0.5)]), (1.15, 1.49, -0.06)),
    (plane.Capsule(1.4, 0.3), (-0.43, 2.03, 1.25)),
]


def world_of(pile, margin):
    world = plane.World(margin=margin)
    for shape, pose in pile:
        world.add(shape, pose, fixed=isinstance(shape, plane.HalfPlane))
    world.update()
    return world


def draw_pile(axes, world):
    plane.draw(Paper(axes, size=4), world)
    axes.set(aspect="equal", xlim=(-3, 3.2), ylim=(-0.5, 3), title="A world of the plane: contacts, normals from a to b")


# %% One box on another, turned by 35 degrees, a hundredth deep: the corners of the area that they share
LOWER, UPPER = graze.Box((2, 1, 2)), graze.Box((1.6, 1, 1.6))
ANGLE = np.radians(35)
ON_TOP = graze.Pose((0.5, 0.99, 0.2), (0, np.sin(ANGLE / 2), 0, np.cos(ANGLE / 2)))


def draw_boxes(axes):
    [manifold] = graze.contacts(LOWER, None, UPPER, ON_TOP)
    paper = Paper(axes, alpha=0.25)
    graze.draw(paper, LOWER, None, "a")
    graze.draw(paper, UPPER, ON_TOP, "b")
    graze.draw(paper, manifold)
    area = np.array([p.position for p in manifold.points])
    axes.add_collection3d(Poly3DCollection([upright(area)], fc=paper.color("contact"), alpha=0.35))
    axes.set(xlim=(-1, 1.3), ylim=(-1, 1.6), zlim=(-0.5, 1.6),
             title=f"graze.contacts: {len(manifold)} points span the area")
    axes.set_box_aspect((2.3, 2.6, 2.1), zoom=1.05)
    axes.set_axis_off()
    axes.view_init(32, -50)


# %% Both, side by side
def picture():
    figure = plt.figure(figsize=(10, 4.2))
    draw_pile(figure.add_subplot(1, 2, 1), world_of(PILE, margin=0.02))
    draw_boxes(figure.add_subplot(1, 2, 2, projection="3d"))
    figure.tight_layout()
    return figure


# %% The picture's colours in a dark page: matplotlib writes those of a light one into the style of each element
DARK = """<style>@media (prefers-color-scheme: dark) {
  svg { fill: #e6e6e6 }
  [style*="fill: #ffffff"] { fill: #16181d !important }
  [style*="stroke: #000000"], [style*="stroke: #333333"] { stroke: #c8ccd2 !important }
  [style*="fill: #1d3557"] { fill: #8fb8e8 !important }
  [style*="stroke: #1d3557"] { stroke: #8fb8e8 !important }
  [style*="fill: #c1121f"] { fill: #ff6b6b !important }
  [style*="stroke: #c1121f"] { stroke: #ff6b6b !important }
}</style>
"""


def write_picture(path):
    text = io.StringIO()
    picture().savefig(text, format="svg", metadata={"Date": None})
    pathlib.Path(path).write_text(text.getvalue().replace("<defs>", DARK + "<defs>", 1), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    for (i, shape), (j, other) in itertools.combinations(enumerate(PILE), 2):
        for manifold in plane.contacts(*shape, *other, margin=0.02):
            print(f"{i} touches {j}: normal {np.round(manifold.normal, 3)}, " +
                  ", ".join(f"{p.distance:+.3f} at {np.round(p.position, 2)}" for p in manifold.points))
    write_picture(sys.argv[1] if len(sys.argv) > 1 else "contacts.svg")
