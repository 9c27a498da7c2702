"""Box plots of a comparison by matplotlib.

python figure.py [figure.svg]
"""

import sys

import matplotlib

import formicarium

matplotlib.use("Agg")
from matplotlib import pyplot

planners = ["ant-system", "max-min-ant-system", "ant-colony-system"]
compared = formicarium.compare(
    {
        "title": "Colonies in a cave",
        "seeds": 20,
        "instances": [{"id": "cave", "map": formicarium.generate("cave", 40, 30, seed=3)}],
        "entries": [{"id": planner, "planner": planner, "set": {"iterations": 1000}} for planner in planners],
        # As many constructed paths for each: an iteration of one has more ants than that of another.
        "budget": {"axis": "constructed-paths", "amount": 1000},
    }
)
rows = compared.rows.to_pandas()
figure, axes = pyplot.subplots(figsize=(6, 3), layout="constrained")
gaps = [100 * rows[rows["entry"] == planner]["gap"].dropna() for planner in planners]
lost = [int(rows[rows["entry"] == planner]["gap"].isna().sum()) for planner in planners]
axes.boxplot(gaps)
axes.set_xticks(range(1, len(planners) + 1), [f"{planner}\n{missing} of 20 without a path" for planner, missing in zip(planners, lost)])
axes.set_ylabel("above the optimum, %")
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "figure.svg")
