//! The bound by 1-trees: Held, Karp, "The traveling-salesman problem and minimum spanning trees", Operations Research 18 (1970) 1138–1162,
//! doi:10.1287/opre.18.6.1138, and part II, Mathematical Programming 1 (1971) 6–25, doi:10.1007/BF01584070.
//!
//! Multipliers go up where a 1-tree has too many edges and down where it has too few, in steps of λ·(known − bound)/Σ(degree − 2)² (Held,
//! Wolfe, Crowder, "Validation of subgradient optimization", Mathematical Programming 6 (1974) 62–88, doi:10.1007/BF01580223), three tenths of the
//! direction being that of the step before (Volgenant, Jonker, "A branch and bound algorithm for the symmetric traveling salesman problem based on
//! the 1-tree relaxation", European Journal of Operational Research 9 (1982) 83–89, doi:10.1016/0377-2217(82)90015-7). Multipliers are whole
//! units: any of them bound, so only how fast the bound grows is rounded, not the bound.

use super::graph::Edge;
use super::one_tree::{Among, OneTree};
use super::whole::MOST_UNITS;

/// How long multipliers are changed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rounds {
    /// 1-trees at most.
    pub(super) most: u64,
    /// λ at first …
    pub(super) lambda: f64,
    /// … and half as large after so many without a better bound.
    pub(super) patience: u64,
}

/// What is known of the cycles that are left.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Found {
    /// None is cheap enough.
    Nothing,
    /// The edges of the cheapest, which is cheap enough.
    Cycle(Vec<(u32, u32)>),
    /// None costs less than this.
    Bound(i64),
}

/// Changes multipliers so that the bound grows, until it is above `most` units or a 1-tree is a cycle; then they are those of the best bound, and
/// `tree` is its 1-tree. `trees` counts.
pub(super) fn ascend(
    mut among: impl FnMut(&[i64], &mut OneTree) -> bool,
    (multipliers, tree, trees): (&mut Vec<i64>, &mut OneTree, &mut u64),
    most: i64,
    rounds: Rounds,
) -> Found {
    let mut best: Option<(i64, Vec<i64>)> = None;
    let (mut lambda, mut since, mut before) = (rounds.lambda, 0, Vec::new());
    for _ in 0..rounds.most.max(1) {
        *trees += 1;
        if !among(multipliers, tree) || tree.bound > most {
            return Found::Nothing;
        }
        if tree.is_cycle() {
            return Found::Cycle(tree.edges.clone());
        }
        since += 1;
        if best.as_ref().is_none_or(|best| tree.bound > best.0) {
            best = Some((tree.bound, multipliers.clone()));
            since = 0;
        } else if since >= rounds.patience {
            (lambda, since) = (lambda / 2.0, 0);
        }
        step(multipliers, tree, &mut before, lambda * (most + 1 - tree.bound) as f64);
    }
    let Some((bound, at)) = best else { return Found::Nothing };
    *multipliers = at;
    *trees += 1;
    among(multipliers, tree);
    Found::Bound(bound)
}

/// One step of the multipliers, of this length times the square of the direction.
fn step(multipliers: &mut [i64], tree: &OneTree, before: &mut Vec<i32>, length: f64) {
    let over: Vec<i32> = tree.degrees.iter().map(|degree| degree - 2).collect();
    let square = f64::from(over.iter().map(|over| over * over).sum::<i32>());
    let last = if before.is_empty() { &over } else { &*before };
    for ((multiplier, &now), &last) in multipliers.iter_mut().zip(&over).zip(last) {
        let direction = 0.7 * f64::from(now) + 0.3 * f64::from(last);
        *multiplier = (*multiplier + (length / square * direction) as i64).clamp(-MOST_UNITS, MOST_UNITS);
    }
    *before = over;
}

/// The edges that no cycle of at most `most` units can have: what is left of a 1-tree's bound is too much with them in place of the dearest edge
/// that they can replace.
pub(super) fn too_dear(tree: &OneTree, among: &Among, most: i64) -> Vec<(u32, u32)> {
    let size = among.graph.size() as u32;
    let replaced =
        |edge: &(u32, u32)| if among.edge(edge.0, edge.1) == Edge::Required { i64::MIN / 2 } else { among.cost(edge.0, edge.1) };
    let is_too_dear = |a: u32, b: u32, replaced: i64| tree.bound + among.cost(a, b) - replaced > most;
    let (spanning, at_zero) = tree.edges.split_at(tree.edges.len() - 2);
    let last = at_zero.iter().map(replaced).max().unwrap_or(i64::MIN / 2);
    let is_left = |a: u32, b: u32| among.edge(a, b) == Edge::Free;
    let mut found: Vec<_> = (1..size).filter(|&b| is_left(0, b) && is_too_dear(0, b, last)).map(|b| (0, b)).collect();
    for a in 1..size {
        let dearest = dearest_between(a, spanning, size, replaced);
        found.extend((a + 1..size).filter(|&b| is_left(a, b) && is_too_dear(a, b, dearest[b as usize])).map(|b| (a, b)));
    }
    found
}

/// The dearest edge of the tree between a vertex and each other.
fn dearest_between(a: u32, spanning: &[(u32, u32)], size: u32, cost: impl Fn(&(u32, u32)) -> i64) -> Vec<i64> {
    let mut dearest = vec![None; size as usize];
    dearest[a as usize] = Some(i64::MIN / 2);
    // Edges were taken one by one from the tree that stood: those before `a` came in lead back to the first vertex, all others onwards.
    let lead = |edges: &mut dyn Iterator<Item = &(u32, u32)>, dearest: &mut Vec<Option<i64>>| {
        for edge in edges {
            for (from, to) in [(edge.0, edge.1), (edge.1, edge.0)] {
                if let (Some(so_far), None) = (dearest[from as usize], dearest[to as usize]) {
                    dearest[to as usize] = Some(so_far.max(cost(edge)));
                }
            }
        }
    };
    lead(&mut spanning.iter().rev(), &mut dearest);
    lead(&mut spanning.iter(), &mut dearest);
    dearest.into_iter().map(|cost| cost.unwrap_or(i64::MAX / 2)).collect()
}
