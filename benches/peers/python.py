"""Ant colonies of PyPI, as a runner of `cargo xtask bench` (benches/runner has the protocol).

A move is a choice of a next cell; time runs from the first one to the end of the last iteration.
"""

import json
import random
import sys
import time

import matplotlib

matplotlib.use("Agg")


def read(file):
    """Width, height, the free cells, start and goal."""
    with open(file, encoding="utf-8") as source:
        scenario = json.load(source)
    rows = scenario["map"]["rows"]
    free = {(x, y) for y, row in enumerate(rows) for x, sign in enumerate(row) if sign != "@"}
    return len(rows[0]), len(rows), free, tuple(scenario["start"]), tuple(scenario["goals"][0]["at"])


def python_motion_planning(job):
    """The package's ACO with its defaults, walls around the map as its grids have them."""
    from python_motion_planning.global_planner.evolutionary_search import aco
    from python_motion_planning.utils import Grid

    width, height, free, start, goal = read(job["map"])
    shift = lambda cell: (cell[0] + 1, cell[1] + 1)
    walls = {(x, y) for x in range(width + 2) for y in range(height + 2)} - {shift(cell) for cell in free}
    select = aco.bisect_left

    def round_(seed):
        random.seed(seed)
        grid = Grid(width + 2, height + 2)
        grid.update(walls)
        begin, moves = None, 0

        def counted(*arguments):
            nonlocal begin, moves
            begin, moves = begin or time.perf_counter(), moves + 1
            return select(*arguments)

        aco.bisect_left = counted
        aco.ACO(shift(start), shift(goal), grid, n_ants=50, max_iter=job["iterations"]).plan()
        return {"seconds": time.perf_counter() - begin, "moves": moves}

    return round_


def aco_routing(job):
    """The package's ACO on the graph of the map's steps, ants from the start, at most 8 × side steps each."""
    import networkx
    from aco_routing import ACO

    width, height, free, start, goal = read(job["map"])
    near = [(dx, dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1) if (dx, dy) != (0, 0)]
    graph = networkx.DiGraph()
    for x, y in free:
        for dx, dy in near:
            if {(x + dx, y + dy), (x + dx, y), (x, y + dy)} <= free:
                graph.add_edge((x, y), (x + dx, y + dy), cost=(dx * dx + dy * dy) ** 0.5)

    class Counting(ACO):
        """Counts steps before it forgets its ants."""

        moves = 0

        def _deploy_backward_search_ants(self):
            self.moves += sum(len(ant.path) - 1 for ant in self.search_ants)
            super()._deploy_backward_search_ants()

    def round_(seed):
        random.seed(seed)
        colony = Counting(graph.copy(), 4 * (width + height), job["iterations"], ant_random_spawn=False)
        begin = time.perf_counter()
        colony._deploy_search_ants(start, goal, 50)
        return {"seconds": time.perf_counter() - begin, "moves": colony.moves}

    return round_


COLONIES = {"python-motion-planning": python_motion_planning, "aco-routing": aco_routing}


def main():
    contestants = []
    for line in sys.stdin:
        request = json.loads(line)
        if "prepare" in request:
            contestants.append(COLONIES[request["prepare"]["who"]](request["prepare"]))
            answer = len(contestants) - 1
        else:
            answer = contestants[request["round"]](request["seed"])
        print(json.dumps(answer), flush=True)


main()
