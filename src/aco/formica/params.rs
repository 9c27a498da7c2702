//! The parameters of Formica.

use crate::aco::criterion::{Criterion, Judge};
use crate::aco::legs::OrderLevel;
use crate::aco::order_solve::Solving;
use crate::aco::shared_params::{SelectionParams, WalkParams};
use crate::aco::tour::TourSettings;
use crate::exact::tour::Smallest;
use crate::metrics::WeightedSum;
use crate::{param_choice, params};

param_choice! {
    /// What the colony's paths consist of.
    pub enum Paths {
        /// allowed steps from cell to cell
        Steps = "steps",
        /// segments of any angle between centres of cells that see each other; on a plane
        Polylines = "polylines",
    }
}

params! {
    /// Parameters of Formica.
    pub struct FormicaParams {
        /// what makes one path better than another, and is proven
        criterion: Criterion = Criterion::Length, "", [], "", "our addition";
        /// what paths consist of; ants walk by steps anyway
        paths: Paths = Paths::Steps, "", [], "", "our addition";
        /// ants that build a path in each iteration
        ants: u32 = 16, "m", [1..=1024], "ants", "measured: docs/papers/formica.md";
        ..selection: SelectionParams;
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.1, "ρ", [0.0..=1.0], "", "Blum and Dorigo 2004";
        /// whether ants smell how far the goal is around walls; otherwise they know its direction alone
        scent: bool = true, "", [], "", "our addition";
        /// how strongly ants avoid detours by scent: η = exp(−κ · detour)
        kappa: f64 = 0.4, "κ", [0.0..=20.0], "per cell", "our choice";
        /// whether a search puts the ways of each iteration's ants together
        merge: bool = true, "", [], "", "Blum et al. 2016";
        /// how far around the ants' cells the search looks
        widening: u32 = 4, "", [0..=64], "cells", "our choice";
        /// how far around the best path the search looks at least
        corridor: u32 = 16, "", [0..=128], "cells", "our choice";
        /// whether the corridor gets wider while nothing shorter is found
        adaptive_corridor: bool = true, "", [], "", "our addition";
        /// how far around the best path the search looks at most
        corridor_most: u32 = 64, "", [0..=128], "cells", "our choice";
        /// trails start again after so many iterations without a shorter path; 0 = never
        trail_restart: u32 = 2, "", [0..=100_000], "iterations", "our choice";
        /// ants stop after so many iterations without a shorter path, and the proof begins; 0 = only at the end of the budget
        proof_after: u32 = 3, "", [0..=100_000], "iterations", "our choice";
        /// most expansions of the proof; 0 = no proof
        proof_limit: f64 = 4.0, "", [0.0..=1000.0], "× cells", "our addition";
        /// what the order of several goals makes small
        order: Smallest = Smallest::Weight, "", [], "", "our choice, as the exact tour";
        /// iterations of the colony that chooses the order
        order_iterations: u32 = 20, "", [1..=10_000], "iterations", "our choice";
        /// 1-trees after which the search that merges the ants' orders and proves the best ends; 0 = no search
        order_limit: u32 = 20_000, "", [0..=1_000_000], "1-trees", "our choice";
        ..walk: WalkParams;
        ..sum: WeightedSum;
    }
}

impl FormicaParams {
    /// The criterion at work.
    pub fn judge(&self) -> Judge {
        self.criterion.by(self.sum)
    }
}

/// Numbers of the order colony: those of the order command, which are Ant System's for tours (Dorigo and Stützle 2004, box 3.1).
const TOURS: TourSettings =
    TourSettings { ants: 0, iterations: 0, alpha: 1.0, beta: 5.0, rho: 0.5, deposit: 1.0, initial_trail: 1.0, exploit: None };

impl FormicaParams {
    /// How the order of several goals is chosen.
    pub fn order_level(&self) -> OrderLevel {
        let solving = Solving { merge: self.merge, prove: self.proof_limit > 0.0, limit: self.order_limit.into() };
        OrderLevel {
            settings: TourSettings { ants: self.ants, iterations: self.order_iterations, ..TOURS },
            weighted: self.order == Smallest::Weight,
            straight: false,
            solving: Some(solving),
        }
    }
}
