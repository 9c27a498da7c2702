"""A small random search for two parameters on training maps, then a comparison with the defaults on maps that the search has not seen."""

import random

import formicarium

dice = random.Random(1)
training = [formicarium.generate("blocks", 30, 30, seed=seed) for seed in range(1, 7)]
unseen = [formicarium.generate("blocks", 30, 30, seed=seed) for seed in range(101, 107)]
budget = ("constructed-paths", 600)


def question(maps: list[formicarium.Map], sets: dict[str, dict[str, float]], seeds: int) -> dict[str, object]:
    """One entry for each set of values, on all maps."""
    return {
        "title": "Ant System on blocks",
        "seeds": seeds,
        "instances": [{"id": f"map-{number}", "map": each} for number, each in enumerate(maps)],
        "entries": [{"id": name, "planner": "ant-system", "set": values} for name, values in sets.items()],
    }


candidates = {f"try-{number}": {"ants": dice.randint(4, 60), "rho": round(dice.uniform(0.05, 0.9), 2)} for number in range(20)}
tried = formicarium.compare(question(training, candidates, seeds=10), budget=budget)
gaps: dict[str, list[float]] = {name: [] for name in candidates}
for row in tried.records():
    gaps[row["entry"]].append(float("inf") if row["gap"] is None else row["gap"])
best = min(gaps, key=lambda name: sum(gaps[name]))
print(f"best of {len(candidates)}: {candidates[best]}")

compared = formicarium.compare(question(unseen, {"default": {}, "tuned": candidates[best]}, seeds=20), budget=budget)
for name in ("default", "tuned"):
    found = [row["gap"] for row in compared.records() if row["entry"] == name and row["gap"] is not None]
    print(f"{name}: {len(found)} of 120 runs found a path, on average {100 * sum(found) / len(found):.2f} % above the optimum")
