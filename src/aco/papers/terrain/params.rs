//! Parameters of the terrain paper's two planners; Table 1 gives eight of them.

use super::field::Gains;
use super::sight::Heuristic;
use super::space::Directions;
use crate::aco::shared_params::{SelectionParams, WalkParams};
use crate::map::Way;
use crate::planner::Reading;
use crate::{param_choice, params};

param_choice! {
    /// τ of every place before the first iteration.
    pub enum Initial {
        /// τ0·F'_tot, at least 1 % of τ0: eq. 14
        Field = "field",
        /// τ0 everywhere
        Uniform = "uniform",
    }
}

param_choice! {
    /// What an ant does to the trail of the place that it steps on.
    pub enum LocalRule {
        /// τ ← (1 − λ)·τ: it takes a part away, as eq. 3 does without Δτ, which needs the whole path
        Evaporate = "evaporate",
        /// τ ← (1 − λ)·τ + λ·τ0: "increase and evaporation" at each step, as in Ant Colony System, whose name the paper gives its basic ACO
        Acs = "acs",
    }
}

params! {
    /// Parameters of the paper's basic ACO, which are its Table 1 as far as it has them.
    pub struct BasicParams {
        /// ants that build a path in each iteration, of both colonies together
        ants: u32 = 50, "m", [1..=1024], "ants", "table 1; that it counts both colonies is our reading";
        ..selection: SelectionParams {
            iterations = 100, "table 1";
            alpha = 1.0, "table 1";
            beta = 7.0, "table 1";
        };
        /// probability of taking the best step instead of drawing one
        q0: f64 = 0.8, "q0", [0.0..=1.0], "", "table 1, the selection threshold";
        /// what an ant sees of a step
        heuristic: Heuristic = Heuristic::Goal, "η", [], "", "the paper's words; step: its eq. 2";
        /// by slices: as how many cells one level counts in the distances of η
        level_height: f64 = 1.0, "", [0.0..=10.0], "cells", "our choice: not given; the textbook's program 0.2";
        /// which of the scenario's steps ants take
        directions: Directions = Directions::All, "", [], "", "section 4.4: 16 directions in place of 8";
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.2, "λ", [0.0..=1.0], "", "table 1, global";
        /// local evaporation rate: the part of a place's trail that an ant takes away by stepping there
        local_rho: f64 = 0.1, "λ_local", [0.0..=1.0], "", "table 1, local";
        /// what an ant does to the trail of a place by stepping there
        local_rule: LocalRule = LocalRule::Evaporate, "", [], "", "ours: eq. 3 and the words before it; acs: Dorigo and Gambardella 1997";
        /// an arrived ant leaves Q / length on each place of its path; by slices Q / cost
        deposit: f64 = 1.0, "Q", [1e-6..=1e6], "cells", "eq. 4: 1 / length";
        /// trail of every place before the first iteration; where a field makes it, in these parts
        initial_trail: f64 = 1.0, "τ0", [1e-6..=1e6], "", "our choice: not given; of the order of an iteration's deposits, m/L";
        ..walk: WalkParams;
    }
}

params! {
    /// Parameters of the elitist potential-field ACO.
    pub struct EpfParams {
        /// how the paper's formulas are read where they do not do what its text says
        reading: Reading = Reading::Repaired, "", [], "", "ours: see the paper card";
        /// trails before the first iteration
        initial: Initial = Initial::Field, "", [], "", "eq. 14";
        /// whether ants feel the force of the potential field
        force: bool = true, "", [], "", "section 4.5, the second eq. 12";
        /// base of the power by which the force weighs
        force_base: f64 = std::f64::consts::E, "a", [0.1..=10.0], "", "our choice: not given; the force then weighs about as much as the distance", when(force: true);
        /// whether the force weighs less and less over the iterations; else it has its full weight all the time
        force_fades: bool = true, "", [], "", "section 4.5, the second eq. 12", when(force: true);
        /// share of each colony's ants that deposit once more, the shortest first; at least one ant, none with 0
        elite: f64 = 0.05, "", [0.0..=1.0], "", "section 4.1";
        /// half of the ants are a colony of their own that sets out from the goal; two ants that meet join their ways
        two_colonies: bool = true, "", [], "", "section 4.2";
        /// pull of the goal at the start
        attraction: f64 = 1.0, "k", [0.0..=100.0], "", "our choice: not given";
        /// push of the heights above the start
        repulsion: f64 = 1.0, "θ", [0.0..=100.0], "", "our choice: not given; near the ground of the highest place half of the pull";
        /// by slices: as how many cells one level counts in the field, in its distances and directions
        field_level_height: f64 = 1.0, "", [0.0..=10.0], "cells", "our choice: not given; the textbook's program 0.2";
        /// distance to the ground within which heights push
        repulsion_range: f64 = 2.0, "ρ0", [1.0..=100.0], "cells or levels", "table 1";
        ..common: BasicParams;
    }
}

impl EpfParams {
    /// The basic ACO: none of the paper's four additions.
    pub fn basic(common: BasicParams) -> Self {
        Self { initial: Initial::Uniform, force: false, elite: 0.0, two_colonies: false, common, ..Self::default() }
    }

    /// The numbers of the field.
    pub fn gains(&self) -> Gains {
        let (attraction, repulsion, range) = (self.attraction, self.repulsion, self.repulsion_range);
        Gains { reading: self.reading, attraction, repulsion, range }
    }

    /// How many of the ants set out from the goal: half of them, the smaller half of an odd number.
    pub fn backward_ants(&self) -> u32 {
        if self.two_colonies { self.common.ants / 2 } else { 0 }
    }

    /// The ways on which ants walk, the forward one first.
    pub fn ways(&self) -> impl Iterator<Item = Way> + use<> {
        let back = (self.backward_ants() > 0).then_some(Way::Backward);
        std::iter::once(Way::Forward).chain(back)
    }
}
