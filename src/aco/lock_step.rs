//! Ants that change trails while they walk, four side by side: with the very same numbers as one after the other.
//!
//! All of them move in turn, and what one leaves on a step the next one sees. But it sees it only from the same cell: ants of a group that
//! stand on different cells read, weigh and choose together in SIMD lanes, and then step and change their trails one by one. Where two
//! share a cell, the second one begins another such round. Weights are not kept: nearly every row has changed when it is read again.

use wide::f32x4;

use super::ant::{Ant, Walk};
use super::draws::Draws;
use super::lane_rules::{Rule, Sums};
use super::selection::left;
use super::trails::{Row, Trails};
use super::variant::{Step, Variant};
use super::visibility::Sight;
use super::weights::WeightTable;
use crate::map::{Cell, DIRECTIONS, Direction};
use crate::planner::Fate;

/// Ants in a group.
const LANES: usize = 4;

/// What ants walk on.
pub(super) struct Field<'a> {
    pub table: &'a mut WeightTable,
    pub trails: &'a mut Trails,
    pub sight: Sight<'a>,
}

/// Lets all walking ants walk to their end, one move each in index order.
#[inline(never)]
pub(super) fn walk_all<V: Variant, R: Rule>(variant: &V, field: &mut Field, walk: &Walk, ants: &mut [Ant], rule: R) {
    let mut walking: Vec<usize> = (0..ants.len()).collect();
    let mut groups: Vec<Group> = Vec::with_capacity(ants.len().div_ceil(LANES));
    loop {
        walking.retain(|&k| ants[k].fate() == Fate::Walking);
        if walking.is_empty() {
            break;
        }
        groups.extend(walking.chunks(LANES).map(|members| Group::of(ants, members)));
        // From then on there is a group less.
        let enough = walking.len().min(LANES);
        let mut ended = 0;
        while ended < enough {
            ended += groups.iter_mut().map(|group| group.go(variant, field, walk, ants, rule)).sum::<usize>();
        }
        groups.drain(..).for_each(|group| group.leave(ants));
    }
}

/// Up to four ants that follow each other.
struct Group {
    /// Their numbers; a lane without an ant that walks has none.
    members: [Option<usize>; LANES],
    draws: Draws,
}

impl Group {
    /// Of one ant at least.
    fn of(ants: &[Ant], members: &[usize]) -> Self {
        let stream = |k: usize| &ants[*members.get(k).unwrap_or(&members[0])].stream;
        let draws = Draws::of([0, 1, 2, 3].map(stream));
        Self { members: [0, 1, 2, 3].map(|k| members.get(k).copied()), draws }
    }

    /// One move of each; how many of them have ended.
    #[inline(always)]
    fn go<V: Variant, R: Rule>(&mut self, variant: &V, field: &mut Field, walk: &Walk, ants: &mut [Ant], rule: R) -> usize {
        let mut cells = [Cell::MAX; LANES];
        for (cell, member) in cells.iter_mut().zip(self.members) {
            *cell = member.map_or(Cell::MAX, |k| ants[k].cell);
        }
        let (mut from, mut ended) = (0, 0);
        while from < LANES {
            let to = until_shared(&cells, from);
            ended += self.go_together(variant, field, walk, ants, rule, (from, to));
            from = to;
        }
        ended
    }

    /// One move of the lanes of a range, all on different cells.
    #[inline(always)]
    fn go_together<V: Variant, R: Rule>(
        &mut self,
        variant: &V,
        field: &mut Field,
        walk: &Walk,
        ants: &mut [Ant],
        rule: R,
        (from, to): (usize, usize),
    ) -> usize {
        let weights = self.weights(field, ants, (from, to));
        let sums = Sums::of(&weights);
        let steps = rule.choose(&weights, &sums, &mut self.draws).to_array();
        let alive = sums.alive.to_array();
        let mut ended = 0;
        for k in from..to {
            let Some(number) = self.members[k] else { continue };
            let ant = &mut ants[number];
            let (left, step) = (ant.cell, (alive[k] != 0).then_some(steps[k] as Direction & 7));
            ant.go(walk, step);
            if let Some(direction) = step {
                variant.on_move(field.trails, Step { from: left, direction, walked: ant.walked() });
            }
            if ant.fate != Fate::Walking {
                ant.stream = self.draws.stream(k);
                self.members[k] = None;
                ended += 1;
            }
        }
        ended
    }

    /// The weights of the steps that are left, by direction, for the lanes of a range; 0 for the others.
    #[inline(always)]
    fn weights(&self, field: &mut Field, ants: &[Ant], (from, to): (usize, usize)) -> [f32x4; DIRECTIONS] {
        let (mut low, mut high) = ([f32x4::ZERO; LANES], [f32x4::ZERO; LANES]);
        for k in from..to {
            if let Some(number) = self.members[k] {
                let ant = &ants[number];
                let row: Row = field.table.weigh_now(&field.sight, field.trails, ant.cell);
                [low[k], high[k]] = left(&row, ant.seen());
            }
        }
        let ([a, b, c, d], [e, f, g, h]) = (f32x4::transpose(low), f32x4::transpose(high));
        [a, b, c, d, e, f, g, h]
    }

    /// Gives the ants that walk on their streams.
    fn leave(self, ants: &mut [Ant]) {
        for (member, stream) in self.members.into_iter().zip(self.draws.streams()) {
            if let Some(number) = member {
                ants[number].stream = stream;
            }
        }
    }
}

/// The first lane after this one that shares a cell with one from there on; all of them where none does. Lanes without an ant share none.
#[inline(always)]
fn until_shared(cells: &[Cell; LANES], from: usize) -> usize {
    let shared = |k: usize| cells[k] != Cell::MAX && cells[from..k].contains(&cells[k]);
    (from + 1..LANES).find(|&k| shared(k)).unwrap_or(LANES)
}
