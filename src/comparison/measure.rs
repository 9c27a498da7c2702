//! What is measured on runs.

use serde::{Deserialize, Serialize};

use super::question::Published;
use crate::planner::Objective;

/// What is measured on a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum RunMeasure {
    /// Length of the path in cells.
    Length,
    /// Cost of a path by slices, by the scenario's measure, and on weighted ground; elsewhere the value by the planner's own objective.
    Cost,
    /// Its turns.
    Turns,
    /// Its turn-weighted index V(d, r) in cells.
    TurnIndex,
    /// Radians that it turns in all.
    Turning,
    /// Its largest curvature per metre; infinite where it turns straight back.
    LargestCurvature,
    /// Its smoothness per square metre; 0 of a straight line.
    Smoothness,
    /// What driving along it costs by the map's vehicle.
    Energy,
    /// Seconds to the goal by the map's vehicle: metres / speed + turns · seconds per turn; by slices no run tells it.
    ArrivalTime,
    /// Σ R in cells of a tour by several goals: each leg as walked times the weight of its goal.
    Weight,
    /// Smallest distance in cells from a cell that the path crosses to the nearest obstacle.
    MinClearance,
    /// Mean of the same distance over the cells that the path crosses.
    MeanClearance,
    /// The iteration that found the best path.
    IterationOfBest,
    /// Constructed paths up to the end of that iteration.
    PathsToBest,
    /// Moves of all ants of the run.
    AntMoves,
    /// Whether a path was found: 1 or 0.
    Success,
    /// Whether the exact optimum was found: 1 or 0.
    Optimal,
    /// Expected running time to a target: of all runs of an entry together, so that a single run has none.
    RunningTime,
}

impl RunMeasure {
    /// The measure that an objective's value belongs to on a map, `weighted` or not: two objectives can share one, over different paths.
    pub fn of(objective: Objective, weighted: bool) -> Self {
        match objective {
            Objective::Length | Objective::PolylineLength | Objective::TourLength if weighted => Self::Cost,
            Objective::Length | Objective::PolylineLength | Objective::TourLength => Self::Length,
            Objective::SliceCost | Objective::Weighted => Self::Cost,
            Objective::TurnIndex => Self::TurnIndex,
            Objective::TourWeight => Self::Weight,
        }
    }

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Length => "length",
            Self::Cost => "cost",
            Self::Turns => "turns",
            Self::TurnIndex => "turn index V",
            Self::Turning => "turning angle",
            Self::LargestCurvature => "largest curvature",
            Self::Smoothness => "smoothness",
            Self::Energy => "energy",
            Self::ArrivalTime => "arrival time",
            Self::Weight => "weight R",
            Self::MinClearance => "smallest clearance",
            Self::MeanClearance => "mean clearance",
            Self::IterationOfBest => "iteration of best",
            Self::PathsToBest => "constructed paths to best",
            Self::AntMoves => "ant moves",
            Self::Success => "share of runs with a path",
            Self::Optimal => "share of runs with the optimum",
            Self::RunningTime => "expected running time",
        }
    }

    /// Whether it tells how a path is to drive: such measures are taken only where they are asked for.
    pub fn is_of_driving(self) -> bool {
        matches!(self, Self::Turning | Self::LargestCurvature | Self::Smoothness | Self::Energy)
    }

    /// Its id in files.
    pub fn id(self) -> &'static str {
        match self {
            Self::Length => "length",
            Self::Cost => "cost",
            Self::Turns => "turns",
            Self::TurnIndex => "turn-index",
            Self::Turning => "turning",
            Self::LargestCurvature => "largest-curvature",
            Self::Smoothness => "smoothness",
            Self::Energy => "energy",
            Self::ArrivalTime => "arrival-time",
            Self::Weight => "weight",
            Self::MinClearance => "min-clearance",
            Self::MeanClearance => "mean-clearance",
            Self::IterationOfBest => "iteration-of-best",
            Self::PathsToBest => "paths-to-best",
            Self::AntMoves => "ant-moves",
            Self::Success => "success",
            Self::Optimal => "optimal",
            Self::RunningTime => "running-time",
        }
    }

    /// Whether the larger value of two is the better one.
    pub fn more_is_better(self) -> bool {
        matches!(self, Self::MinClearance | Self::MeanClearance | Self::Success | Self::Optimal)
    }

    /// Whether it is 1 or 0 for a run, and so a share of all runs.
    pub fn is_share(self) -> bool {
        matches!(self, Self::Success | Self::Optimal)
    }

    /// The smallest effect that matters, where a claim says nothing else: a part of the baseline's value, of shares a difference. What a path
    /// comes to differs little between planners that are any good; efforts and turns differ much from run to run.
    pub fn relevant(self) -> f64 {
        match self {
            Self::Length | Self::Cost | Self::TurnIndex | Self::Energy | Self::ArrivalTime | Self::Weight => 0.01,
            Self::Turns
            | Self::Turning
            | Self::LargestCurvature
            | Self::Smoothness
            | Self::MinClearance
            | Self::MeanClearance => 0.1,
            Self::IterationOfBest | Self::PathsToBest | Self::AntMoves | Self::RunningTime => 0.1,
            Self::Success | Self::Optimal => 0.05,
        }
    }

    /// The published number of this measure.
    pub fn published(self, row: &Published) -> Option<f64> {
        match self {
            Self::Length => row.length,
            Self::Cost => row.cost,
            Self::Turns => row.turns,
            Self::TurnIndex => row.turn_index,
            Self::Weight => row.weight,
            Self::ArrivalTime => row.arrival_time,
            Self::IterationOfBest => row.iterations,
            Self::Turning | Self::LargestCurvature | Self::Smoothness | Self::Energy => None,
            Self::MinClearance
            | Self::MeanClearance
            | Self::PathsToBest
            | Self::AntMoves
            | Self::Success
            | Self::Optimal
            | Self::RunningTime => None,
        }
    }
}
