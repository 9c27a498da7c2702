//! Paths of any points: a flaw is named, whatever they are.

use std::sync::Arc;

use formicarium::map::Point;
use formicarium::path::{PathKind, audit, audit_slices, direction_between, line_of_sight};
use formicarium::scenario::Scenario;

use crate::limits::Limits;
use crate::random::Random;
use crate::watch::{Fault, watch};

pub struct Case {
    scenario: Arc<Scenario>,
    path: Vec<(Point, u32)>,
}

pub fn case(random: &mut Random) -> Result<Option<Case>, Fault> {
    let Some(scenario) = crate::planners::scenario(random)? else { return Ok(None) };
    let far = [0, 1, scenario.grid.width(), scenario.grid.height(), 4096, 1 << 31, u32::MAX];
    let mut path = Vec::new();
    let mut at = scenario.spec.start;
    for _ in 0..random.below(12) {
        path.push((at, random.between(0, 12)));
        let near = |random: &mut Random, from: u32| (from + random.between(0, 2)).saturating_sub(1);
        at = Point::new(near(random, at.x.min(4095)), near(random, at.y.min(4095)));
        if random.one_in(12) {
            at = Point::new(*random.of_list(&far), *random.of_list(&far));
        }
        if random.one_in(12) {
            at = scenario.spec.goals[0].at;
        }
    }
    Ok(Some(Case { scenario, path }))
}

impl Case {
    pub fn check(&self) -> Result<(), Fault> {
        watch("path", || Limits::text(0), || self.audit())
    }

    pub fn words(&self) -> String {
        let map = formicarium::formats::export(&self.scenario.grid, &self.scenario.spec, formicarium::formats::Export::Scenario);
        format!("path: {:?}\n\nmap.json:\n{map}", self.path)
    }

    fn audit(&self) -> Result<(), Fault> {
        let points: Vec<Point> = self.path.iter().map(|(at, _)| *at).collect();
        for kind in [PathKind::Steps, PathKind::Polyline] {
            let found = audit(&self.scenario, &points, kind);
            if found.is_ok() && points.first() != Some(&self.scenario.spec.start) {
                return Err(Fault::broken("a path begins at the start", format!("{points:?}")));
            }
        }
        let _ = audit_slices(&self.scenario, &self.path);
        for pair in points.windows(2) {
            direction_between(pair[0], pair[1]);
            if pair.iter().all(|at| self.scenario.grid.contains(*at)) {
                line_of_sight(&self.scenario, pair[0], pair[1]);
            }
        }
        Ok(())
    }
}
