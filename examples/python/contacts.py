"""Contacts, drawn: a pile in the plane, and one box on another in space.

A notebook in a file: each `# %%` begins a cell for an editor that knows them, and the whole runs as a program:

    python3 examples/python/contacts.py [picture.svg]
"""

# %% What is drawn with
import sys

import matplotlib

matplotlib.use("svg" if __name__ == "__main__" else matplotlib.get_backend())
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import graze
from graze import plane

matplotlib.rcParams.update({"svg.hashsalt": "graze", "font.size": 9})
INK, BODY, CONTACT, NORMAL = "#333333", "#c9d8e6", "#c23b22", "#1f6fb2"

# %% A pile in the plane: shapes, and where each stands (x, y, angle)
PILE = [
    (plane.HalfPlane(), (0, 0, 0)),
    (plane.Box((3, 1)), (-1, 0.49, 0)),
    (plane.Box((1.2, 1.1)), (1.9, 0.545, 0)),
    (plane.Circle(0.6), (-1.6, 1.57, 0)),
    (plane.ConvexPolygon([(-0.9, -0.4), (0.9, -0.4), (0.5, 0.5), (-0.5, 0.5)]), (1.15, 1.49, -0.06)),
    (plane.Capsule(1.4, 0.3), (-0.43, 2.03, 1.25)),
]


def touching(pile, margin):
    """Every manifold between two of a pile, with the places of both."""
    return [
        (i, j, manifold)
        for i, (a, pose_a) in enumerate(pile)
        for j, (b, pose_b) in enumerate(pile[i + 1 :], i + 1)
        for manifold in plane.contacts(a, pose_a, b, pose_b, margin=margin)
    ]


def outline(shape, pose, count=180):
    """The outline of a bounded shape: where rays from outside, towards its middle, meet it."""
    lower, upper = shape.bounds(pose)
    middle, reach = (lower + upper) / 2, np.linalg.norm(upper - lower)
    turns = np.linspace(0, 2 * np.pi, count, endpoint=False)
    around = np.column_stack([np.cos(turns), np.sin(turns)])
    return np.array([plane.raycast(shape, pose, middle + reach * d, -d).point for d in around])


def draw_pile(axes, pile, margin):
    axes.axhspan(-0.5, 0, color=BODY, ec=INK)
    for shape, pose in pile[1:]:
        if hasattr(shape, "vertices") or hasattr(shape, "size"):
            half = np.array(shape.size) / 2 if hasattr(shape, "size") else None
            corners = shape.vertices if half is None else half * [(-1, -1), (1, -1), (1, 1), (-1, 1)]
            x, y, angle = pose
            turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
            points = corners @ turn.T + (x, y)
        else:
            points = outline(shape, pose)
        axes.fill(*points.T, fc=BODY, ec=INK, lw=1)
    for _, _, manifold in touching(pile, margin):
        for point in manifold.points:
            axes.plot(*point.position, "o", color=CONTACT, ms=5, zorder=3)
            axes.annotate("", point.position + 0.45 * manifold.normal, point.position, zorder=3,
                          arrowprops={"arrowstyle": "-|>", "color": NORMAL, "shrinkA": 0, "shrinkB": 0})
    axes.set(aspect="equal", xlim=(-3, 3.2), ylim=(-0.5, 3), title="plane.contacts: points, and normals from a to b")


# %% One box on another, turned by 35 degrees, a hundredth deep: the corners of the area that they share
LOWER, UPPER = graze.Box((2, 1, 2)), graze.Box((1.6, 1, 1.6))
ANGLE = np.radians(35)
ON_TOP = graze.Pose((0.5, 0.99, 0.2), (0, np.sin(ANGLE / 2), 0, np.cos(ANGLE / 2)))


def faces_of(box, pose):
    """The six faces of a box as four corners each, in the world."""
    half, faces = box.size / 2, []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (-1, 1):
            corners = np.zeros((4, 3))
            corners[:, axis] = side * half[axis]
            corners[:, u], corners[:, v] = half[u] * np.array([-1, 1, 1, -1]), half[v] * np.array([-1, -1, 1, 1])
            faces.append([pose @ corner for corner in corners])
    return np.array(faces)


def upright(points):
    """Y is up in Graze's scenes, z in matplotlib's."""
    return np.asarray(points)[..., [2, 0, 1]]


def draw_boxes(axes):
    [manifold] = graze.contacts(LOWER, None, UPPER, ON_TOP)
    points = np.array([p.position for p in manifold.points])
    for box, pose in ((LOWER, graze.Pose()), (UPPER, ON_TOP)):
        axes.add_collection3d(Poly3DCollection(upright(faces_of(box, pose)), fc=BODY, ec=INK, lw=0.8, alpha=0.25))
    axes.add_collection3d(Poly3DCollection([upright(points)], fc=CONTACT, ec=CONTACT, alpha=0.35))
    axes.scatter(*upright(points).T, color=CONTACT, s=22, depthshade=False)
    axes.quiver(*upright(points).T, *(0.5 * upright(manifold.normal)), color=NORMAL, lw=1.2)
    axes.set(xlim=(-1, 1.3), ylim=(-1, 1.6), zlim=(-0.5, 1.6),
             title=f"graze.contacts: {len(manifold)} points span the area")
    axes.set_box_aspect((2.3, 2.6, 2.1), zoom=1.05)
    axes.set_axis_off()
    axes.view_init(32, -50)


# %% Both, side by side
def picture():
    figure = plt.figure(figsize=(10, 4.2))
    draw_pile(figure.add_subplot(1, 2, 1), PILE, margin=0.02)
    draw_boxes(figure.add_subplot(1, 2, 2, projection="3d"))
    figure.tight_layout()
    return figure


if __name__ == "__main__":
    for i, j, manifold in touching(PILE, 0.02):
        print(f"{i} touches {j}: normal {np.round(manifold.normal, 3)}, " +
              ", ".join(f"{p.distance:+.3f} at {np.round(p.position, 2)}" for p in manifold.points))
    picture().savefig(sys.argv[1] if len(sys.argv) > 1 else "contacts.svg", metadata={"Date": None})
