"""A path for a robot: a map as ROS's map_server saves it, a path in it, poses in metres.

python ros_map_to_path.py [lab.yaml X Y X Y]      # start and goal in metres
"""

import sys
import tempfile
import warnings
from pathlib import Path

import numpy as np

import formicarium


def made_up(folder: str) -> Path:
    """A laboratory of two rooms with a door, 5 cm a cell, as a robot would have saved it."""
    walls = np.zeros((80, 120), dtype=bool)
    walls[[0, -1], :] = walls[:, [0, -1]] = True
    walls[:, 60] = True
    walls[62:72, 60] = False
    lab = formicarium.Map(walls, start=(10, 70), goals=(110, 10), resolution=0.05, world={"x": -3.0, "y": -2.0})
    lab.write(Path(folder) / "lab.yaml")
    return Path(folder) / "lab.yaml"


# A ROS map names neither start nor goal; below they are given in metres.
warnings.simplefilter("ignore", formicarium.FormicariumWarning)
with tempfile.TemporaryDirectory() as folder:
    lab = formicarium.read_map(sys.argv[1] if len(sys.argv) > 1 else made_up(folder), unknown="blocked")

metres = [float(text) for text in sys.argv[2:]] or [-2.5, -1.5, 2.5, 1.5]
start, goal = lab.to_cell(*metres[:2]), lab.to_cell(*metres[2:])
if start is None or goal is None or lab.blocked[start[1], start[0]] or lab.blocked[goal[1], goal[0]]:
    sys.exit("start or goal lies beside the map or on a wall: give both in metres")
plan = formicarium.plan(lab.replace(start=start, goals=goal), "any-angle")
assert plan.path_world is not None, "no path"
print(f"{plan.length_metres:.2f} m with {plan.turns} turns, {plan.status}")
for x, y in plan.path_world:
    print(f"{x:8.3f} m {y:8.3f} m")
