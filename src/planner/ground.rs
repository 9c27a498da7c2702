//! The ways of moving that planners know, or do not.

use serde::Serialize;

use crate::listed::listed;
use crate::scenario::Scenario;

listed! {
    /// A way of moving, as far as planners differ in what they know.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
    #[serde(rename_all = "kebab-case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Ground {
        /// 4 or 8 moves on a plane.
        Plane,
        /// 4 or 8 moves on the surface of a terrain.
        Surface,
        /// 16 moves, on a plane or on a surface.
        Sixteen,
        /// By slices over a terrain.
        Slices,
        /// On weighted ground: beside one of the others, where cells have factors.
        Weighted,
    }
}

/// Where a ground begins: what a scenario must be like; what is absent may be anything.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct GroundRule {
    /// The ground where the rule holds.
    pub ground: Ground,
    /// Whether one moves by slices.
    pub slices: Option<bool>,
    /// How many moves a cell offers: 4, 8 or 16.
    pub moves: Option<u8>,
    /// Whether the map is a terrain: whether its cells have heights.
    pub terrain: Option<bool>,
}

impl GroundRule {
    /// Whether it holds for a scenario that is like this.
    pub fn holds(&self, slices: bool, moves: u8, terrain: bool) -> bool {
        self.slices.is_none_or(|s| s == slices)
            && self.moves.is_none_or(|m| m == moves)
            && self.terrain.is_none_or(|t| t == terrain)
    }
}

impl Ground {
    /// Of planners that only know the plane.
    pub const PLANE: &'static [Self] = &[Self::Plane];
    /// Of planners that only know the plane, and factors of its cells.
    pub const WEIGHTED_PLANE: &'static [Self] = &[Self::Plane, Self::Weighted];
    /// Of planners that know lengths alone, on any ground but slices.
    pub const LENGTHS: &'static [Self] = &[Self::Plane, Self::Surface, Self::Sixteen];
    /// Of planners that go from cell to neighbouring cell.
    pub const NEIGHBOURS: &'static [Self] = &[Self::Plane, Self::Surface, Self::Weighted];
    /// Of planners that go from cell to cell by any allowed step.
    pub const STEPS: &'static [Self] = &[Self::Plane, Self::Surface, Self::Sixteen, Self::Weighted];
    /// Of planners that know every way of moving but weighted ground.
    pub const UNWEIGHTED: &'static [Self] = &[Self::Plane, Self::Surface, Self::Sixteen, Self::Slices];

    /// The ground of every scenario: the first rule that holds. The last one always does. [`Ground::Weighted`] comes on top.
    pub const RULES: &'static [GroundRule] = &[
        GroundRule { ground: Self::Slices, slices: Some(true), moves: None, terrain: None },
        GroundRule { ground: Self::Sixteen, slices: None, moves: Some(16), terrain: None },
        GroundRule { ground: Self::Surface, slices: None, moves: None, terrain: Some(true) },
        GroundRule { ground: Self::Plane, slices: None, moves: None, terrain: None },
    ];

    /// How one moves in a scenario, by [`Ground::RULES`].
    pub fn of(scenario: &Scenario) -> Self {
        let (slices, moves) = (scenario.by_slices().is_some(), u8::from(scenario.spec.movement.moves));
        let terrain = scenario.moves.relief().is_some();
        Self::RULES.iter().find(|rule| rule.holds(slices, moves, terrain)).map_or(Self::Plane, |rule| rule.ground)
    }

    /// All that a planner must know of how one moves in a scenario.
    pub fn all_of(scenario: &Scenario) -> impl Iterator<Item = Self> + use<> {
        let weighted = scenario.moves.weights().map(|_| Self::Weighted);
        std::iter::once(Self::of(scenario)).chain(weighted)
    }

    /// Its stable name, and as a phrase after "plans".
    pub const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Plane => ("plane", "on a plane"),
            Self::Surface => ("surface", "on the surface of a terrain"),
            Self::Sixteen => ("sixteen", "with 16 moves"),
            Self::Slices => ("slices", "by slices"),
            Self::Weighted => ("weighted", "on weighted ground"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scenario_has_a_ground_and_every_ground_a_scenario() {
        let mut found = Vec::new();
        for (slices, moves, terrain) in
            [(false, 4, false), (false, 8, true), (false, 16, false), (false, 16, true), (true, 8, true)]
        {
            let rule = Ground::RULES.iter().find(|rule| rule.holds(slices, moves, terrain)).expect("a rule holds");
            found.push(rule.ground);
        }
        assert_eq!(found, [Ground::Plane, Ground::Surface, Ground::Sixteen, Ground::Sixteen, Ground::Slices]);
        assert!(Ground::ALL.iter().all(|ground| found.contains(ground) || *ground == Ground::Weighted));
    }
}
