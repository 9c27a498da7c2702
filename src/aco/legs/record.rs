//! The end of an iteration of all legs: what was spent, what stands.

use super::Legs;
use crate::aco::colony::Colony;
use crate::aco::variant::Variant;
use crate::exact::order;
use crate::planner::{Planner, Record, Solution, Status};

impl<V: Variant + 'static> Legs<V> {
    pub(super) fn end_iteration(&mut self, number: u32) {
        let effort = &mut self.progress.effort;
        effort.iterations = number;
        effort.constructed_paths = self.legs.iter().map(|l| l.effort().constructed_paths).sum();
        effort.ant_moves = self.legs.iter().map(|l| l.effort().ant_moves).sum();
        effort.cell_expansions = self.ordering + self.legs.iter().map(|l| l.effort().cell_expansions).sum::<u64>();
        if self.legs.iter().any(|l| l.best().is_some_and(|b| b.iteration == number)) {
            self.take_best(number);
        }
        let record = self.sum(number);
        self.progress.record(record);
        let settings = self.variant.settings();
        self.progress.status = self.progress.after_iteration(settings.iterations, settings.stagnation);
        if self.level.solving.is_some() && self.legs.iter().all(|leg| leg.status().is_finished()) {
            self.progress.status = if self.is_proven() { Status::Optimal } else { Status::BudgetSpent };
        }
    }

    /// Joins the legs' best paths, once every leg has one. Legs stay paths of steps, whether or not the variant refines.
    fn take_best(&mut self, number: u32) {
        let Some(best) = self.legs.iter().map(Colony::best).collect::<Option<Vec<_>>>() else { return };
        let path = order::join(best.iter().map(|b| &b.path));
        let length = self.scenario.path_length(&path);
        if let Some(tour) = &mut self.progress.tour {
            order::walk(&self.scenario, tour, best.iter().map(|b| b.length).collect());
        }
        self.progress.best = Some(Solution { path, length, iteration: number, refined: None });
    }

    /// The sum of the legs' records; a leg from a cell to itself needs no ants and counts as 0.
    fn sum(&self, number: u32) -> Record {
        let ants = self.colony_size();
        let still = Record {
            iteration: number,
            best_so_far: Some(0.0),
            iteration_best: Some(0.0),
            iteration_mean: Some(0.0),
            iteration_worst: Some(0.0),
            arrived: ants,
        };
        let records: Vec<Record> = self.legs.iter().map(|l| l.history().last().copied().unwrap_or(still)).collect();
        let sum = |value: fn(&Record) -> Option<f64>| records.iter().map(value).sum::<Option<f64>>();
        Record {
            iteration: number,
            best_so_far: self.progress.best.as_ref().map(|b| b.length),
            iteration_best: sum(|r| r.iteration_best),
            iteration_mean: sum(|r| r.iteration_mean),
            iteration_worst: sum(|r| r.iteration_worst),
            arrived: records.iter().map(|r| r.arrived).min().unwrap_or(0),
        }
    }
}
