//! The runs of a comparison, and the orders they have.

use super::{Comparison, Task};

impl Comparison {
    /// Every run that is to be done, in the order of the rows: by instance, entry, seed. Entries that cannot be run have none.
    pub fn tasks(&self) -> Vec<Task> {
        let (seeds, entries) = (self.question.seeds, self.question.runnable());
        let of = |instance, entry| seeds.iter().map(move |seed| Task { instance, entry, seed });
        (0..self.maps.len()).flat_map(|i| entries.iter().flat_map(move |&e| of(i, e))).collect()
    }

    /// How many there are.
    pub fn task_count(&self) -> usize {
        self.maps.len() * self.question.runnable().len() * self.question.seeds.count as usize
    }

    /// Whether a run is one of [`Comparison::tasks`].
    pub fn has_task(&self, Task { instance, entry, seed }: Task) -> bool {
        let seeds = self.question.seeds;
        let is_seed = seed >= seeds.from && seed - seeds.from < seeds.count;
        instance < self.maps.len() && is_seed && self.question.runnable().contains(&entry)
    }

    /// The places of [`Comparison::tasks`] in the order in which runs are handed out where somebody watches: seed by seed, so that every entry
    /// is seen early on every map, and none is all alone at the end. Of each entry and map only the first `seeds` seeds, or all there are.
    pub fn seed_by_seed(&self, seeds: u32) -> Vec<usize> {
        let count = self.question.seeds.count as usize;
        let pairs = self.maps.len() * self.question.runnable().len();
        let of_seed = |seed| (0..pairs).map(move |pair| pair * count + seed);
        (0..count.min(seeds as usize)).flat_map(of_seed).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::question::{FORMAT, Question};
    use super::*;
    use crate::map::{Grid, Point};
    use crate::scenario::{Scenario, ScenarioSpec};
    use serde_json::json;

    /// Two maps; two entries that run, with one between them that does not.
    fn comparison() -> Comparison {
        let question: Question = serde_json::from_value(json!({
            "format": FORMAT, "title": "t", "asks": "?", "seeds": { "from": 7, "count": 3 },
            "instances": [{ "id": "a", "map": "a.json" }, { "id": "b", "map": "b.json" }],
            "entries": [
                { "id": "ants", "label": "ants", "role": "other", "planner": "ant-system" },
                { "id": "lost", "label": "lost", "role": "other", "missing": "nowhere" },
                { "id": "exact", "label": "exact", "role": "other", "planner": "astar" }
            ]
        }))
        .unwrap();
        let map = || {
            let grid = Grid::open(3, 2).unwrap();
            let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(2, 1));
            Arc::new(Scenario::new(grid, spec).unwrap())
        };
        Comparison::new(question, vec![map(), map()]).unwrap()
    }

    #[test]
    fn every_pair_has_its_turn_before_the_next_seed() {
        let comparison = comparison();
        let tasks = comparison.tasks();
        let handed: Vec<_> = comparison.seed_by_seed(2).into_iter().map(|place| tasks[place]).collect();
        let task = |(instance, entry, seed)| Task { instance, entry, seed };
        let first = [(0, 0, 7), (0, 2, 7), (1, 0, 7), (1, 2, 7), (0, 0, 8), (0, 2, 8), (1, 0, 8), (1, 2, 8)].map(task);
        assert_eq!(handed, first);
        let mut all = comparison.seed_by_seed(u32::MAX);
        all.sort_unstable();
        assert_eq!(all, (0..tasks.len()).collect::<Vec<_>>());
        assert_eq!(comparison.task_count(), tasks.len());
        assert!(tasks.is_sorted() && tasks.iter().all(|&task| comparison.has_task(task)));
        for wrong in [(2, 0, 7), (0, 1, 7), (0, 3, 7), (0, 0, 6), (0, 0, 10)] {
            assert!(!comparison.has_task(task(wrong)), "{wrong:?}");
        }
    }
}
