//! Which way of understanding a publication a planner follows.

use serde::{Deserialize, Serialize};

use super::{PlannerEntry, Preset};
use crate::param_choice;
use crate::params::Value;

/// A whole way to read a publication: one preset of its planner, or its planner's defaults ([`PlannerEntry::reading_of`]).
/// [`Reading`] is one of the parameters that such a preset sets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum PaperReading {
    /// Its formulas as they are printed.
    Printed,
    /// As we read it: formulas mean what the text around them says.
    AsRead,
    /// Where it leaves more than one reading open, another one.
    SecondReading,
}

impl PaperReading {
    /// All of them, in the order in which people meet them.
    pub const ALL: [Self; 3] = [Self::Printed, Self::AsRead, Self::SecondReading];

    /// Its id in questions and in the catalog.
    pub const fn id(self) -> &'static str {
        match self {
            Self::Printed => "printed",
            Self::AsRead => "as-read",
            Self::SecondReading => "second-reading",
        }
    }
}

impl PlannerEntry {
    /// Which reading of its publication a preset is; without one the defaults. These are [`PaperReading::AsRead`] where the planner has other
    /// readings, unless a preset is that one and sets something.
    pub fn reading_of(&self, preset: Option<&str>) -> Option<PaperReading> {
        if let Some(name) = preset {
            return self.presets.iter().find(|p| p.name == name)?.reading;
        }
        let as_read = self.presets.iter().find(|p| p.reading == Some(PaperReading::AsRead));
        let has_readings = self.presets.iter().any(|p| p.reading.is_some());
        (has_readings && as_read.is_none_or(|p| self.sets_nothing(p))).then_some(PaperReading::AsRead)
    }

    /// Whether a preset's values are the defaults.
    fn sets_nothing(&self, preset: &Preset) -> bool {
        let specs = (self.specs)();
        let is_default = |(key, value): (&String, &Value)| specs.iter().any(|spec| spec.key == key && spec.default == *value);
        preset.values().iter().all(is_default)
    }
}

param_choice! {
    /// How to take the places where a paper contradicts itself; every file lists its own.
    pub enum Reading {
        /// formulas mean what the paper's own text says
        Repaired = "repaired",
        /// formulas are taken literally
        Printed = "printed",
    }
}

param_choice! {
    /// What a formula that divides by the distance to the goal means for the step onto the goal, where that distance is 0.
    pub enum GoalStep {
        /// the goal is weighed as any other cell, by a small distance that stands for 0
        Weighed = "weighed",
        /// beside the goal, where the step is allowed, it is taken without a choice
        Enter = "enter",
    }
}

/// The distance in cells that stands for 0 at the goal: 1 / 0.01 = 100 there, as in the textbook MATLAB program.
pub const AT_GOAL: f64 = 0.01;
