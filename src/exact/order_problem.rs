//! An order problem: places that are to be visited once each, and what the way between any two of them costs.

use super::order::{Costs, MAX_ORDERED, OrderSearch, Shape, held_karp};
use crate::digest::Digest;

/// Most places of a problem: costs, trails and weights are n² numbers each, 8 MB for 1000 places.
pub const MAX_PLACES: usize = 1000;

/// Places and costs. The first place is where every tour begins.
#[derive(Debug, Clone, PartialEq)]
pub struct OrderProblem {
    /// What it is called.
    pub name: String,
    /// What its file says of it; may be empty.
    pub comment: String,
    /// How its file gives costs, e.g. `EUC_2D`.
    pub weight_type: String,
    /// Where to draw each place: x to the right, y upwards, in no particular unit. None where nothing tells.
    pub places: Option<Vec<[f64; 2]>>,
    /// From each place to each other, at least 0.
    pub costs: Costs,
    /// Whether a tour returns to the first place.
    pub shape: Shape,
}

/// An order of all places but the first, counted from 0 without it, and what it costs.
#[derive(Debug, Clone, PartialEq)]
pub struct Proven {
    /// The best order.
    pub order: Vec<u32>,
    /// Its cost.
    pub cost: f64,
}

impl OrderProblem {
    /// How many places there are.
    pub fn len(&self) -> usize {
        self.costs.nodes()
    }

    /// Whether there is no place at all; a problem that was read has two or more.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// What an order costs, with the way back where the tour is closed.
    pub fn cost(&self, order: &[u32]) -> f64 {
        self.costs.total(order, self.shape)
    }

    /// The best order by Held and Karp (see [`held_karp`]); none beyond [`MAX_ORDERED`] places and the first.
    pub fn prove(&self) -> Option<Proven> {
        let order = held_karp(&self.costs, self.shape)?;
        Some(Proven { cost: self.cost(&order), order })
    }

    /// Why [`OrderProblem::prove`] gives nothing; none where it gives an order.
    pub fn unproven_because(&self) -> Option<String> {
        let most = MAX_ORDERED + 1;
        (self.len() > most).then(|| format!("Held and Karp prove orders of up to {most} places; this problem has {}", self.len()))
    }

    /// A search for a better order than `known` and for a proof; none where dynamic programming proves the best ([`OrderProblem::prove`]).
    pub fn search(&self, known: &[u32]) -> Option<OrderSearch> {
        self.unproven_because()?;
        OrderSearch::new(&self.costs, self.shape, known)
    }

    /// How many 1-trees such a search may find unless told otherwise, seconds of work at most: fewer, the more places there are.
    pub fn usual_trees(&self) -> u64 {
        const WORK: u64 = 200_000_000;
        (WORK / (self.len() as u64).pow(2).max(1)).clamp(200, 20_000)
    }

    /// Over all costs: problems with equal digests have equal tours.
    pub fn digest(&self) -> Digest {
        let mut digest = Digest::default();
        let n = self.len();
        digest.u32(n as u32);
        (0..n * n).for_each(|k| digest.f64(self.costs.get(k / n, k % n)));
        digest
    }

    /// The length of the best closed tour, where a publication lists it for this very problem.
    pub fn listed_optimum(&self) -> Option<f64> {
        let is_this = |listed: &&Listed| {
            let Listed { name, places, weight_type, digest, .. } = listed;
            *name == self.name && *places == self.len() && *weight_type == self.weight_type && *digest == self.digest().hex()
        };
        let listed = LISTED.iter().find(is_this).filter(|_| self.shape == Shape::Closed);
        listed.map(|listed| listed.optimum)
    }
}

/// An instance whose optimum is listed. `tests/tsplib.rs` holds each against a tour of that length, or a proof.
struct Listed {
    name: &'static str,
    places: usize,
    weight_type: &'static str,
    /// Of its costs: another problem of the same name is not meant.
    digest: &'static str,
    optimum: f64,
}

/// Where [`LISTED`] is from.
pub const LISTED_SOURCE: &str = "Reinelt, TSPLIB: optimal solutions for symmetric TSPs";

const fn listed(name: &'static str, places: usize, weight_type: &'static str, digest: &'static str, optimum: f64) -> Listed {
    Listed { name, places, weight_type, digest, optimum }
}

const LISTED: [Listed; 6] = [
    listed("burma14", 14, "GEO", "bfe93c994d16a313", 3323.0),
    listed("ulysses16", 16, "GEO", "7f3485952261de5d", 6859.0),
    listed("att48", 48, "ATT", "552fc20be2f8a9fd", 10628.0),
    listed("eil51", 51, "EUC_2D", "91028711666105b6", 426.0),
    listed("berlin52", 52, "EUC_2D", "25a404ae191c3839", 7542.0),
    listed("kroA100", 100, "EUC_2D", "197c4b14d5f2de31", 21282.0),
];
